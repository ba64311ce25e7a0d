"""Link poses from pinocchio, and robots that other packages carry."""

from __future__ import annotations

import random
from importlib import metadata
from pathlib import Path

import numpy as np
import pytest

import coursekit.urdf
from coursekit.urdf import Robot

ROBOTS = Path(coursekit.urdf.__file__).parents[1] / "share" / "coursekit_robots" / "urdf"


def pinocchio():
    """The module, or a skipped test that says what to install."""
    return pytest.importorskip("pinocchio", reason="pinocchio is not here to compare with: pip install pin")


def random_positions(robot: Robot, seed: int) -> dict[str, float]:
    """Some position for every joint, followers too."""
    chance = random.Random(seed)
    positions = {}
    for joint in robot.moving_joints():
        low, high = (-3.0, 3.0) if joint.type == "continuous" else (joint.limit.lower, joint.limit.upper)
        positions[joint.name] = chance.uniform(max(low, -10.0), min(high, 10.0))
    return positions


def all_positions(robot: Robot, positions: dict[str, float]) -> dict[str, float]:
    """The positions with those of the followers worked out by hand."""
    position_by_joint = dict(positions)

    def of(name: str) -> float:
        mimic = robot.joints[name].mimic
        if name not in position_by_joint:
            position_by_joint[name] = 0.0 if mimic is None else mimic.multiplier * of(mimic.joint) + mimic.offset
        return position_by_joint[name]

    for joint in robot.joints.values():
        if joint.moves:
            of(joint.name)
    return position_by_joint


def pinocchio_matrices(text: str, robot: Robot, positions: dict[str, float]) -> dict[str, np.ndarray]:
    """Each link's 4x4 matrix in the root link."""
    pin = pinocchio()
    model = pin.buildModelFromXML(text)
    data = model.createData()
    q = pin.neutral(model)
    for name, value in all_positions(robot, positions).items():
        joint = model.joints[model.getJointId(name)]
        if joint.nq == 2:  # a continuous joint, as cosine and sine
            q[joint.idx_q : joint.idx_q + 2] = np.cos(value), np.sin(value)
        else:
            q[joint.idx_q] = value
    pin.framesForwardKinematics(model, data, q)
    return {name: data.oMf[model.getFrameId(name, pin.FrameType.BODY)].homogeneous for name in robot.links}


def public_robots() -> list[Path]:
    """The URDF files that installed packages carry, such as example-robot-data's."""
    files = [
        file for distribution in metadata.distributions() for file in distribution.files or () if file.suffix == ".urdf"
    ]
    paths = {Path(str(file.locate())) for file in files}
    return sorted(path for path in paths if path.is_file() and ROBOTS.parents[2] not in path.parents)
