"""A session server ends the command of a terminal that is gone, however it went."""

import json
import os
import socket
import time

import pytest

from coursekit.cli import endpoint, session_client
from coursekit.systems.waiting import lines
from tests.kernels import surround

DOMAIN = 78


@pytest.fixture
def session(monkeypatch, tmp_path):
    """A session of its own, as the first command of a terminal starts it."""
    surround(monkeypatch, tmp_path, DOMAIN)
    monkeypatch.setenv("PYTHONUNBUFFERED", "1")
    with session_client.connect_or_start():
        yield


def talk():
    """A terminal in which the talker runs and has said something that was not read yet."""
    terminal = endpoint.connect(DOMAIN)
    wish = {"token": endpoint.token(DOMAIN), "env": dict(os.environ), "argv": ["run", "demo_nodes_py", "talker"]}
    terminal.sendall(json.dumps(wish).encode() + b"\n")
    for said in lines(terminal):
        if "Publishing" in said:
            break
    terminal.recv(1, socket.MSG_PEEK)
    return terminal


def nodes_without_the_talker():
    """The nodes, as soon as the talker is not among them."""
    give_up = time.monotonic() + 30
    while "/talker" in (nodes := session_client.answer(["node", "list"])) and time.monotonic() < give_up:
        pass
    return nodes


def test_a_terminal_that_dies_with_words_unread_takes_its_command_with_it(session):
    terminal = talk()
    assert "/talker" in session_client.answer(["node", "list"])
    terminal.close()  # the other side is told by an error, not by an end of the lines
    assert nodes_without_the_talker() == []


def test_a_terminal_that_speaks_nonsense_is_hung_up_on_and_takes_its_command_with_it(session):
    with talk() as terminal:
        terminal.sendall(b"nonsense\n")
        assert nodes_without_the_talker() == []
