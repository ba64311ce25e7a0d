"""The message publisher: it publishes what its form says, once or again and again."""

import pytest
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from std_msgs.msg import Float64

from coursekit.lab.panel_node import HiddenNode
from coursekit.lab.publisher_panel import MessagePublisher


@pytest.fixture
def heard(session):
    """What a robot hears on /cmd_vel."""
    rclpy.init()
    node, messages = Node("robot"), []
    node.create_subscription(Twist, "/cmd_vel", messages.append, 10)
    session.spawn(rclpy.spin, node)
    session.clock.sleep(0.1)
    yield messages
    rclpy.shutdown()


def test_a_message_is_published_from_code(session, heard):
    panel = MessagePublisher("cmd_vel")
    panel.publish(linear={"x": 0.5})
    session.clock.sleep(0.1)
    assert [message.linear.x for message in heard] == [0.5]
    assert "publishes on: /cmd_vel\npublished: 1\n    linear:\n      x: 0.5" in panel.text()
    with pytest.raises(ValueError, match="There is no field 'speed'. There are: linear, angular"):
        panel.publish(speed=1.0)
    with pytest.raises(LookupError, match="There is no topic /cmd_val"):
        panel.publish("cmd_val")


def test_it_is_repeated_at_its_rate_until_it_is_stopped(session, heard):
    panel = MessagePublisher("/speed", "std_msgs/msg/Float64")
    panel.repeat(5.0, "/cmd_vel", linear={"x": 0.2})
    session.clock.sleep(1.05)
    panel.publish("/speed", data=1.0)
    session.clock.sleep(1.0)
    panel.stop()
    session.clock.sleep(2.0)
    assert len(heard) == 10 and panel.count == 11
    for rate in (0.0, -1.0, 1e9, float("nan")):
        with pytest.raises(ValueError, match="at most 1000 Hz"):
            panel.repeat(rate)


def test_a_page_chooses_publishes_and_repeats(session, heard, page):
    panel = MessagePublisher("/speed", "std_msgs/msg/Float64")
    does = page(panel)
    does("choose", name="/cmd_vel")
    assert [field["name"] for field in does.heard[-1]["fields"]] == ["linear", "angular"]
    assert does.heard[-1]["topics"] == ["/cmd_vel", "/speed"] and does.heard[-1]["kind"] == "geometry_msgs/msg/Twist"
    does("publish", fields={"linear": {"x": "0.5"}, "angular": {}})
    does("publish", fields={"linear": {"x": "fast"}})
    assert does.heard[-1] == {"type": "refused", "text": "linear.x: 'fast' is not a number"}
    does("repeat", fields={"linear": {"x": "0.1"}}, rate="often")
    assert does.heard[-1]["type"] == "refused"
    does("repeat", fields={"linear": {"x": "0.1"}}, rate="10")
    session.clock.sleep(1.05)
    does("stop")
    session.clock.sleep(1.0)
    assert [message.linear.x for message in heard] == [0.5] + [0.1] * 10


def test_a_topic_of_two_types_has_no_form(session, heard, page):
    wrong = HiddenNode("of_another_process")
    wrong.node.create_publisher(Float64, "/cmd_vel", 10)
    panel = MessagePublisher("/cmd_vel")
    does = page(panel)
    does("ready")
    assert does.heard[-1]["fields"] == [] and "with several types" in does.heard[-1]["kind"]
    wrong.close()


def test_a_topic_that_nobody_has_yet_needs_its_type(session):
    panel, listener = MessagePublisher("/speed", "std_msgs/msg/Float64"), HiddenNode("listener")
    heard = []
    panel.publish(data=2.0)
    listener.node.create_subscription(Float64, "/speed", heard.append, 10)
    session.clock.sleep(0.1)
    panel.publish(data=3.0)
    session.clock.sleep(0.1)
    assert [message.data for message in heard] == [3.0]
    listener.close()


def test_what_it_publishes_on_stays_chosen_when_nobody_hears_it_any_more(session, page):
    rclpy.init()
    node = Node("robot")
    subscription = node.create_subscription(Twist, "/cmd_vel", print, 10)
    node.create_subscription(Float64, "/another", print, 10)
    panel = MessagePublisher("/cmd_vel")
    does = page(panel)
    does("repeat", fields={"linear": {"x": "0.1"}}, rate="5")
    node.destroy_subscription(subscription)
    session.clock.sleep(1.0)
    shown = panel.shown()
    assert (shown["chosen"], shown["topics"], shown["repeats"]) == ("/cmd_vel", ["/another", "/cmd_vel"], True)
    rclpy.shutdown()
