"""`ros2 doctor --report` tells of the topics and of who cannot hear whom."""

from coursekit.cli.parser import run
from coursekit.processes.executables import find
from coursekit.processes.session import Session


def report(*nodes):
    return doctor("--report", *nodes)


def doctor(*words):
    """What `ros2 doctor` prints with the flags among the words, beside the nodes among them."""
    flags = [word for word in words if isinstance(word, str)]
    nodes = [word for word in words if not isinstance(word, str)]
    with Session(virtual=True).use() as session:
        for name, *argv in nodes:
            session.start_executable(find("demo_nodes_py", name), argv)
        session.clock.sleep(0.1)
        process = session.start(lambda: run(["doctor", *flags]), name="ros2")
        assert process.wait(20) == 0
        return process.output


def lines_of(text, title):
    """The lines of one section as [name, value] pairs."""
    section = text.split(f"   {title}\n", 1)[1].split("\n\n", 1)[0]
    return [tuple(part.strip() for part in line.split(":", 1)) for line in section.splitlines() if line]


def test_topics_are_counted_and_pairs_that_match_are_ok():
    text = report(("talker",), ("listener",))
    assert lines_of(text, "TOPIC LIST") == [
        ("topic", "/chatter"), ("publisher count", "1"), ("subscriber count", "1"),
    ]  # fmt: skip
    assert lines_of(text, "QOS COMPATIBILITY LIST") == [
        ("topic [type]", "/chatter [std_msgs/msg/String]"), ("publisher node", "talker"),
        ("subscriber node", "listener"), ("compatibility status", "OK"),
    ]  # fmt: skip


def test_each_table_is_as_wide_as_its_longest_word_asks_for():
    text = report(("talker",), ("listener",))
    for line in ("topic               : /chatter", "publisher count     : 1", "compatibility status    : OK"):
        assert f"\n{line}\n" in text


def test_a_pair_that_cannot_match_says_why():
    pairs = lines_of(report(("talker_qos",), ("listener_qos", "--reliable")), "QOS COMPATIBILITY LIST")
    status = dict(pairs)["compatibility status"]
    assert status.startswith("ERROR: ") and "Best effort publisher and reliable subscription" in status


def test_an_empty_graph_has_no_pairs():
    text = report()
    assert lines_of(text, "TOPIC LIST") == [("topic", "none"), ("publisher count", "0"), ("subscriber count", "0")]
    assert lines_of(text, "QOS COMPATIBILITY LIST") == [
        ("compatibility status", "No publisher/subscriber pairs found")
    ]


def test_the_report_has_the_sections_that_ros_has_in_its_order():
    text = report()
    titles = ["NETWORK CONFIGURATION", "PLATFORM INFORMATION", "RMW MIDDLEWARE", "ROS 2 INFORMATION", "TOPIC LIST"]
    assert sorted(titles, key=text.index) == titles
    assert dict(lines_of(text, "ROS 2 INFORMATION"))["distribution status"] == "active"


def test_a_topic_with_one_end_is_a_warning_and_no_failure():
    text = doctor(("talker",), ("add_two_ints_server",))
    assert "UserWarning: Publisher without subscriber detected on /chatter.\n" in text
    assert "checks passed" in text
    assert "UserWarning: Subscriber without publisher detected on /chatter.\n" in doctor(("listener",))
    assert "detected on" not in doctor(("talker",), ("listener",))


def test_one_ended_topics_fail_when_warnings_count():
    text = doctor("--include-warnings", ("talker",))
    assert "1/12 check(s) failed" in text and "Failed modules: topic" in text
