"""A trajectory's commands to joints that take velocities: a loop around each joint's error, as its parameters say."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursekit.nodes.control.controller import Interfaces
from coursekit.nodes.control.joint_commands import JointCommands
from coursekit.nodes.control.trajectory import Point
from coursekit.nodes.control.trajectory_parameters import TrajectoryParameters


def commands(steps, **gains):
    """The velocities commanded in steps of 0.1 s with the same error of 0.5 rad, at a desired 1 rad/s."""
    given = {"joints": ["elbow"], "command_interfaces": ["velocity"], "state_interfaces": ["position", "velocity"]}
    given |= {f"gains.elbow.{name}": value for name, value in gains.items()}
    loop = JointCommands(TrajectoryParameters.of(SimpleNamespace(parameter=given.get)))
    interfaces = Interfaces({"elbow/velocity": {"elbow/velocity": 0.0}}, {})
    desired, error = (Point(0.0, np.array([p]), np.array([v])) for p, v in ((2.0, 1.0), (0.5, 0.2)))
    commanded = []
    for _ in range(steps):
        loop.give(interfaces, desired, error, 0.1)
        commanded.append(interfaces.commanded("elbow/velocity"))
    return commanded


def test_gains_and_the_share_of_the_desired_velocity_add_up():
    assert commands(1, p=2.0, d=3.0, ff_velocity_scale=0.5) == [pytest.approx(0.5 + 2.0 * 0.5 + 3.0 * 0.2)]


def test_the_integral_adds_no_more_than_its_clamp():
    assert commands(3, i=2.0, i_clamp=0.15) == pytest.approx([0.1, 0.15, 0.15])


def test_without_a_clamp_the_integral_adds_nothing():
    assert commands(2, i=2.0) == [0.0, 0.0]
