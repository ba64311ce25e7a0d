"""The log console counts, filters and pauses."""

import pytest

from coursekit.lab.log_console import LogConsole
from tests.lab.panel_robot import heard_by_browser, robot_running, says


@pytest.fixture
def session():
    with robot_running() as virtual_session:
        yield virtual_session


def test_the_log_counts_levels_and_filters(session):
    console = LogConsole()
    session.clock.sleep(1.6)
    assert console.text().splitlines()[0] == "log: 3 INFO, 1 WARN"
    console.filter(level="WARN")
    assert console.lines() == ["[WARN] [robot]: two is enough"]
    console.filter(level="DEBUG", text="SENT 3")
    assert console.lines() == ["[INFO] [robot]: sent 3"]
    console.filter(text="", node="nobody")
    assert console.lines() == []


def test_a_paused_log_stands_still_but_forgets_nothing(session):
    console = LogConsole()
    session.clock.sleep(0.6)
    console.pause()
    session.clock.sleep(2.0)
    assert len(console.lines()) == 1
    console.pause(False)
    assert len(console.lines()) > 4


def test_a_late_log_is_in_the_order_of_time(session):
    session.clock.sleep(2.0)
    assert [line.rpartition(" ")[2] for line in LogConsole().lines()] == []
    console = LogConsole()
    session.clock.sleep(0.1)
    assert console.lines()[0].endswith("sent 1")


def test_the_log_is_filtered_from_the_browser(session, monkeypatch):
    console = LogConsole()
    session.clock.sleep(1.6)
    sent = heard_by_browser(console, monkeypatch)
    says(console, type="ready")
    says(console, type="filter", level="WARN")
    assert [len(message["lines"]) for message in sent] == [4, 1]
    assert sent[1]["counts"]["INFO"] == 3 and sent[1]["lines"][0]["time"] == "22:13:21.000"


def test_a_level_that_does_not_exist_names_those_that_do(session):
    with pytest.raises(ValueError, match="DEBUG, INFO, WARN"):
        LogConsole("LOUD")
