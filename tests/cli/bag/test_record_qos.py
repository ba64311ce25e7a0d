"""`ros2 bag record` hears publishers whatever quality of service they offer."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

from coursekit.processes.session import Session
from tests.bag.made import all_of
from tests.cli.bag.stage import lines, stop

LATCHED = QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL)
LOSSY = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)


def test_it_asks_for_what_the_publishers_offer(session: Session, ros2: Callable[[str], Any], node: Any) -> None:
    map_out, scan = node.create_publisher(String, "map", LATCHED), node.create_publisher(String, "scan", LOSSY)
    map_out.publish(String(data="before the recording"))
    recorder = ros2("bag record /map /scan -o talk")
    session.clock.sleep(0.5)
    scan.publish(String(data="lossy"))
    session.clock.sleep(0.5)
    stop(session, recorder)
    assert {message.topic for message in all_of("talk")} == {"/map", "/scan"}


def test_where_publishers_disagree_it_hears_all_and_says_so(
    session: Session, ros2: Callable[[str], Any], node: Any
) -> None:
    outs = [node.create_publisher(String, "mixed", qos) for qos in (LATCHED, LOSSY)]
    recorder = ros2("bag record /mixed -o talk")
    session.clock.sleep(0.5)
    for out in outs:
        out.publish(String())
    session.clock.sleep(0.5)
    stop(session, recorder)
    assert len(all_of("talk")) == 2
    assert 'on topic "/mixed" are offering RMW_QOS_POLICY_RELIABILITY_RELIABLE. Falling back to' in recorder.output
    assert 'on topic "/mixed" are offering RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL. Falling back' in recorder.output


def test_a_publisher_that_comes_later_and_does_not_match_is_told(
    session: Session, ros2: Callable[[str], Any], node: Any
) -> None:
    node.create_publisher(String, "topic", 10)
    recorder = ros2("bag record -a -o talk")
    session.clock.sleep(0.5)
    node.create_publisher(String, "topic", LOSSY)
    session.clock.sleep(1)
    stop(session, recorder)
    assert recorder.output.count("A new publisher for subscribed topic /topic was found offering") == 1


def test_qos_can_be_overridden(session: Session, ros2: Callable[[str], Any], node: Any) -> None:
    told = "/topic: {reliability: best_effort, history: keep_all, deadline: {sec: 1, nsec: 5}}"
    Path("qos.yaml").write_text(told, encoding="utf-8")
    node.create_publisher(String, "topic", 10)
    recorder = ros2("bag record /topic -o talk --qos-profile-overrides-path qos.yaml")
    session.clock.sleep(0.5)
    (info,) = node.get_subscriptions_info_by_topic("/topic")
    stop(session, recorder)
    assert info.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT
    assert info.qos_profile.deadline.nanoseconds == 1_000_000_005
    assert "[INFO] [rosbag2_recorder]: Overriding subscription profile for /topic" in lines(recorder)
