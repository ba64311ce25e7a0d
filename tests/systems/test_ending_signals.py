"""What ends a command: Ctrl-C and `kill`, and Ctrl-Break where there is one."""

import signal

from coursekit.systems.ending_signals import endings


def test_ctrl_break_means_ctrl_c_where_there_is_one(monkeypatch):
    monkeypatch.delattr(signal, "SIGBREAK", raising=False)
    assert set(endings()) == {signal.SIGINT, signal.SIGTERM}
    monkeypatch.setattr(signal, "SIGBREAK", 21, raising=False)
    assert endings()[21] == signal.SIGINT
