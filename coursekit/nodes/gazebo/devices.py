"""The devices of a model in ROS: sensors and drives with their topics, frames and rates, as data."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from coursekit.geometry.plane import ORIGIN, Array, Pose2D
from coursekit.sim.globe import Globe
from coursekit.sim.lidar import Lidar


@dataclass(frozen=True)
class Device:
    """Anything that publishes `rate` times a second on `topic`, in `frame`."""

    topic: str
    frame: str
    rate: float
    node: str = ""


@dataclass(frozen=True)
class RayDevice(Device):
    """A LiDAR, sonar or infrared sensor; `output` is the type of its messages."""

    lidar: Lidar = field(default_factory=Lidar)
    output: str = "sensor_msgs/LaserScan"
    radiation: int = 1
    """Of sensor_msgs/Range: 0 ultrasound, 1 infrared."""


@dataclass(frozen=True)
class ImuDevice(Device):
    """An inertial unit; `turn_noise` [rad/s] and `push_noise` [m/s^2] are standard deviations, biases are added."""

    turn_noise: float = 0.0
    turn_bias: float = 0.0
    push_noise: float = 0.0
    push_bias: float = 0.0


@dataclass(frozen=True)
class EarthDevice(Device):
    """A sensor of the Earth; `quantity` is navsat, altimeter, magnetometer or air_pressure."""

    quantity: str = "navsat"
    mount: Pose2D = ORIGIN
    height: float = 0.0
    noise: tuple[float, float] = (0.0, 0.0)
    """Standard deviations: across and up, of height and speed, across and up, of the pressure."""
    globe: Globe | None = None
    """Where a world lies that does not say."""


@dataclass(frozen=True)
class CameraDevice(Device):
    """A camera: pictures on `topic`, calibration on `info_topic`; its pose in the model looks along x."""

    info_topic: str = ""
    width: int = 640
    height: int = 480
    fov: float = 1.3
    far: float = 30.0
    pose: Array | None = None
    encoding: str = "rgb8"
    noise: float = 0.0
    """Standard deviation of a point's brightness, from 0 to 1."""


@dataclass(frozen=True)
class DepthDevice(CameraDevice):
    """A camera that also measures how far ahead things are, within `reach` [m]."""

    reach: tuple[float, float] = (0.4, 3.0)
    depth_topic: str = ""
    depth_info_topic: str = ""
    cloud_topic: str = ""


@dataclass(frozen=True)
class OdometryDevice(Device):
    """Commands and odometry of a drive; `topic` is that of the odometry, `frame` its frame."""

    command_topic: str = "/cmd_vel"
    base_frame: str = "base_footprint"
    publish_odom: bool = True
    publish_tf: bool = True
    exact: bool = True
    """Whether it tells where the robot really is (Gazebo's odometry_source WORLD) or what wheels turned (ENCODER)."""
    covariance: tuple[float, float, float] = (1e-5, 1e-5, 1e-3)
    tf_topic: str = "/tf"
    stamped: bool = False
    """Whether commands come as TwistStamped."""
    by_rate: bool = False
    """Whether a car is told how fast to turn, not how far its wheels shall."""
    spreads: tuple[tuple[float, ...], ...] = ()
    """The whole diagonals of the covariances of pose and twist, instead of `covariance`."""


@dataclass(frozen=True)
class JointDevice(Device):
    """Joint states."""

    joints: tuple[str, ...] = ()


@dataclass(frozen=True)
class WheelDevice(Device):
    """The frames of wheels, on `topic`."""

    wheels: tuple[tuple[str, str, str, tuple[float, ...], tuple[float, float, float]], ...] = ()
    """Joint, frame that it hangs on, own frame; where that is at angle 0 (16 numbers), and the axis that it turns about."""


@dataclass(frozen=True)
class MotorDevice(Device):
    """A motor: commands on `topic` move a joint to a position, or at a velocity."""

    joint: str = ""
    mode: str = "position"


@dataclass(frozen=True)
class TrajectoryDevice(Device):
    """Motors of `joints` that follow trajectories on `topic`; these begin when they come, or at the time in their header."""

    joints: tuple[str, ...] = ()
    from_header: bool = False


@dataclass(frozen=True)
class ControlDevice(Device):
    """A controller manager of ros2_control; `node` is its name, `rate` how often it works."""

    hardware: tuple[Any, ...] = ()
    files: tuple[str, ...] = ()
    remappings: tuple[str, ...] = ()
    odometry: tuple[tuple[str, OdometryDevice], ...] = ()
    """Controllers that drive, by name, and what they tell."""

    def arguments(self) -> list[str]:
        """Of its nodes: parameter files and remappings."""
        words = [word for file in self.files for word in ("--params-file", file)]
        return words + [word for one in self.remappings for word in ("-r", one)]


@dataclass(frozen=True)
class TruthDevice(Device):
    """Where a robot really is (Gazebo's p3d)."""

    body: str = ""


@dataclass(frozen=True)
class BumpDevice(Device):
    """The contacts of a robot (Gazebo's bumper)."""

    link: str = ""


@dataclass(frozen=True)
class TouchDevice(BumpDevice):
    """The contacts of a robot, as the newer Gazebo publishes them."""


@dataclass(frozen=True)
class PoseDevice(Device):
    """Where a model is in its `world` ('' for untold), and where its links are in it (16 numbers of each)."""

    model: str = ""
    world: str = ""
    links: tuple[tuple[str, tuple[float, ...]], ...] = ()


__all__ = [
    "BumpDevice", "CameraDevice", "ControlDevice", "DepthDevice", "Device", "EarthDevice", "ImuDevice", "JointDevice",
    "MotorDevice", "OdometryDevice", "PoseDevice", "RayDevice", "TouchDevice", "TrajectoryDevice", "TruthDevice",
    "WheelDevice",
]  # fmt: skip
