"""Appendix B."""

_BACK = """
def to_flat(pose):
    q = pose.orientation
    return Pose2D(x=pose.position.x, y=pose.position.y, theta={theta})
"""
_THERE = """import math
from geometry_msgs.msg import Pose2D

def to_pose(flat):
    made = Pose(position=Point(x=flat.x, y=flat.y))
    {turn}
    return made
"""
_TURN = "made.orientation.z, made.orientation.w = math.sin(flat.theta / 2), math.cos(flat.theta / 2)"
_YAW = "euler_from_quaternion((q.x, q.y, q.z, q.w))[2]"
_ELLIPSE = """import math

def ellipse(estimate):
    table = np.array(estimate.pose.covariance).reshape(6, 6)[{part}]
    values, vectors = np.linalg.eigh(table)
    b, a = {axes}
    return {answer}
"""
_SIGHT = """%%write src/b_geometry/b_geometry/sight.py
import math
import numpy as np
from geometry_msgs.msg import PointStamped
from tf_transformations import quaternion_matrix

def sight(pose):
    place, q = pose.pose.position, pose.pose.orientation
    way = np.array([2.0, 1.0, 0.0]) - [place.x, place.y, place.z]
    seen = PointStamped()
    {header}
    {turn}
    seen.point.x, seen.point.y, seen.point.z = (turn @ way).tolist()
    return seen
"""
_HEADER = 'seen.header.stamp, seen.header.frame_id = pose.header.stamp, "base_link"'
_MATRIX = "turn = quaternion_matrix([q.x, q.y, q.z, q.w])[:3, :3]"
_FLAT = "c, s = 1 - 2 * q.z**2, 2 * q.z * q.w; turn = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])"
_VIEWS = """def views(outline):
    corners = [np.array([p.x, p.y]) for p in outline.polygon.points]
    made = PoseArray({header})
    for a, b in zip(corners, corners[1:] + corners[:1]):
        out = np.array([b[1] - a[1], a[0] - b[0]]) / np.linalg.norm(b - a)
        x, y = ((a + b) / 2 + {far} * out).tolist()
        yaw = float(np.arctan2({look} * out[1], {look} * out[0]))
        made.poses.append(Pose(position=Point(x=x, y=y), orientation={turn}))
    return made
"""
_HEADING = "turned(0.0, 0.0, yaw)"

WRONG = {
    "appb.q1": [
        _THERE.format(turn="made.orientation.z = flat.theta") + _BACK.format(theta=_YAW),
        _THERE.format(turn=_TURN.replace(" / 2", "")) + _BACK.format(theta=_YAW),
        _THERE.format(turn="made.orientation = turned(flat.theta, 0.0, 0.0)") + _BACK.format(theta=_YAW),
        _THERE.format(turn=_TURN) + _BACK.format(theta="2 * math.acos(q.w)"),
        _THERE.format(turn=_TURN) + _BACK.format(theta="math.nan"),
        _THERE.format(turn="made.position.x = math.nan") + _BACK.format(theta=_YAW),
        _THERE.format(turn=_TURN) + _BACK.format(theta="2 * math.atan2(q.z, q.w)"),
        _THERE.format(turn=_TURN) + _BACK.format(theta="euler_from_quaternion((q.w, q.x, q.y, q.z))[2]"),
    ],
    "appb.q2": [
        _ELLIPSE.format(part=":2, :2", axes="values.tolist()", answer="a, b, math.atan2(vectors[1, 1], vectors[0, 1])"),
        _ELLIPSE.format(part=":2, :2", axes="np.sqrt(values).tolist()", answer="a, b, math.atan2(*vectors[1])"),
        _ELLIPSE.format(part=":2, :2", axes="np.sqrt(values).tolist()", answer="b, a, math.atan2(*vectors[::-1, 0])"),
        "def ellipse(estimate):\n    c = estimate.pose.covariance\n    return float(c[0]) ** 0.5, float(c[7]) ** 0.5, 0.0",
        "def ellipse(estimate):\n    return float('nan'), float('nan'), float('nan')",
    ],
    "appb.q3": [
        _SIGHT.format(header=_HEADER, turn=_MATRIX),
        _SIGHT.format(header=_HEADER, turn="turn = np.eye(3)"),
        _SIGHT.format(header=_HEADER, turn=_FLAT),
        _SIGHT.format(header="seen.header = pose.header", turn=f"{_MATRIX}.T"),
        _SIGHT.format(header='seen.header.frame_id = "base_link"', turn=f"{_MATRIX}.T"),
    ],
    "appb.q4": [
        _VIEWS.format(header="header=outline.header", far="1.5", look="", turn=_HEADING),
        _VIEWS.format(header="header=outline.header", far="0.7", look="-", turn=_HEADING),
        _VIEWS.format(header="header=outline.header", far="-1.5", look="", turn=_HEADING),
        _VIEWS.format(header="header=outline.header", far="float('nan')", look="-", turn=_HEADING),
        _VIEWS.format(header="", far="1.5", look="-", turn=_HEADING),
        _VIEWS.format(header="header=outline.header", far="1.5", look="-", turn="Quaternion(z=yaw)"),
        "def views(outline):\n    return PoseArray(header=outline.header)",
    ],
}
