"""`ros2 doctor --report` tells of the topics and of who cannot hear whom."""

from coursekit.cli.parser import run
from coursekit.core.executables import find
from coursekit.core.session import Session


def report(*nodes):
    with Session(virtual=True).use() as session:
        for name, *argv in nodes:
            session.start_executable(find("demo_nodes_py", name), argv)
        session.clock.sleep(0.1)
        doctor = session.start(lambda: run(["doctor", "--report"]), name="ros2")
        assert doctor.wait(20) == 0
        return doctor.output


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
