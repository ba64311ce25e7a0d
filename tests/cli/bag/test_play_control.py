"""A player that is controlled, by keys and by services."""

from __future__ import annotations

import pytest

from tests.cli.bag.stage import Stage


def test_keys_pause_step_and_change_the_rate(stage: Stage) -> None:
    stage.listen("/chatter")
    player = stage.ros2("bag play talk -p")
    stage.sleep_until(10)
    assert stage.heard == []
    player.write_stdin("\x1b[C\x1b[Cx\x1b[A\x1b[B")
    stage.sleep_until(11)
    assert [text for text, _ in stage.heard] == ["Hello 0", "Hello 1"]
    player.write_stdin(" ")
    stage.sleep_until(12.5)
    player.write_stdin(" ")
    stage.sleep_until(20)
    assert [text for text, _ in stage.heard] == ["Hello 0", "Hello 1", "Hello 2"]
    player.write_stdin(" ")
    player.wait(10)
    said = [line.split("]: ")[1] for line in player.output.splitlines()]
    assert said[-5:] == ["Set rate to 1.1", "Set rate to 0.99", "Resuming play.", "Pausing play.", "Resuming play."]
    assert stage.heard[2][1] == pytest.approx(11 + 1 / 0.99) and stage.heard[-1][0] == "Hello 5"


def call(stage: Stage, name: str, kind: str, values: str = "{}") -> str:
    """Call a service of the player; the response as text."""
    return stage.ask(f"service call /rosbag2_player/{name} rosbag2_interfaces/srv/{kind} '{values}'").split("response:\n")[1]


def test_services_control_it(stage: Stage) -> None:
    stage.listen("/chatter")
    player = stage.ros2("bag play talk")
    stage.sleep_until(1.5)
    call(stage, "pause", "Pause")
    assert "paused=True" in call(stage, "is_paused", "IsPaused")
    assert "success=True" in call(stage, "play_next", "PlayNext")
    assert "actually_burst=2" in call(stage, "burst", "Burst", "{num_messages: 2}")
    assert [text for text, _ in stage.heard] == [f"Hello {n}" for n in range(5)]
    assert "success=True" in call(stage, "seek", "Seek", "{time: {sec: 103}}")
    assert "success=True" in call(stage, "set_rate", "SetRate", "{rate: 4.0}")
    assert "success=False" in call(stage, "set_rate", "SetRate", "{rate: -1.0}")
    assert "rate=4.0" in call(stage, "get_rate", "GetRate")
    stage.heard.clear()
    call(stage, "toggle_paused", "TogglePaused")
    assert player.wait(5) == 0
    assert [text for text, _ in stage.heard] == ["Hello 3", "Hello 4", "Hello 5"]
    assert stage.heard[2][1] - stage.heard[0][1] == pytest.approx(0.5)
    assert "Failed to set rate to invalid value -1" in player.output and "Burst 2 messages." in player.output


def test_only_a_paused_player_steps(stage: Stage) -> None:
    player = stage.ros2("bag play talk")
    stage.sleep_until(0.5)
    assert "success=False" in call(stage, "play_next", "PlayNext")
    assert "actually_burst=0" in call(stage, "burst", "Burst")
    call(stage, "pause", "Pause")
    assert "actually_burst=5" in call(stage, "burst", "Burst")
    assert player.wait(1) == 0  # nothing is left
    assert "Called play next, but not in paused state." in player.output


def test_seeking_before_the_beginning_begins_anew(stage: Stage) -> None:
    stage.listen("/chatter")
    stage.ros2("bag play talk")
    stage.sleep_until(2.5)
    assert "success=True" in call(stage, "seek", "Seek", "{time: {sec: 3}}")
    stage.sleep_until(3)
    assert [text for text, _ in stage.heard] == ["Hello 0", "Hello 1", "Hello 2", "Hello 0"]
