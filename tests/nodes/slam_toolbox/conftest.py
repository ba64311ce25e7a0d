"""Robots and slam_toolbox's nodes."""

from __future__ import annotations

import pytest

from tests.slam.robot import Robot


@pytest.fixture
def robot(session):
    """robot(...) makes a robot that leaves when the test ends."""
    robots: list[Robot] = []

    def make(*args, **kwargs):
        robots.append(Robot(session, *args, **kwargs))
        return robots[-1]

    yield make
    for running_robot in robots:
        running_robot.close()


@pytest.fixture
def slam(run, session):
    """slam("-p", "name:=value", node=...) starts a node with a map twice a second."""

    def start(*argv, node="async_slam_toolbox_node"):
        process = run("slam_toolbox", node, "--ros-args", "-p", "map_update_interval:=0.5", *argv)
        session.clock.sleep(1.0)
        return process

    return start
