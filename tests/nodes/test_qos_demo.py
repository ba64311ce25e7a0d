"""quality_of_service_demo_*: what both ends are told."""

import pytest


def lines(process):
    """What a process logged, without the stamps."""
    return [line.split("[INFO] ", 1)[-1].partition("] ")[2] for line in process.output.splitlines()]


def said(process, name):
    """What one logger of a process said."""
    return [line.removeprefix(f"[{name}]: ") for line in lines(process) if line.startswith(f"[{name}]: ")]


def test_a_pause_that_is_longer_than_the_deadline_is_told_to_both(session, run):
    demo = run("quality_of_service_demo_py", "deadline", "600", "--publish-for", "1800", "--pause-for", "800")
    session.clock.sleep(1.7)
    assert said(demo, "Listener") == [] and "I heard: Talker says 2" in said(demo, "qos_listener")
    session.clock.sleep(1.2)
    assert len(said(demo, "Talker")) == 1 and "total_count=1" in said(demo, "Listener")[0]
    demo.interrupt()
    assert demo.wait(5) == 0


def test_a_late_listener_gets_what_still_lives(session, run):
    demo = run("quality_of_service_demo_py", "lifespan", "1000", "--publish-count", "6", "--subscribe-after", "3100")
    session.clock.sleep(3.4)
    assert said(demo, "qos_listener") == ["Subscription created", "I heard: Talker says 4", "I heard: Talker says 5"]


@pytest.mark.parametrize("policy", ["AUTOMATIC", "MANUAL_BY_TOPIC"])
def test_a_talker_that_ends_is_noticed_within_its_lease(session, run, policy):
    words = ["--policy", policy, "--topic-assert-period", "300", "--kill-publisher-after", "1700"]
    demo = run("quality_of_service_demo_py", "liveliness", "1000", *words)
    session.clock.sleep(1.6)
    assert len(said(demo, "Listener")) == 1 and "alive_count=1" in said(demo, "Listener")[0]
    session.clock.sleep(1.5)
    assert "alive_count=0" in said(demo, "Listener")[-1]


@pytest.mark.parametrize(
    "policy", ["durability", "deadline", "liveliness_policy", "liveliness_lease_duration", "reliability"]
)
def test_what_does_not_match_is_told_to_both_and_nothing_is_heard(session, run, policy):
    demo = run("quality_of_service_demo_py", "incompatible_qos", policy)
    assert demo.wait(10) == 0
    condition, offered, asked = demo.output.splitlines()[1:4]
    assert condition.startswith("Incompatibility condition: publisher ")
    assert offered.startswith("Setting publisher ") and asked.startswith("Setting subscription ")
    assert said(demo, "talker")[0].startswith("Offered incompatible qos - total 1 delta 1 last_policy_kind: ")
    assert said(demo, "listener")[0].startswith("Requested incompatible qos - total 1 delta 1 last_policy_kind: ")
    assert said(demo, "qos_listener") == ["Subscription created"] and len(said(demo, "qos_talker")) == 6
