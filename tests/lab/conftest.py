"""What most tests of the lab stand on: a session on the virtual clock, without a panel of the test before."""

import pytest

from coursekit.lab.panel import end_panels
from coursekit.lab.panel_node import HiddenNode
from coursekit.processes.session import Session


@pytest.fixture
def session():
    """A session in which time passes only while all wait; its panels end with it."""
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session
        end_panels()


@pytest.fixture
def talker(session):
    """A node that publishes what panels show."""
    hidden = HiddenNode("talker")
    yield hidden.node
    hidden.close()


@pytest.fixture
def page(session, monkeypatch):
    """page(panel) gives what does as a page of the panel does; its `heard` are the messages that the page got."""

    def open_(panel):
        def does(type_, **more):
            panel._hear(panel, {"type": type_, **more}, [])

        does.heard = []
        monkeypatch.setattr(panel, "send", lambda message, buffers=None: does.heard.append(message))
        return does

    return open_
