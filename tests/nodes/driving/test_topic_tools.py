"""topic_tools: messages of any type, handed on."""

import pytest
from geometry_msgs.msg import Quaternion
from sensor_msgs.msg import Imu, LaserScan
from std_msgs.msg import Float64, Header, String
from topic_tools_interfaces.srv import MuxAdd, MuxDelete, MuxList, MuxSelect


def talk(friend, topic, count, gap):
    friend.say(topic, String(data="first"))
    friend.spin(0.5)  # the tool looks for the topic ten times a second
    for number in range(count):
        friend.say(topic, String(data=str(number)))
        friend.spin(gap)


@pytest.mark.parametrize("words, topic", [(["in"], "in_relay"), (["in", "out"], "out")])
def test_relay_hands_all_on(friend, run, words, topic):
    run("topic_tools", "relay", *words)
    heard = friend.hear(String, topic)
    talk(friend, "in", 5, 0.1)
    assert [msg.data for msg in heard] == ["0", "1", "2", "3", "4"]


def test_relay_takes_any_type_and_a_remapped_topic(friend, run):
    run("topic_tools", "relay", "in", "--ros-args", "-r", "in:=scan", "-r", "in_relay:=seen")
    heard = friend.hear(LaserScan, "seen")
    for _ in range(6):
        friend.say("scan", LaserScan(ranges=[1.0, 2.0]))
        friend.spin(0.1)
    assert heard and heard[-1].ranges.tolist() == [1.0, 2.0]


def test_a_lazy_relay_hears_only_while_somebody_listens(friend, run):
    run("topic_tools", "relay", "in", "--ros-args", "-p", "lazy:=true")
    talk(friend, "in", 1, 0.1)
    assert friend.node.count_subscribers("in") == 0
    heard = friend.hear(String, "in_relay")
    talk(friend, "in", 2, 0.1)
    assert [msg.data for msg in heard][-2:] == ["0", "1"]


def test_throttle_lets_so_many_messages_a_second_through(friend, run):
    run("topic_tools", "throttle", "messages", "in", "2.0")
    heard = friend.hear(String, "in_throttle")
    talk(friend, "in", 40, 0.1)
    assert 7 <= len(heard) <= 9


def test_throttle_lets_so_many_bytes_a_second_through(friend, run):
    run("topic_tools", "throttle", "bytes", "in", "100", "1.0", "slow")
    heard = friend.hear(String, "slow")
    talk(friend, "in", 40, 0.1)
    size = 11  # header, length, up to two characters and the end
    assert 4 * 100 / size * 0.6 < len(heard) <= 4 * (100 / size + 2) and len(heard) < 40


def test_drop_drops_x_of_y(friend, run):
    run("topic_tools", "drop", "in", "2", "3")
    heard = friend.hear(String, "in_drop")
    talk(friend, "in", 9, 0.05)
    assert [msg.data for msg in heard] == ["2", "5", "8"]


def test_delay_hands_on_later(friend, run):
    run("topic_tools", "delay", "in", "1.0")
    heard = friend.hear(String, "in_delay")
    talk(friend, "in", 3, 0.1)
    assert not heard
    friend.spin(0.85)
    assert [msg.data for msg in heard] == ["0", "1"]
    friend.spin(0.2)
    assert [msg.data for msg in heard] == ["0", "1", "2"]


def test_mux_hands_the_selected_topic_on(friend, run):
    run("topic_tools", "mux", "out", "a", "b")
    heard, told = friend.hear(String, "out"), friend.hear(String, "/mux/selected")

    def both():
        heard.clear()
        for _ in range(5):
            friend.say("a", String(data="a"))
            friend.say("b", String(data="b"))
            friend.say("c", String(data="c"))
            friend.spin(0.1)
        return {msg.data for msg in heard}

    both()
    assert both() == {"a"}
    answer = friend.ask(MuxSelect, "/mux/select", topic="b")
    assert (answer.prev_topic, answer.success) == ("/a", True) and both() == {"b"}
    assert friend.ask(MuxSelect, "/mux/select", topic="c").success is False
    assert friend.ask(MuxAdd, "/mux/add", topic="c").success is True
    assert friend.ask(MuxList, "/mux/list").topics == ["/a", "/b", "/c"]
    assert friend.ask(MuxDelete, "/mux/delete", topic="b").success is False  # it is selected
    assert friend.ask(MuxSelect, "/mux/select", topic="__none").success is True and both() == set()
    assert told[-1].data == "__none"


@pytest.mark.parametrize("words", ["relay", "throttle", "drop in", "mux out", "throttle messages in fast"])
def test_words_that_cannot_work_are_told(run, words):
    process = run("topic_tools", *words.split())
    assert process.wait(2.0) == 1 and process.output.strip()


NORM = "std_msgs.msg.Float64(data=numpy.linalg.norm([m.x, m.y, m.z, m.w]))"


def test_transform_publishes_the_value_of_an_expression(friend, run):
    friend.say("imu", Imu())
    words = ["imu", "norm", "std_msgs/Float64", NORM, "--field", "orientation", "-i", "std_msgs", "numpy"]
    run("topic_tools", "transform", *words)
    heard = friend.hear(Float64, "norm")
    friend.spin(0.5)
    friend.say("imu", Imu(orientation=Quaternion(x=3.0, y=4.0, z=0.0, w=0.0)))
    friend.spin(0.5)
    assert [msg.data for msg in heard] == [5.0]


def test_transform_waits_for_its_topic_or_refuses_one_without_a_publisher(friend, run):
    words = ["topic_tools", "transform", "in", "out", "std_msgs/String", "m"]
    refused = run(*words)
    friend.spin(0.5)
    assert refused.exit_code == 1 and "RuntimeError: ERROR: Wrong input topic: /in" in refused.output
    waiting = run(*words, "--wait-for-start", "--qos-reliability", "reliable")
    heard = friend.hear(String, "out")
    talk(friend, "in", 3, 0.2)
    assert [msg.data for msg in heard] == ["0", "1", "2"]
    waiting.interrupt()
    friend.spin(0.5)
    assert waiting.output.endswith("transform stopped cleanly\n")


def test_an_expression_that_fails_ends_the_program(friend, run):
    friend.say("in", String())
    process = run("topic_tools", "transform", "in", "out", "std_msgs/String", "m", "--field", "head.er")
    friend.spin(0.5)
    friend.say("in", String())
    friend.spin(0.5)
    assert process.exit_code == 1 and "exception in transform:" in process.output
    assert "RuntimeError: Invalid field 'head.er': 'String' object has no attribute 'head'" in process.output


def test_relay_field_fills_a_message_with_values(friend, run):
    friend.say("in", String())
    run("topic_tools", "relay_field", "in", "header", "std_msgs/Header", "{stamp: {sec: 7}, frame_id: m.data}")
    run("topic_tools", "relay_field", "in", "now", "std_msgs/Header", "{stamp: now, frame_id: map}")
    header, now = friend.hear(Header, "header"), friend.hear(Header, "now")
    friend.spin(0.5)
    friend.say("in", String(data="laser"))
    friend.spin(0.5)
    assert [(msg.stamp.sec, msg.frame_id) for msg in header] == [(7, "laser")]
    assert [(msg.stamp.sec > 1_600_000_000, msg.frame_id) for msg in now] == [(True, "map")]
