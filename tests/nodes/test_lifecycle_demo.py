"""The package lifecycle, as its tutorial runs it."""

import pytest


def lines(process):
    """What a process logged, without the stamps."""
    return [line.split("]: ", 1)[-1] for line in process.output.splitlines()]


def test_the_talker_is_heard_only_while_it_is_active(session, run, ros2):
    talker = run("lifecycle", "lifecycle_talker")
    listener = run("lifecycle", "lifecycle_listener")
    session.clock.sleep(0.5)
    assert ros2("lifecycle", "get", "/lc_talker") == "unconfigured [1]\n"
    assert ros2("lifecycle", "set", "/lc_talker", "configure") == "Transitioning successful\n"
    session.clock.sleep(1.5)
    assert lines(talker)[-1] == "Lifecycle publisher is currently inactive. Messages are not published."
    assert not [line for line in lines(listener) if line.startswith("data_callback")]
    ros2("lifecycle", "set", "/lc_talker", "activate")
    session.clock.sleep(2.5)
    assert lines(talker)[-1].startswith("Lifecycle publisher is active. Publishing: [Lifecycle HelloWorld #")
    assert lines(listener)[-1].startswith("data_callback: Lifecycle HelloWorld #")
    assert "notify callback: Transition from state activating to active" in lines(listener)


@pytest.mark.parametrize("package", ["lifecycle", "lifecycle_py"])
def test_the_demo_takes_the_talker_through_all_its_states_and_ends(session, ros2, package):
    output = ros2("launch", package, "lifecycle_demo.launch.py", seconds=90.0)
    told = [line.split("has current state ")[1] for line in output.splitlines() if "has current state" in line]
    assert told == ["inactive.", "active.", "inactive.", "active.", "inactive.", "unconfigured.", "finalized."]
    assert "on shutdown is called from state unconfigured." in output
    assert "[lifecycle_service_client-3]: process has finished cleanly" in output
