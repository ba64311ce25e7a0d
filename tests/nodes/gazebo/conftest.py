"""Robots in the simulator."""

from pathlib import Path

import pytest

ROBOT = Path(__file__).parents[3] / "robots" / "urdf" / "rdk_x3_robot.urdf"


@pytest.fixture
def spawn(run):
    def spawn(*more, file=ROBOT, name="rdk"):
        process = run("gazebo_ros", "spawn_entity.py", "-file", str(file), "-entity", name, *more)
        process.wait(40)
        return process

    return spawn
