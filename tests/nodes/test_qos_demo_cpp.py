"""quality_of_service_demo_cpp: its programs have their own names, options and words, not those of the Python package."""

import pytest

from tests.nodes.test_qos_demo import said

PACKAGE = "quality_of_service_demo_cpp"


def test_a_pause_that_is_longer_than_the_deadline_is_told_to_both(session, run):
    demo = run(PACKAGE, "deadline", "600", "--publish-for", "1800", "--pause-for", "800")
    session.clock.sleep(1.7)
    assert said(demo, "talker") == ["Talker starting up", *(f"Publishing: 'Talker says {i}'" for i in range(3))]
    assert said(demo, "listener") == ["Listener starting up", *(f"Listener heard: [Talker says {i}]" for i in range(3))]
    session.clock.sleep(1.2)
    assert "Offered deadline missed - total 1 delta 1" in said(demo, "talker")
    assert "Requested deadline missed - total 1 delta 1" in said(demo, "listener")
    demo.interrupt()
    assert demo.wait(5) == 0


def test_a_late_listener_gets_what_still_lives_of_five_messages(session, run):
    demo = run(PACKAGE, "lifespan", "2700")
    session.clock.sleep(5.2)
    assert said(demo, "talker")[-1] == "Publishing: 'Talker says 4'"
    assert said(demo, "listener") == ["Listener starting up", "Listener heard: [Talker says 4]"]


@pytest.mark.parametrize("policy", ["AUTOMATIC", "MANUAL_BY_TOPIC"])
def test_a_talker_that_ends_is_noticed_within_its_lease(session, run, policy):
    words = ["--policy", policy, "--topic-assert-period", "300", "--kill-publisher-after", "1700"]
    demo = run(PACKAGE, "liveliness", "1000", *words)
    session.clock.sleep(1.6)
    counts = ["  alive_count: 1", "  not_alive_count: 0", "  alive_count_change: 1", "  not_alive_count_change: 0"]
    assert said(demo, "listener")[1:6] == ["Liveliness changed event:", *counts]
    assert "asserting publisher liveliness" in demo.output.splitlines()
    session.clock.sleep(1.5)
    assert "  alive_count: 0" in said(demo, "listener")


@pytest.mark.parametrize("policy", ["deadline", "reliability"])
def test_what_does_not_match_is_told_to_both_and_nothing_is_heard(session, run, policy):
    demo = run(PACKAGE, "incompatible_qos", policy)
    assert demo.wait(10) == 0
    assert demo.output.splitlines()[1].startswith("Incompatibility condition: publisher ")
    assert any(line.startswith("Offered incompatible qos - total 1 delta 1") for line in said(demo, "talker"))
    assert any(line.startswith("Requested incompatible qos - total 1 delta 1") for line in said(demo, "listener"))
    assert not any("heard" in line for line in said(demo, "listener"))


@pytest.mark.parametrize("name", ["deadline", "lifespan", "liveliness", "incompatible_qos"])
@pytest.mark.parametrize("words", [(), ("-h",), ("1000", "-h")])
def test_without_arguments_or_with_h_the_usage_is_printed(run, name, words):
    demo = run(PACKAGE, name, *words)
    assert demo.wait(5) == 0
    assert demo.output.startswith("Usage") and name in demo.output and "-h" in demo.output


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (("deadline", "soon"), 134, "what():  stoul"),
        (("liveliness", "1000", "--policy", "SOMEHOW"), 1, "Unknown liveliness policy: SOMEHOW"),
        (("incompatible_qos", "colour"), 0, "colour is not a valid qos policy name"),
        (("interactive_publisher", "--liveliness", "SOMEHOW"), 255, "error: invalid liveliness kind specified"),
    ],
)
def test_what_is_no_argument_is_refused(run, words, code, told):
    demo = run(PACKAGE, *words)
    ended = demo.wait(5)
    assert ended in (code, code - 140) and told in demo.output


def test_keys_steer_the_interactive_publisher_and_the_subscriber_tells(session, run):
    ear = run(PACKAGE, "interactive_subscriber", "--deadline", "1.5")
    mouth = run(PACKAGE, "interactive_publisher", "--deadline", "1.5", "--delay", "0.4")
    session.clock.sleep(1.0)
    assert "RELIABILITY POLICY: reliable\nDURABILITY POLICY: volatile\nDEADLINE: 1.5\n" in mouth.output
    assert "Listener heard: [Talker says 1]" in said(ear, "listener")
    mouth.write_stdin("s")
    session.clock.sleep(1.8)
    assert "stop sending messages" in mouth.output
    assert "Deadline missed - total 1 (delta 1)" in said(mouth, "talker")
    assert "Deadline missed - total 1 (delta 1)" in said(ear, "listener")
    mouth.write_stdin("Sp")
    session.clock.sleep(0.6)
    assert "start sending messages" in mouth.output and "asserting publisher liveliness" in mouth.output
    for process in (mouth, ear):
        process.write_stdin("qx")
        assert process.wait(3) == 0
        assert process.output.count("HISTORY POLICY: keep last (depth: 10)") == 2 and "exiting the demo..." in process.output
