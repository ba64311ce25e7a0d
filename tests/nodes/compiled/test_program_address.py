"""Who may connect in a compiled program's name: on a port, only who knows the token."""

import socket
import threading

import pytest

from coursekit.nodes.compiled.program_address import LoopbackListener, UnixListener, open_listener
from coursekit.systems import operating_system
from tests.needs import posix


@pytest.fixture
def listener():
    loopback_listener = LoopbackListener()
    yield loopback_listener
    loopback_listener.close()


def connect(listener, said):
    """A connection to a port that says this first, and no more."""
    connection = socket.create_connection(listener.listening.getsockname(), timeout=10)
    connection.sendall(said)
    connection.shutdown(socket.SHUT_WR)
    return connection


def test_only_who_says_the_token_comes_in(listener):
    port, token = listener.address.split(":")
    assert listener.listening.getsockname() == ("127.0.0.1", int(port)) and len(token) == 32
    strangers = [connect(listener, said) for said in (b"", b"M", b"x" * 32, token[:-1].encode())]
    friend = connect(listener, f"{token}M".encode())
    with listener.accept() as accepted, friend:
        assert accepted.recv(10) == b"M"  # the strangers came before, and not in
    for stranger in strangers:
        with stranger:
            assert stranger.recv(1) == b""


def test_listeners_have_tokens_of_their_own(listener):
    other = LoopbackListener()
    assert other.address.split(":")[1] != listener.address.split(":")[1]
    other.close()


@pytest.mark.parametrize(
    "kind", [LoopbackListener, pytest.param(UnixListener, marks=posix("there are no sockets of files"))]
)
def test_who_waits_at_a_listener_that_is_closed_hears_of_it(kind):
    closing, ended = kind(), threading.Event()

    def wait():
        with pytest.raises(OSError):
            closing.accept()
        ended.set()

    threading.Thread(target=wait, daemon=True).start()
    closing.close()
    assert ended.wait(20)


def test_windows_has_ports(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    listener = open_listener()
    assert isinstance(listener, LoopbackListener)
    listener.close()
