"""Before a command looks at the graph, programs that have just been started get the time to enter it."""

from types import SimpleNamespace

import pytest
from std_msgs.msg import String

from coursekit.cli import start_wait
from coursekit.core.qos import Qos
from coursekit.processes.process import Process
from coursekit.processes.session import Session


class Clock:
    """Time that passes by sleeping; `plan` says what happens at which moment [s]."""

    virtual = False

    def __init__(self, plan):
        self.seconds = 0.0
        self.plan = dict(plan)

    def steady(self):
        return round(self.seconds * 1e9)

    def sleep(self, seconds):
        self.seconds += seconds
        for moment in [planned for planned in self.plan if planned <= self.seconds]:
            self.plan.pop(moment)()


@pytest.fixture
def young(monkeypatch):
    """Starts a program in name only; gives the time that a command waits for it."""

    def settle(happens=None, name="talker"):
        session = Session()
        process = Process(session, lambda: None, name=name)
        process.started = 0
        clock = Clock({moment: lambda act=act: act(session, process) for moment, act in (happens or {}).items()})
        graphs = session.graphs
        stand_in = SimpleNamespace(clock=clock, processes=[process], graphs=graphs)
        monkeypatch.setattr(start_wait, "current", lambda: stand_in)
        start_wait.let_settle()
        return clock.seconds

    return settle


def enter(session, process):
    session.graph(0).add_node("talker", "/", process).publisher("/chatter", String, Qos())


def spin(session, process):
    node = session.graph(0).add_node("talker", "/", process)
    node.subscription("/chatter", String, Qos()).attach(SimpleNamespace(put=lambda item: None), None)


def end(_session, process):
    process.exit_code = 0


def test_it_waits_until_the_node_is_spun(young):
    assert young({0.3: spin}) == pytest.approx(0.3, abs=0.02)


def test_a_node_that_hears_nothing_is_there_soon(young):
    assert young({0.1: enter}) == pytest.approx(start_wait.CHILDHOOD_SECONDS, abs=0.02)


def test_it_does_not_wait_for_what_has_ended_nor_for_other_commands(young):
    assert young({0.2: end}) == pytest.approx(0.2, abs=0.02)
    assert young(name="ros2") == 0.0


def test_it_does_not_wait_for_ever(young):
    assert young() == pytest.approx(start_wait.YOUTH_SECONDS, abs=0.02)
