"""The desk without a browser: what is put on it, and what is refused."""

from importlib import import_module

import pytest

from coursekit.lab.desk import Desk, desk
from coursekit.lab.docking import View
from coursekit.lab.errors import BadArgument
from coursekit.lab.panel import end_panels
from coursekit.lab.teleop_pad import pad
from coursekit.lab.viewer import viewer
from coursekit.processes.session import Session


@pytest.fixture(autouse=True)
def session(monkeypatch):
    monkeypatch.setattr(import_module("coursekit.lab.desk"), "_desks", [])
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session
        end_panels()


def test_it_says_what_stands_on_it():
    view, drive = viewer(), pad()
    assert repr(desk(view, drive)).splitlines()[:2] == ["On the desk:", "viewer: fixed frame map"]
    assert desk(drive).panels == [drive], "what is put there next takes the place of the rest"
    shown = desk(drive, view)._repr_mimebundle_()
    assert shown["text/plain"] == repr(desk(drive, view)) and shown["image/png"], "a page that is only read has a still"


def test_a_notebook_has_one_desk():
    assert desk(pad()) is desk(viewer())


def test_without_names_all_open_panels_are_put_there():
    view = viewer()
    assert desk().panels == [view]
    end_panels()
    assert "Nothing is on the desk" in repr(desk())


def test_a_panel_that_has_ended_makes_room_for_the_next_one(monkeypatch):
    monkeypatch.setattr(Desk, "_dock", lambda desk: None)
    drive, view, again = pad(), viewer(), viewer()
    View.put_on_desk(drive)
    View.put_on_desk(view)
    view._hear(view, {"type": "ready"}, [])  # a page shows it, and keeps a still of it
    view.end("It ended with reset().")
    View.put_on_desk(again)
    assert import_module("coursekit.lab.desk")._desks[0].panels == [drive, again]


def test_what_is_no_panel_is_refused():
    with pytest.raises(BadArgument, match=r"int cannot be docked. Panels can: viewer\(\), pad\(\)"):
        desk(7)
