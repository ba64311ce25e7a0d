"""Addresses of sessions: many terminals and the session itself may put the domain's address in its place at once."""

import os
import threading

import pytest

from coursekit.cli import endpoint

DOMAIN = 79


@pytest.fixture
def server(monkeypatch, tmp_path):
    """A session that listens, and whose address for the domain's terminals has gone."""
    monkeypatch.setenv("COURSEKIT_RUNTIME_DIR", str(tmp_path))
    listening = endpoint.listen(DOMAIN)
    endpoint.address(DOMAIN).unlink()
    yield listening
    endpoint.close(listening, DOMAIN)


def test_terminals_that_come_at_once_all_find_the_session(server):
    found, begin = [], threading.Barrier(8)

    def connect():
        begin.wait()
        endpoint.connect(DOMAIN).close()
        found.append(True)

    threads = [threading.Thread(target=connect) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 8 and endpoint.has_terminals(DOMAIN)


def test_an_address_that_cannot_be_put_in_place_loses_no_connection(server, monkeypatch):
    def in_use(*_):
        raise PermissionError("another program has it open")

    monkeypatch.setattr(endpoint, "put_in_place", in_use)
    endpoint.connect(DOMAIN).close()
    assert not endpoint.has_terminals(DOMAIN)


def test_nothing_is_left_beside_the_addresses(server):
    endpoint.connect(DOMAIN).close()
    assert sorted(os.listdir(endpoint.folder())) == [f"session-{DOMAIN}", f"session-{DOMAIN}-{os.getpid()}"]
