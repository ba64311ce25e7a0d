"""A session that ends in the moment in which a terminal asks it loses no command."""

import os
import socket
import threading

import pytest

from coursekit.cli import endpoint, session_client
from coursekit.systems import user_socket


class Sessions:
    """Answers one connection after the other: "gone" hangs up, "late" reads and hangs up, "taken" carries it out."""

    def __init__(self, *ways):
        self.ways, self.asked = list(ways), 0

    def connect(self, _domain=0):
        theirs, ours = socket.socketpair()
        way = self.ways[min(self.asked, len(self.ways) - 1)]
        self.asked += 1
        if way == "gone":
            theirs.close()
        else:
            threading.Thread(target=self._answer, args=(theirs, way), daemon=True).start()
        return ours

    def _answer(self, theirs, way):
        with theirs, theirs.makefile("rw", encoding="utf-8") as lines:
            lines.readline()
            if way == "taken":
                lines.write('{"session": ""}\n{"stdout": "done\\n"}\n{"exit": 4}\n')
                lines.flush()


@pytest.fixture
def asked(monkeypatch):
    """asked('gone', 'taken') has sessions answer so."""
    reading, writing = os.pipe()
    monkeypatch.setattr("sys.stdin", os.fdopen(reading))

    def answer(*ways):
        sessions = Sessions(*ways)
        monkeypatch.setattr(endpoint, "connect", sessions.connect)
        monkeypatch.setattr(endpoint, "token", lambda _domain: "")
        return sessions

    yield answer
    os.close(writing)


@pytest.mark.parametrize("before", [(), ("gone",), ("late",), ("late", "gone")])
def test_the_next_session_carries_it_out(asked, before, capsys):
    sessions = asked(*before, "taken")
    assert session_client.attach(["node", "list"]) == 4
    assert capsys.readouterr().out == "done\n" and sessions.asked == len(before) + 1


def test_when_none_takes_it_that_is_an_error_and_a_script_runs_by_itself(asked, tmp_path):
    asked("gone")
    with pytest.raises(endpoint.NoSession, match="ended before"):
        session_client.attach(["node", "list"])
    assert session_client.attach_script(tmp_path / "node.py", []) is None


def test_where_a_session_has_gone_its_token_is_gone_and_that_is_no_session(monkeypatch, tmp_path):
    monkeypatch.setattr(user_socket, "HAS_UNIX", False)
    monkeypatch.setattr(endpoint, "folder", lambda: tmp_path)
    with pytest.raises(endpoint.NoSession):
        endpoint.token(7)
    (tmp_path / "session-7").write_text("", encoding="utf-8")
    with pytest.raises(endpoint.NoSession):
        endpoint.token(7)
    (tmp_path / "session-7").write_text('{"port": 1, "token": "secret"}', encoding="utf-8")
    assert endpoint.token(7) == "secret"
