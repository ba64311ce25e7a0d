"""The simulator: a world in motion, its clock, and the devices of its robots."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rosgraph_msgs.msg import Clock

from coursekit.processes.session import current
from coursekit.sim import Simulation, WorldError

from .articulated import Articulated
from .cameras import CameraPublisher
from .controlled import ControlPublisher
from .depth import DepthPublisher
from .devices import (
    CameraDevice,
    ControlDevice,
    DepthDevice,
    Device,
    EarthDevice,
    OdometryDevice,
    PoseDevice,
    TouchDevice,
    TrajectoryDevice,
    TruthDevice,
    WheelDevice,
)  # fmt: skip
from .earth_publishers import EarthPublisher
from .entity_poses import EntityPoses
from .forces import Forces
from .gz_publishers import PosePublisher, TouchPublisher
from .model_conversion import ModelConversion
from .odometry_publishers import OdometryPublisher, TruthPublisher
from .precompile import warm_up
from .sensor_publishers import PUBLISHERS, SensorPublisher, stamp_of
from .services import Services
from .settling import settled
from .sim_time import SimTime
from .simulators import simulators
from .states import States
from .trajectory_publisher import TrajectoryPublisher
from .wheel_frames import WheelPublisher
from .world_lookup import open_world

if TYPE_CHECKING:
    from coursekit.sim.robot import Robot

FURTHER: dict[type, type[SensorPublisher]] = {
    CameraDevice: CameraPublisher, DepthDevice: DepthPublisher, ControlDevice: ControlPublisher,
    TrajectoryDevice: TrajectoryPublisher, PoseDevice: PosePublisher, TouchDevice: TouchPublisher,
    EarthDevice: EarthPublisher, WheelDevice: WheelPublisher, OdometryDevice: OdometryPublisher, TruthDevice: TruthPublisher,
}  # fmt: skip


class Gazebo(Node):
    """The simulator: a world in motion, its clock, and the devices of its robots."""

    is_newer = False
    """Whether files are read like in the newer Gazebo."""

    def __init__(self, world: str = "", *, paused: bool = False, seed: int = 0, verbose: bool = False) -> None:
        super().__init__("gazebo")
        self.session = current()
        self.verbose = verbose
        opened = open_world(world, self.is_newer)
        loaded = opened.world
        self.newer = loaded.name if self.is_newer else None
        self.systems = opened.systems
        self.simulation = Simulation(loaded, seed)
        self.time = SimTime(self.session.clock, paused)
        self.assemblies: dict[str, ModelConversion] = {}
        self.sensors: dict[str, list[SensorPublisher]] = {}
        self.executor_ = SingleThreadedExecutor(context=self.context)
        self.executor_.add_node(self)
        self._nodes: dict[str, Any] = {}
        self._commands: dict[str, list[Any]] = {}
        self._rate = float(self.declare_parameter("publish_rate", 100.0).value) or 100.0
        self._clock_out = self.create_publisher(Clock, "/clock", QoSProfile(depth=10))
        self._clock_count = self._planned = 0
        self.around = EntityPoses(self)
        self._api = (Services(self), States(self, opened.state), Forces(self))
        warm_up()
        self.tell(list(loaded.notes))
        for model in opened.models:
            self._admit(model)
        self.get_logger().info(f"World '{loaded.name}' with {len(self.around.models())} models")
        simulators.add(self)

    # -- models

    def _admit(self, model: ModelConversion) -> None:
        """Add a model of the world's file, whose things are already there. A robot without room is reported."""
        try:
            if model.robot is not None:
                self._equip(model, self.simulation.spawn(model.robot, model.name, model.place))
        except WorldError as error:
            self.get_logger().error(str(error))
        self.assemblies[model.name] = model

    def put(self, model: ModelConversion) -> None:
        """Add a model to the world, and start its devices. Raises WorldError."""
        self.advance()
        for thing in settled(model.things):
            self.simulation.add(thing)
        if model.robot is not None:
            robot = self.simulation.spawn(model.robot, model.name, model.place)
            self._equip(model, robot)
        self.assemblies[model.name] = model
        self.tell(model.notes)

    def _equip(self, model: ModelConversion, robot: Robot) -> None:
        begin = self.time.now()
        sensors = self.sensors[model.name] = []
        for number, device in enumerate(self.working(model)):
            node = self.ros_node(device) if isinstance(device, ControlDevice) else self.node_of(device.node)
            kind = FURTHER.get(type(device)) or PUBLISHERS[type(device)]
            seed = (self.simulation.seed * 1000 + len(self.assemblies)) * 100 + number
            sensors.append(kind(node, self.simulation, robot, device, seed, begin))
            if isinstance(device, OdometryDevice) and device.command_topic:
                twist = TwistStamped if device.stamped else Twist
                bend = device.by_rate

                def hear(msg: Twist | TwistStamped, bend: bool = bend) -> None:
                    self._command(robot, msg, bend)

                heard = node.create_subscription(twist, device.command_topic, hear, 10)
                self._commands.setdefault(model.name, []).append((node, heard))

    def working(self, model: ModelConversion) -> list[Device]:
        """Return the devices of a model that are active in this world."""
        return model.devices

    def _command(self, robot: Robot, msg: Twist | TwistStamped, by_rate: bool = False) -> None:
        self.advance()
        twist, drive = msg.twist if isinstance(msg, TwistStamped) else msg, robot.model.drive
        ahead, turn = twist.linear.x, twist.angular.z
        if by_rate and drive is not None:  # the wheel angle of a car with this rotation rate
            turn = math.atan(drive.wheelbase * turn / ahead) if ahead else 0.0
        robot.command(ahead, turn, twist.linear.y, now_ns=self.simulation.now_ns)

    def node_of(self, full_name: str) -> Any:
        """Return the node of a plugin, made on first use."""
        if full_name not in self._nodes:
            space, _, name = full_name.rpartition("/")
            node = rclpy.create_node(name or "plugin", namespace=space or "/", context=self.context)
            self.executor_.add_node(node)
            self._nodes[full_name] = node
        return self._nodes[full_name]

    def ros_node(self, device: ControlDevice) -> Any:
        """Make a node in ROS for the controller manager of a robot."""
        space, _, name = device.node.rpartition("/")
        words = device.arguments()
        node = Node(
            name, namespace=space or "/", context=self.ros_context(), cli_args=["--ros-args", *words] if words else None,
            use_global_arguments=False, allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
        )  # fmt: skip
        self.ros_executor().add_node(node)
        return node

    def ros_context(self) -> Any:
        """The context of nodes in ROS."""
        return self.context

    def ros_executor(self) -> Any:
        """The executor of these nodes."""
        return self.executor_

    def take_out(self, name: str) -> None:
        """Remove a model; LookupError if there is none."""
        self.simulation.remove(name)
        self.assemblies.pop(name, None)
        for sensor in self.sensors.pop(name, []):
            sensor.close()
        for node, heard in self._commands.pop(name, []):
            node.destroy_subscription(heard)

    def delete(self, name: str) -> None:
        """Remove a model permanently, also one without any contacts."""
        self.advance()
        with contextlib.suppress(LookupError):
            self.take_out(name)
        self.around.deleted.add(name)

    def tell(self, notes: list[str]) -> None:
        """Report the parts of a file that are not simulated."""
        if notes and not self.verbose and len(notes) > 8:
            notes = [*notes[:8], f"... and {len(notes) - 8} more; verbose:=true lists all"]
        for note in notes:
            self.get_logger().warning(f"Not simulated: {note}")

    # -- time

    def advance(self) -> int:
        """Advance the physics to the present. Returns the simulated time [ns]."""
        self.time.keep_up(self._planned)
        now = self.time.now()
        self.simulation.advance_to(now)
        for name, model in self.assemblies.items():
            if model.articulated is not None and name in self.simulation.robots:
                self._articulate(name, model, model.articulated)
        return now

    def _articulate(self, name: str, model: ModelConversion, articulated: Articulated) -> None:
        """Update an arm's links from its joints."""
        moved = self.simulation.robots[name].motors.moved()
        if articulated.has_moved(moved):
            model.frames, parts = articulated.at(moved)
            if parts:
                self.simulation.reshape(name, parts)

    def pause(self, pause: bool) -> None:
        """Pause the simulation, or resume it."""
        self.advance()
        (self.time.pause if pause else self.time.go_on)()

    def step(self, seconds: float) -> None:
        """Advance by some simulated time, then pause."""
        self.pause(True)
        self.time.set(self.time.now() + round(seconds * 1e9))
        self._do_due()

    def restart(self, time: bool) -> None:
        """Move everything to its start pose, and reset the time if requested."""
        self.advance()
        self.simulation.reset(time)
        if time:
            self.time.set(0)
            self._clock_count = self._planned = 0
            for sensor in self._all():
                sensor.restart(0)

    def _all(self) -> list[SensorPublisher]:
        return [sensor for sensors in self.sensors.values() for sensor in sensors]

    def work(self) -> float:
        """Do all work that is due. Returns the seconds until the next."""
        if self.time.paused:
            return 0.1
        due = self._do_due()
        return max(0.0, (due - self.time.now()) * 1e-9 / self.time.speed)

    def _do_due(self) -> int:
        """Do all work that is due. Returns the simulated time of the next [ns]."""
        now = self.advance()
        while (clock := self._clock_due()) <= now:
            self._clock_count = max(self._clock_count + 1, int((now - 20_000_000) * 1e-9 * self._rate))
            self.tell_clock(Clock(clock=stamp_of(clock)))
        sensors = self._all()
        for sensor in sensors:
            while sensor.due_ns <= now:
                if now - sensor.due_ns > 200_000_000:
                    sensor.restart(now)
                sensor.work()
        self._planned = min([self._clock_due(), *(sensor.due_ns for sensor in sensors)])
        return self._planned

    def tell_clock(self, msg: Clock) -> None:
        """Publish the simulated time."""
        self._clock_out.publish(msg)

    def _clock_due(self) -> int:
        return round(self._clock_count * 1e9 / self._rate)

    def soon(self, work: Callable[..., Any], *values: Any) -> None:
        """Schedule work in the simulator's own thread, from any thread. Failures are logged."""
        self.executor_.create_task(self._try, work, *values)

    def _try(self, work: Callable[..., Any], *values: Any) -> None:
        try:
            work(*values)
        except (WorldError, LookupError) as error:
            self.get_logger().error(str(error.args[0] if isinstance(error, LookupError) else error))

    def spin(self) -> None:
        """Simulate until the context ends."""
        if not self.time.paused:
            self.time.set(0)  # loading took some time
        while self.context.ok():
            wait = self.work()
            self.executor_.spin_once(timeout_sec=wait)

    def close(self) -> None:
        """Close the simulator, and notify its viewers."""
        simulators.remove(self)


__all__ = ["Gazebo"]
