"""What programs share is imported to its end, whatever happens to the program that imports it first."""

import importlib
import sys
import threading
import types

import pytest

from coursekit.processes import interrupting
from coursekit.processes.interrupting import raise_in_thread
from coursekit.processes.session import Session
from coursekit.systems import library_files

LIBRARY = """
import slow_library.part
from slow_library_events import begun, goes_on

begun.set()
while not goes_on():
    pass
"""


class Stop(BaseException):
    pass


@pytest.fixture
def events(tmp_path, monkeypatch):
    """A library whose import lasts until it is told to go on."""
    folder = tmp_path / "slow_library"
    folder.mkdir()
    (folder / "__init__.py").write_text(LIBRARY, encoding="utf-8")
    (folder / "part.py").write_text("", encoding="utf-8")
    told = types.ModuleType("slow_library_events")
    told.begun, told.go_on = threading.Event(), threading.Event()
    told.goes_on = told.go_on.is_set
    monkeypatch.setitem(sys.modules, "slow_library_events", told)
    monkeypatch.syspath_prepend(str(tmp_path))
    yield told
    told.go_on.set()
    for name in [name for name in sys.modules if name.partition(".")[0] == "slow_library"]:
        del sys.modules[name]


@pytest.fixture
def shared(tmp_path, monkeypatch):
    """As if the library were installed."""
    monkeypatch.setattr(library_files, "FOLDERS", (*library_files.FOLDERS, library_files._in_one_form(str(tmp_path))))


def started(target):
    thread = threading.Thread(target=target)
    thread.start()
    return thread


@pytest.mark.usefixtures("shared")
def test_an_exception_waits_for_the_end_of_a_library_s_import(events):
    thread = started(lambda: importlib.import_module("slow_library"))
    events.begun.wait()
    assert not raise_in_thread(thread.ident, Stop)
    events.go_on.set()
    thread.join()
    assert sys.modules["slow_library"].part is sys.modules["slow_library.part"]


def test_the_import_of_a_program_s_own_module_is_interrupted(events):
    def main():
        with pytest.raises(Stop):
            importlib.import_module("slow_library")

    thread = started(main)
    events.begun.wait()
    assert raise_in_thread(thread.ident, Stop)
    thread.join()
    assert "slow_library" not in sys.modules


@pytest.mark.usefixtures("shared")
@pytest.mark.parametrize("number", [2, 9, 15])
def test_a_program_ends_after_the_import_in_which_the_signal_came(events, number):
    with Session().use() as session:
        process = session.start(lambda: importlib.import_module("slow_library"), name="importer")
        events.begun.wait()
        process.send_signal(number)
        events.go_on.set()
        process.wait(60)
        assert not process.abandoned
    assert sys.modules["slow_library"].part is sys.modules["slow_library.part"]


@pytest.mark.usefixtures("shared")
def test_an_import_that_never_ends_does_not_keep_a_killed_program(events, monkeypatch):
    monkeypatch.setattr(interrupting, "LONGEST_IMPORT_NS", 0)
    with Session().use() as session:
        process = session.start(lambda: importlib.import_module("slow_library"), name="importer")
        events.begun.wait()
        process.kill()
        process.wait(60)
        assert process.abandoned
        events.go_on.set()
