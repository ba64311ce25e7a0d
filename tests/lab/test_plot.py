"""`plot()`: numbers of topics over time, with the past kept, and those of a bag."""

import json
from base64 import b64decode

import numpy as np
import pytest
import rclpy
from geometry_msgs.msg import Twist
from rclpy.serialization import serialize_message
from std_msgs.msg import Float64

from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.storage import Message
from coursekit.bag.writer import BagWriter, WriteSettings
from coursekit.lab.bundle import forms_of
from coursekit.lab.errors import BadArgument, NotThere
from coursekit.lab.plot_panel import plot


@pytest.fixture
def driver(session):
    """A node that publishes a speed ten times a second."""
    rclpy.init()
    node = rclpy.create_node("driver")
    node.speed, publisher = 0.0, node.create_publisher(Twist, "cmd_vel", 10)

    def tick():
        message = Twist()
        message.linear.x, message.angular.z = node.speed, -node.speed
        node.speed += 0.1
        publisher.publish(message)

    node.create_timer(0.1, tick)
    yield node
    node.destroy_node()
    rclpy.shutdown()


def turn(session, driver, seconds):
    give_up = session.clock.steady() + round(seconds * 1e9)
    while session.clock.steady() < give_up:
        rclpy.spin_once(driver, timeout_sec=0.05)


@pytest.mark.parametrize("path", ["/cmd_vel.linear.x", "cmd_vel/linear/x"])
def test_a_field_s_values_come_with_their_times(session, driver, path):
    panel = plot(path)
    turn(session, driver, 2.05)
    times, values = panel.values(path)
    assert values == pytest.approx(np.arange(len(values)) * 0.1)
    assert np.diff(times) == pytest.approx(0.1, abs=1e-6)
    assert len(values) == 20
    panel.close()


def test_several_fields_in_one_word_are_several_curves_and_are_told_in_text(session, driver):
    panel = plot("/cmd_vel.linear.x", "/cmd_vel.angular.y:z")
    assert str(panel) == "plot /cmd_vel.linear.x /cmd_vel.angular.y /cmd_vel.angular.z: no numbers yet"
    turn(session, driver, 0.55)
    assert str(panel).splitlines() == [
        "/cmd_vel.angular.y: 5 values, 0 to 0, last 0",
        "/cmd_vel.angular.z: 5 values, -0.4 to 0, last -0.4",
        "/cmd_vel.linear.x: 5 values, 0 to 0.4, last 0.4",
    ]
    panel.close()


def test_the_browser_gets_each_point_once_and_all_again_when_it_is_loaded_anew(session, driver):
    panel = plot("/cmd_vel.linear.x")
    turn(session, driver, 0.55)
    assert [value for _, value in panel.shown()["news"]["/cmd_vel.linear.x"]] == pytest.approx([0, 0.1, 0.2, 0.3, 0.4])
    assert panel.shown()["news"]["/cmd_vel.linear.x"] == []
    sent = []
    panel.send = lambda message, *_: sent.append(message)
    panel._hear(panel, {"type": "ready"}, [])
    assert len(sent[-1]["news"]["/cmd_vel.linear.x"]) == 5
    panel.close()


def test_what_is_no_number_can_be_sent(session):
    rclpy.init()
    node = rclpy.create_node("far")
    publisher = node.create_publisher(Float64, "distance", 10)
    panel = plot("/distance.data")
    for value in (1.0, float("inf"), float("nan")):
        publisher.publish(Float64(data=value))
    session.clock.sleep(0.1)
    news = panel.shown()["news"]["/distance.data"]
    assert [value for _, value in news] == [1.0, None, None]
    json.dumps(news, allow_nan=False)
    panel.close()
    rclpy.shutdown()


def test_a_topic_that_is_not_there_is_an_error_with_near_names_and_leaves_nothing(session, driver):
    with pytest.raises(NotThere, match=r"There is no topic /cmd_vle in the graph.*/cmd_vel"):
        plot("/cmd_vle.linear.x")
    assert [node.name for node in session.graph(0).nodes] == ["driver"]
    with pytest.raises(BadArgument, match="Say what to plot"):
        plot()


def test_a_picture_shows_a_window_of_the_time_line(session, driver):
    panel = plot("/cmd_vel.linear.x")
    turn(session, driver, 3.0)
    assert panel.png().startswith(b"\x89PNG")
    assert panel.png(0.0, 1.0) != panel.png(1.0, 3.0)
    panel.close()


@pytest.fixture
def drive(tmp_path):
    """A bag of ten speeds, a tenth of a second apart."""
    writer = BagWriter(WriteSettings(str(tmp_path / "drive")))
    writer.create_topic(TopicMetadata("/cmd_vel", "geometry_msgs/msg/Twist", "cdr"))
    for number in range(10):
        message = Twist()
        message.linear.x = float(number)
        writer.write(Message("/cmd_vel", serialize_message(message), 1_700_000_000_000_000_000 + number * 100_000_000))
    writer.close()
    return tmp_path / "drive"


def test_the_numbers_of_a_bag_are_drawn_from_its_beginning(session, drive):
    panel = plot("/cmd_vel.linear.x", bag=drive)
    times, values = panel.values("/cmd_vel.linear.x")
    assert times == pytest.approx([number * 0.1 for number in range(10)])
    assert values == [float(number) for number in range(10)]
    assert not panel.shown()["live"]
    assert session.graph(0).nodes == []
    panel.close()


def test_a_topic_that_the_bag_lacks_and_a_bag_that_is_not_there_are_told(session, drive):
    with pytest.raises(NotThere, match="no topic that /odom.x begins with. It has: /cmd_vel"):
        plot("/odom.x", bag=drive)
    with pytest.raises(BadArgument, match="cannot be plotted: there is no bag"):
        plot("/odom.x", bag="nowhere")


def test_a_page_without_a_browser_has_a_picture_once_there_is_a_curve(session, driver):
    panel = plot("/cmd_vel.linear.x")
    assert "image/png" not in forms_of(panel._repr_mimebundle_())
    turn(session, driver, 1.0)
    assert b64decode(forms_of(panel._repr_mimebundle_())["image/png"]).startswith(b"\x89PNG")
    panel.close()
