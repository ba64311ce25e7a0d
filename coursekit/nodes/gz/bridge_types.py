"""Which Gazebo and ROS types the bridge pairs, and how messages are converted.

In Gazebo's graph, each Gazebo type is represented by the first ROS type in its row.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from geometry_msgs.msg import Pose, PoseArray, PoseStamped, Transform, TransformStamped, Twist, TwistStamped
from tf2_msgs.msg import TFMessage

PAIRS: dict[str, tuple[str, ...]] = {
    "Altimeter": ("ros_gz_interfaces/msg/Altimeter",),
    "Boolean": ("std_msgs/msg/Bool",),
    "CameraInfo": ("sensor_msgs/msg/CameraInfo",),
    "Clock": ("rosgraph_msgs/msg/Clock",),
    "Color": ("std_msgs/msg/ColorRGBA",),
    "Contacts": ("ros_gz_interfaces/msg/Contacts",),
    "Double": ("std_msgs/msg/Float64",),
    "Empty": ("std_msgs/msg/Empty",),
    "Float": ("std_msgs/msg/Float32",),
    "FluidPressure": ("sensor_msgs/msg/FluidPressure",),
    "Header": ("std_msgs/msg/Header",),
    "Image": ("sensor_msgs/msg/Image",),
    "IMU": ("sensor_msgs/msg/Imu",),
    "Int32": ("std_msgs/msg/Int32",),
    "JointTrajectory": ("trajectory_msgs/msg/JointTrajectory",),
    "LaserScan": ("sensor_msgs/msg/LaserScan",),
    "Light": ("ros_gz_interfaces/msg/Light",),
    "Magnetometer": ("sensor_msgs/msg/MagneticField",),
    "Model": ("sensor_msgs/msg/JointState",),
    "NavSat": ("sensor_msgs/msg/NavSatFix",),
    "BatteryState": ("sensor_msgs/msg/BatteryState",),
    "Odometry": ("nav_msgs/msg/Odometry",),
    "OdometryWithCovariance": ("nav_msgs/msg/Odometry",),
    "PointCloudPacked": ("sensor_msgs/msg/PointCloud2",),
    "Pose": (
        "geometry_msgs/msg/PoseStamped", "geometry_msgs/msg/Pose", "geometry_msgs/msg/Transform",
        "geometry_msgs/msg/TransformStamped",
    ),
    "Pose_V": ("tf2_msgs/msg/TFMessage", "geometry_msgs/msg/PoseArray"),
    "PoseWithCovariance": ("geometry_msgs/msg/PoseWithCovariance",),
    "Quaternion": ("geometry_msgs/msg/Quaternion",),
    "StringMsg": ("std_msgs/msg/String",),
    "StringMsg_V": ("ros_gz_interfaces/msg/StringVec",),
    "Float_V": ("ros_gz_interfaces/msg/Float32Array",),
    "Time": ("builtin_interfaces/msg/Time",),
    "Twist": ("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped"),
    "TwistWithCovariance": ("geometry_msgs/msg/TwistWithCovariance",),
    "UInt32": ("std_msgs/msg/UInt32",),
    "Vector3d": ("geometry_msgs/msg/Vector3", "geometry_msgs/msg/Point"),
    "Wrench": ("geometry_msgs/msg/Wrench",),
}  # fmt: skip
PREFIXES = ("gz.msgs.", "ignition.msgs.", "gz::msgs::", "ignition::msgs::")
SERVICES: dict[str, tuple[str, tuple[str, ...]]] = {
    "ros_gz_interfaces/srv/ControlWorld": ("WorldControl", ("world_control",)),
    "ros_gz_interfaces/srv/SpawnEntity": ("EntityFactory", ("entity_factory",)),
    "ros_gz_interfaces/srv/DeleteEntity": ("Entity", ("entity",)),
    "ros_gz_interfaces/srv/SetEntityPose": ("Pose", ("entity", "pose")),
}
"""The services of a world: the type of the request in Gazebo, and the fields of the ROS request that stand for it."""


def full_name(ros_type: str) -> str:
    """Expand `std_msgs/String` to `std_msgs/msg/String`."""
    words = ros_type.split("/")
    return f"{words[0]}/msg/{words[1]}" if len(words) == 2 else ros_type


def carried_by(ros_type: str, gz_type: str) -> str:
    """Return the ROS type that represents a Gazebo type. LookupError lists the valid pairs for an invalid one.

    >>> carried_by("geometry_msgs/msg/TwistStamped", "ignition.msgs.Twist")
    'geometry_msgs/msg/Twist'
    """
    row = PAIRS.get(without_prefix(gz_type))
    if row is not None and full_name(ros_type) in row:
        return row[0]
    if row is not None:
        raise LookupError(f"{gz_type} is bridged to {' or '.join(row)}")
    fitting = [f"gz.msgs.{name}" for name, types in PAIRS.items() if full_name(ros_type) in types]
    raise LookupError(f"{ros_type} is bridged to {' or '.join(fitting) or 'no type of Gazebo'}")


def without_prefix(gz_type: str) -> str:
    """Return the bare name of a Gazebo type; '' for a name that is none.

    >>> without_prefix("ignition.msgs.Twist"), without_prefix("geometry_msgs/msg/Twist")
    ('Twist', '')
    """
    return next((gz_type.removeprefix(start) for start in PREFIXES if gz_type.startswith(start)), "")


def carrier_of(gz_type: str) -> str:
    """Return the ROS type that represents a Gazebo type. LookupError lists the types for an unknown one.

    >>> carrier_of("gz.msgs.Twist")
    'geometry_msgs/msg/Twist'
    """
    row = PAIRS.get(without_prefix(gz_type))
    if row is None:
        raise LookupError(f"There is no type '{gz_type}' here. There are: {', '.join(f'gz.msgs.{name}' for name in PAIRS)}")
    return row[0]


def gz_name(ros_type: str) -> str:
    """Return the Gazebo type that a ROS type represents, as `gz topic` names it."""
    return next((f"gz.msgs.{name}" for name, types in PAIRS.items() if types[0] == ros_type), ros_type)


def _same(msg: Any) -> Any:
    return msg


def _poses(msg: TFMessage) -> PoseArray:
    pose_array = PoseArray()
    for transform in msg.transforms:
        pose_array.header = transform.header
        pose_array.poses.append(_pose(transform.transform))
    return pose_array


def _pose(transform: Transform) -> Pose:
    pose = Pose(orientation=transform.rotation)
    at = transform.translation
    pose.position.x, pose.position.y, pose.position.z = at.x, at.y, at.z
    return pose


def _transform(pose: Pose) -> Transform:
    transform = Transform(rotation=pose.orientation)
    transform.translation.x, transform.translation.y, transform.translation.z = (
        pose.position.x,
        pose.position.y,
        pose.position.z,
    )
    return transform


CONVERSIONS: dict[tuple[str, str], Callable[[Any], Any]] = {
    ("Twist", "TwistStamped"): lambda msg: TwistStamped(twist=msg),
    ("TwistStamped", "Twist"): lambda msg: Twist(linear=msg.twist.linear, angular=msg.twist.angular),
    ("TFMessage", "PoseArray"): _poses,
    ("PoseStamped", "Pose"): lambda msg: msg.pose,
    ("Pose", "PoseStamped"): lambda msg: PoseStamped(pose=msg),
    ("PoseStamped", "Transform"): lambda msg: _transform(msg.pose),
    ("Transform", "PoseStamped"): lambda msg: PoseStamped(pose=_pose(msg)),
    ("PoseStamped", "TransformStamped"): lambda msg: TransformStamped(header=msg.header, transform=_transform(msg.pose)),
    ("TransformStamped", "PoseStamped"): lambda msg: PoseStamped(header=msg.header, pose=_pose(msg.transform)),
    ("Vector3", "Point"): lambda msg: _moved(msg, "Point"),
    ("Point", "Vector3"): lambda msg: _moved(msg, "Vector3"),
}


def _moved(msg: Any, kind: str) -> Any:
    import geometry_msgs.msg

    return getattr(geometry_msgs.msg, kind)(x=msg.x, y=msg.y, z=msg.z)


def conversion(source: str, target: str) -> Callable[[Any], Any] | None:
    """Return the function that converts one ROS type to another, or None if there is none."""
    one, other = source.rpartition("/")[2], target.rpartition("/")[2]
    return _same if source == target else CONVERSIONS.get((one, other))


__all__ = ["PAIRS", "SERVICES", "carried_by", "carrier_of", "conversion", "full_name", "gz_name", "without_prefix"]
