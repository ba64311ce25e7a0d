"""What the checks of appendix B say of degrees."""

import math

import numpy as np
import pytest
from geometry_msgs.msg import Point, Pose, Pose2D, Quaternion

from coursekit.grade.checking import judge
from coursekit.grade.exercise import find


def there(turn):
    """to_pose for which theta is `turn` of theta."""

    def to_pose(flat):
        half = turn(flat.theta) / 2
        place, q = Point(x=flat.x, y=flat.y), Quaternion(z=math.sin(half), w=math.cos(half))
        return Pose(position=place, orientation=q)

    return to_pose


def back(turn):
    """to_flat that answers `turn` of the yaw."""

    def to_flat(pose):
        q = pose.orientation
        yaw = math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))
        return Pose2D(x=pose.position.x, y=pose.position.y, theta=turn(yaw))

    return to_flat


def ellipse(estimate):
    values, vectors = np.linalg.eigh(np.array(estimate.pose.covariance).reshape(6, 6)[:2, :2])
    b, a = np.sqrt(values).tolist()
    return a, b, math.degrees(math.atan2(vectors[1, 1], vectors[0, 1]))


@pytest.mark.parametrize(
    ("name", "functions", "cause"),
    [
        ("appb.q1", {"to_pose": there(math.degrees), "to_flat": back(float)}, "theta is in radians"),
        ("appb.q1", {"to_pose": there(lambda theta: theta / 2), "to_flat": back(float)}, "Is there a half missing"),
        ("appb.q1", {"to_pose": there(float), "to_flat": back(math.degrees)}, "theta is wanted in radians"),
        ("appb.q2", {"ellipse": ellipse}, "yaw is wanted in radians"),
    ],
)
def test_degrees_are_told_as_degrees(name, functions, cause, tmp_path):
    assert judge(find(name), functions, tmp_path).cause.startswith(cause)


def test_radians_are_right(tmp_path):
    assert judge(find("appb.q1"), {"to_pose": there(float), "to_flat": back(float)}, tmp_path).passed
