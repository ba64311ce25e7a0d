"""Compiled programs: what is told of a topic's frequency and of the age of its stamps."""

from __future__ import annotations

import rclpy
from diagnostic_msgs.msg import DiagnosticArray
from sensor_msgs.msg import Range

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program


def test_a_topic_is_told_to_be_too_slow_and_too_late(session, build):
    rclpy.init()
    node = rclpy.create_node("watch")
    told, ranges = [], []
    node.create_subscription(DiagnosticArray, "/diagnostics", told.append, 20)
    node.create_subscription(Range, "/range", ranges.append, 20)
    process = session.launch(make_process(session, build("watched", program("watched.cpp")), name="watched"))
    end = session.clock.now() + 4_500_000_000
    while session.clock.now() < end:
        rclpy.spin_once(node, timeout_sec=0.1)
    process.interrupt()
    assert process.wait(5.0) == 0, process.output
    assert len(ranges) > 40

    reports = [{status.name: status for status in message.status} for message in told if len(message.status) == 3]
    assert [set(report) for report in reports[:1]] == [
        {"sonar: ticks topic status", "sonar: /range topic status", "sonar: Heartbeat"}
    ]
    second, last = reports[1], reports[-1]
    ticks = second["sonar: ticks topic status"]
    assert (ticks.level, ticks.message, ticks.hardware_id) == (b"\x00", "", "sonar 1")  # the first of two good states, empty
    told_of = {value.key: value.value for value in ticks.values}
    assert told_of["Actual frequency (Hz)"].startswith("10.") or told_of["Actual frequency (Hz)"].startswith("9.")
    assert told_of["Minimum acceptable frequency (Hz)"] == "8.100000"
    assert told_of["Maximum acceptable frequency (Hz)"] == "12.100000"
    slow = second["sonar: /range topic status"]
    assert (slow.level, slow.message) == (b"\x01", "Frequency too low.")
    assert {value.key: value.value for value in slow.values}["Target frequency (Hz)"] == "11.000000"
    late = last["sonar: /range topic status"]
    assert (late.level, late.message) == (b"\x02", "Frequency too low.; Timestamps too far in past seen.")
    assert {value.key: value.value for value in late.values}["Late diagnostic update count:"] == "2"
    assert last["sonar: Heartbeat"].message == "Alive"
