"""Trials run beside the session: its clock stands still meanwhile, and an endless loop ends them."""

import pytest

from coursekit.core.session import Session
from coursekit.grade import trial
from coursekit.grade.trial import Plan, TrialFailed, try_out


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
    monkeypatch.setattr(trial, "PATIENCE", 1.0)
    with pytest.raises(TrialFailed, match="a loop that never waits"):
        try_out(Plan(run=[["run", "busy", "loop"]]))
