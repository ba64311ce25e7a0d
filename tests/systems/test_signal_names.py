"""Signals that Windows lacks are known all the same: a launch ends what ignores it with SIGKILL."""

import enum
import signal

import pytest

from coursekit.systems import signal_names
from coursekit.systems.signal_names import described, signal_called


@pytest.fixture
def windows(monkeypatch):
    few = enum.IntEnum("Signals", {"SIGINT": 2, "SIGTERM": 15, "SIGBREAK": 21})
    monkeypatch.setattr(signal_names, "_KNOWN", (few, signal_names._Elsewhere))
    monkeypatch.setattr(signal, "strsignal", lambda number: "Interrupt" if number == 2 else None)


def test_sigkill_is_known_on_windows_by_name_and_number(windows):
    assert (signal_called("SIGKILL"), signal_called(9).name) == (9, "SIGKILL")
    assert signal_called("SIGBREAK") == 21
    assert described(9) == "Killed"


def test_a_signal_of_this_system_is_pythons_own():
    assert signal_called("SIGTERM") is signal.SIGTERM
    assert signal_called(2) is signal.SIGINT


@pytest.mark.parametrize(("wrong", "error"), [("SIGNONE", KeyError), (4711, ValueError)])
def test_what_is_no_signal_is_refused_as_python_does(wrong, error):
    with pytest.raises(error):
        signal_called(wrong)
