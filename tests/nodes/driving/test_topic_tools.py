"""topic_tools: messages of any type, handed on."""

import pytest
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String
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
