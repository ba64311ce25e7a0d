"""The devices of a model in ROS, as data: sensors and drives with their topics, frames and rates."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from coursekit.geometry.plane import ORIGIN, Array, Pose2D
from coursekit.sim.lidar import Lidar
from coursekit.sim.spherical_coordinates import SphericalCoordinates


@dataclass(frozen=True)
class Device:
    """A device that publishes `rate` times a second on `topic`, in `frame`."""

    topic: str
    frame: str
    rate: float
    node: str = ""


@dataclass(frozen=True)
class RayDevice(Device):
    """A LiDAR, sonar or infrared sensor; `output` is the message type."""

    lidar: Lidar = field(default_factory=Lidar)
    output: str = "sensor_msgs/LaserScan"
    radiation: int = 1
    """The radiation type in sensor_msgs/Range: 0 ultrasound, 1 infrared."""


@dataclass(frozen=True)
class ImuDevice(Device):
    """An inertial unit; `turn_noise` [rad/s] and `push_noise` [m/s^2] are standard deviations, biases are added."""

    turn_noise: float = 0.0
    turn_bias: float = 0.0
    push_noise: float = 0.0
    push_bias: float = 0.0


@dataclass(frozen=True)
class EarthDevice(Device):
    """A sensor of Earth quantities; `quantity` is navsat, altimeter, magnetometer or air_pressure."""

    quantity: str = "navsat"
    mount: Pose2D = ORIGIN
    height: float = 0.0
    noise: tuple[float, float] = (0.0, 0.0)
    """Standard deviations: horizontal and vertical; of height and speed; horizontal and vertical; of the pressure."""
    globe: SphericalCoordinates | None = None
    """The location of a world without its own."""


@dataclass(frozen=True)
class CameraDevice(Device):
    """A camera: images on `topic`, calibration on `info_topic`; it looks along x of its pose in the model."""

    info_topic: str = ""
    width: int = 640
    height: int = 480
    fov: float = 1.3
    far: float = 30.0
    pose: Array | None = None
    encoding: str = "rgb8"
    noise: float = 0.0
    """The standard deviation of a pixel's brightness, from 0 to 1."""


@dataclass(frozen=True)
class DepthDevice(CameraDevice):
    """A camera that also measures depths within `reach` [m]."""

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
    """Whether odometry is the true pose (Gazebo's odometry_source WORLD) or computed from wheels (ENCODER)."""
    covariance: tuple[float, float, float] = (1e-5, 1e-5, 1e-3)
    tf_topic: str = "/tf"
    stamped: bool = False
    """Whether commands come as TwistStamped."""
    by_rate: bool = False
    """Whether a car's command is a rotation rate instead of a wheel angle."""
    spreads: tuple[tuple[float, ...], ...] = ()
    """The full diagonals of the covariances of pose and twist, in place of `covariance`."""


@dataclass(frozen=True)
class JointDevice(Device):
    """Joint states."""

    joints: tuple[str, ...] = ()


@dataclass(frozen=True)
class WheelDevice(Device):
    """The frames of wheels, on `topic`."""

    wheels: tuple[tuple[str, str, str, tuple[float, ...], tuple[float, float, float]], ...] = ()
    """Joint, parent frame, own frame; its pose at angle 0 (16 numbers), and the rotation axis."""


@dataclass(frozen=True)
class MotorDevice(Device):
    """A motor: commands on `topic` move a joint to a position, or at a velocity."""

    joint: str = ""
    mode: str = "position"


@dataclass(frozen=True)
class TrajectoryDevice(Device):
    """Motors of `joints` that follow trajectories on `topic`, from their arrival or from the time in their header."""

    joints: tuple[str, ...] = ()
    from_header: bool = False


@dataclass(frozen=True)
class ControlDevice(Device):
    """A controller manager of ros2_control; `node` is its name, `rate` its update rate."""

    hardware: tuple[Any, ...] = ()
    files: tuple[str, ...] = ()
    remappings: tuple[str, ...] = ()
    odometry: tuple[tuple[str, OdometryDevice], ...] = ()
    """Driving controllers by name, with their odometry."""

    def arguments(self) -> list[str]:
        """Return the arguments of its nodes: parameter files and remappings."""
        words = [word for file in self.files for word in ("--params-file", file)]
        return words + [word for remapping in self.remappings for word in ("-r", remapping)]


@dataclass(frozen=True)
class TruthDevice(Device):
    """A robot's true pose (Gazebo's p3d)."""

    body: str = ""


@dataclass(frozen=True)
class BumpDevice(Device):
    """The contacts of a robot (Gazebo's bumper)."""

    link: str = ""


@dataclass(frozen=True)
class TouchDevice(BumpDevice):
    """The contacts of a robot, as published by the newer Gazebo."""


@dataclass(frozen=True)
class PoseDevice(Device):
    """A model's pose in its `world` ('' if unknown), and its links' poses in the model (16 numbers each)."""

    model: str = ""
    world: str = ""
    links: tuple[tuple[str, tuple[float, ...]], ...] = ()


__all__ = [
    "BumpDevice", "CameraDevice", "ControlDevice", "DepthDevice", "Device", "EarthDevice", "ImuDevice", "JointDevice",
    "MotorDevice", "OdometryDevice", "PoseDevice", "RayDevice", "TouchDevice", "TrajectoryDevice", "TruthDevice",
    "WheelDevice",
]  # fmt: skip
