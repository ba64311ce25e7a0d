"""Trials run beside the session: its clock does not advance meanwhile, and an endless loop ends them."""

import json
from dataclasses import asdict

import pytest

from coursekit.grade import trial
from coursekit.grade.trial import Plan, TrialFailed, try_out
from coursekit.processes.session import Session


def test_a_trial_takes_no_time_of_the_session():
    with Session(virtual=True).use() as session:
        before = session.clock.steady()
        seen = try_out(Plan(run=[["run", "demo_nodes_py", "talker"]], seconds=2.5))
        assert "Hello World: 1" in seen.outputs[0]
        assert session.clock.steady() == before


def test_a_trial_does_not_care_for_the_domain_of_the_student_s_graph(monkeypatch):
    monkeypatch.setenv("ROS_DOMAIN_ID", "61")
    plan = Plan(run=[["run", "demo_nodes_py", "talker"]], seconds=1.5, record=["/chatter"])
    seen = try_out(plan)
    assert seen.nodes == ["/talker"] and len(seen.messages["/chatter"]) == 1


def test_all_topics_of_the_programs_own_are_recorded_from_their_first_message_on():
    seen = try_out(Plan(run=[["run", "demo_nodes_py", "talker"]], seconds=3.5, record=["*"]))
    assert [message["data"] for _, message in seen.messages.pop("/chatter")] == [f"Hello World: {n}" for n in range(3)]
    assert not seen.messages


def test_programs_and_what_watches_them_meet_on_topics_and_services():
    call = [(1.0, "/spawn", "turtlesim/srv/Spawn", {"x": 2.0, "name": "bob"})]
    plan = Plan(run=[["run", "turtlesim", "turtlesim_node"]], seconds=2.0, call=call, record=["/bob/pose"])
    seen = try_out(plan)
    assert seen.responses == [{"name": "bob"}]
    assert seen.messages["/bob/pose"][0][1]["x"] == 2.0
    assert seen.services["/spawn"] == ["turtlesim/srv/Spawn"] and seen.nodes == ["/turtlesim"]


def test_a_service_that_is_only_called_is_not_seen_as_one():
    call = [(0.5, "/spawm", "turtlesim/srv/Spawn", {"x": 2.0})]
    seen = try_out(Plan(run=[["run", "turtlesim", "turtlesim_node"]], seconds=1.0, call=call))
    assert "/spawn" in seen.services and "/spawm" not in seen.services and seen.responses == [None]


def test_the_course_s_programs_and_the_student_s_share_graph_and_time():
    plan = Plan(run=[["run", "demo_nodes_py", "listener"]], beside=[["run", "demo_nodes_py", "talker"]], seconds=2.5)
    plan.later = [(0.5, ["node", "list"]), (0.5, ["topic", "info", "/chatter"])]
    seen = try_out(plan)
    heard = [line.split("]: ")[1] for line in seen.outputs[0].splitlines()]
    assert heard == [f"I heard: [Hello World: {n}]" for n in range(2)]
    assert "[1700000001.000000000]" in seen.outputs[0] and "[1700000001.000000000]" in seen.beside[0]
    assert seen.outputs[1].split() == ["/listener", "/talker"]
    assert "Publisher count: 1\nSubscription count: 1" in seen.outputs[2]
    assert seen.exit_codes == [0, 0, 0]


def test_an_action_of_one_side_is_reached_from_the_other():
    goal = ["action", "send_goal", "--feedback", "/fibonacci", "action_tutorials_interfaces/action/Fibonacci", "{order: 3}"]
    seen = try_out(Plan(run=[goal], beside=[["run", "action_tutorials_py", "fibonacci_action_server"]], seconds=8.0))
    assert "status: SUCCEEDED" in seen.outputs[0] and seen.outputs[0].count("Feedback:") == 2


def test_a_trial_is_the_same_every_time():
    def run():
        drive = [(0.5, "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", {"linear": {"x": 1.0}, "angular": {"z": 0.5}})]
        turtle = [["run", "turtlesim", "turtlesim_node"]]
        seen = try_out(Plan(run=[["run", "turtlesim", "mimic"]], beside=turtle, seconds=2.0, publish=drive, record=["*"]))
        return json.dumps(asdict(seen))

    assert run() == run()


def test_what_the_course_published_is_told_from_what_a_student_did():
    shout = ["topic", "pub", "-r", "2", "/chatter", "std_msgs/msg/String", "{data: mine}"]
    seen = try_out(Plan(run=[shout], beside=[["run", "demo_nodes_py", "talker"]], seconds=2.5, record=["/chatter"]))
    assert "mine" in {message["data"] for _, message in seen.messages["/chatter"]}
    assert [message["data"] for _, message in seen.of_course("/chatter")] == ["Hello World: 0", "Hello World: 1"]


def test_later_commands_find_what_was_started_before():
    talker, question = ["run", "demo_nodes_py", "talker"], ["topic", "type", "/chatter"]
    seen = try_out(Plan(run=[talker], seconds=1.5, later=[(0.5, ["node", "list"]), (1.0, question)]))
    assert [text.strip() for text in seen.outputs[1:]] == ["/talker", "std_msgs/msg/String"]
    assert seen.exit_codes[1:] == [0, 0]


def test_a_program_that_never_gives_way_fails_the_trial(tmp_path, monkeypatch):
    (tmp_path / "share/ament_index/resource_index/packages").mkdir(parents=True)
    (tmp_path / "share/ament_index/resource_index/packages/busy").touch()
    (tmp_path / "lib/busy").mkdir(parents=True)
    program = tmp_path / "lib/busy/loop"
    program.write_text("#!/usr/bin/env python3\nwhile True:\n    pass\n")
    program.chmod(0o755)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    monkeypatch.setattr(trial, "GIVES_WAY", 1.0)
    with pytest.raises(TrialFailed, match="a loop that never waits"):
        try_out(Plan(run=[["run", "busy", "loop"]]))
