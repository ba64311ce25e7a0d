"""diagnostic_updater on the virtual clock: what is told on /diagnostics, and when."""

import pytest
import rclpy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from diagnostic_updater import (
    CompositeDiagnosticTask,
    DiagnosedPublisher,
    DiagnosticStatusWrapper,
    FrequencyStatusParam,
    FunctionDiagnosticTask,
    Heartbeat,
    TimeStampStatusParam,
    Updater,
)
from geometry_msgs.msg import PoseStamped

from coursekit.processes.session import Session

OK, WARN, ERROR = DiagnosticStatus.OK, DiagnosticStatus.WARN, DiagnosticStatus.ERROR


class Stage:
    def __init__(self, session):
        self.session = session
        rclpy.init()
        self.node = rclpy.create_node("device")
        self.told: list[DiagnosticArray] = []
        self.node.create_subscription(DiagnosticArray, "/diagnostics", self.told.append, 50)
        self.updater = Updater(self.node)
        self.updater.setHardwareID("none")

    def spin(self, seconds):
        until = self.session.clock.steady() + round(seconds * 1e9)
        while (left := until - self.session.clock.steady()) > 0:
            rclpy.spin_once(self.node, timeout_sec=left * 1e-9)


@pytest.fixture
def stage():
    with Session(virtual=True).use() as session:
        yield Stage(session)
        rclpy.shutdown()


def status(level, message):
    new_status = DiagnosticStatusWrapper()
    new_status.summary(level, message)
    return new_status


@pytest.mark.parametrize(
    "first, second, merged",
    [((OK, "a"), (OK, "b"), (OK, "a; b")), ((OK, "a"), (ERROR, "b"), (ERROR, "b")), ((WARN, "a"), (OK, "b"), (WARN, "a")),
     ((WARN, "a"), (ERROR, "b"), (ERROR, "a; b"))],
)  # fmt: skip
def test_of_two_the_worse_counts_and_equals_are_both_told(first, second, merged):
    merged_status = status(*first)
    merged_status.mergeSummary(status(*second))
    assert (merged_status.level, merged_status.message) == merged


def test_tasks_are_asked_once_a_second_under_the_nodes_name(stage):
    def hot(stat):
        stat.summary(WARN, "hot")
        stat.add("temperature", 81.5)
        return stat

    stage.updater.add("Engine", hot)
    stage.updater.add(Heartbeat())
    stage.spin(3.05)
    starting, periodic = stage.told[:2], stage.told[2:]
    assert [array.status[0].message for array in starting] == ["Node starting up"] * 2 and len(periodic) == 3
    engine, alive = periodic[0].status
    assert (engine.name, engine.level, engine.message, engine.hardware_id) == ("device: Engine", WARN, "hot", "none")
    assert [(value.key, value.value) for value in engine.values] == [("temperature", "81.5")]
    assert (alive.name, alive.message) == ("device: Heartbeat", "Alive")


def test_a_task_without_words_and_a_task_that_was_removed(stage):
    stage.updater.add("silent", lambda stat: stat)
    stage.updater.add("gone", lambda stat: stat)
    assert stage.updater.removeByName("gone") and not stage.updater.removeByName("gone")
    stage.told.clear()
    stage.spin(1.05)
    last = stage.told[-1].status
    assert [(device_status.name, device_status.message) for device_status in last] == [
        ("device: silent", "No message was set")
    ]


def test_a_composite_task_is_as_ill_as_its_worst(stage):
    together = CompositeDiagnosticTask("both")
    for part in (status(OK, "fine"), status(ERROR, "broken")):
        together.addTask(FunctionDiagnosticTask(part.message, lambda stat, part=part: part))
    stage.updater.add(together)
    stage.spin(1.05)
    assert (stage.told[-1].status[0].level, stage.told[-1].status[0].message) == (ERROR, "broken")


def test_the_period_can_be_changed_and_all_can_be_told_at_once(stage):
    stage.updater.add(Heartbeat())
    stage.updater.period = 0.1
    stage.told.clear()
    stage.spin(2.0)
    assert 15 <= len(stage.told) <= 21
    stage.updater.broadcast(WARN, "going down")
    stage.spin(0.01)
    assert any(array.status[0].message == "going down" for array in stage.told)


@pytest.mark.parametrize("gap, expected", [(0.1, "Desired frequency met"), (0.5, "too low."), (0.02, "too high.")])
def test_a_watched_publisher_tells_whether_it_keeps_its_frequency(stage, gap, expected):
    bounds = FrequencyStatusParam({"min": 9.0, "max": 11.0}, 0.1, 2)
    watched = DiagnosedPublisher(
        stage.node.create_publisher(PoseStamped, "pose", 10), stage.updater, bounds, TimeStampStatusParam()
    )
    for _ in range(round(4.0 / gap)):
        msg = PoseStamped()
        msg.header.stamp = stage.node.get_clock().now().to_msg()
        watched.publish(msg)
        stage.spin(gap)
    last = stage.told[-1].status[0]
    assert last.name == "device: /pose topic status" and expected in last.message


def test_stamps_of_the_past_are_told(stage):
    bounds, ages = FrequencyStatusParam({"min": 0.0, "max": 1e6}), TimeStampStatusParam(-1, 5)
    watched = DiagnosedPublisher(stage.node.create_publisher(PoseStamped, "pose", 10), stage.updater, bounds, ages)
    msg = PoseStamped()
    msg.header.stamp.sec = 1
    watched.publish(msg)
    stage.spin(1.05)
    assert "Timestamps too far in past seen." in stage.told[-1].status[0].message
