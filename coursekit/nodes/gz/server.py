"""`gz sim WORLD`: the simulator, with the newer Gazebo's names."""

from __future__ import annotations

import argparse
import sys
from typing import Any

import rclpy
from rclpy.context import Context
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.qos import QoSProfile
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

from coursekit.nodes.gazebo.devices import CameraDevice, Device, EarthDevice, ImuDevice, RayDevice
from coursekit.nodes.gazebo.gzserver import simulate
from coursekit.nodes.gazebo.model_conversion import ModelConversion
from coursekit.nodes.gazebo.server import Gazebo
from coursekit.processes.session import current

from .services import GzServices
from .transport import APART, gz_domain

CLASSES = {
    "sensors": "Sensors", "imu": "Imu", "navsat": "NavSat", "altimeter": "Altimeter", "magnetometer": "Magnetometer",
    "air-pressure": "AirPressure",
}  # fmt: skip
"""Systems that sensors need in order to publish, and their classes."""


def system_for(device: Device) -> str:
    """Return the system that a device needs, or ''.

    >>> from coursekit.nodes.gazebo.devices import EarthDevice
    >>> system_for(EarthDevice("/air", "", 1.0, quantity="air_pressure"))
    'air-pressure'
    """
    if isinstance(device, EarthDevice):
        return device.quantity.replace("_", "-")
    return "imu" if isinstance(device, ImuDevice) else "sensors" if isinstance(device, (RayDevice, CameraDevice)) else ""


class GzSim(Gazebo):
    """The simulator in Gazebo's own graph."""

    is_newer = True

    def __init__(self, world: str = "", *, paused: bool = False, seed: int = 0, verbose: bool = False) -> None:
        self._ros: Context | None = None
        self._ros_executor: Any = None
        super().__init__(world, paused=paused, seed=seed, verbose=verbose)
        name = self.newer or "default"
        self._world_clock = self.create_publisher(Clock, f"/world/{name}/clock", QoSProfile(depth=10))
        self._poses = [
            self.create_publisher(TFMessage, f"/world/{name}/{topic}/info", 10) for topic in ("pose", "dynamic_pose")
        ]
        self._gz_services = GzServices(self, name)
        self.create_timer(1 / 60, self._tell_poses)

    def working(self, model: ModelConversion) -> list[Device]:
        """Return the devices that publish. A sensor whose system is missing in the world and model only gets a warning."""
        if self.systems is None:
            return list(model.devices)
        there = self.systems | model.systems | {""}
        working = [device for device in model.devices if system_for(device) in there]
        idle = [system_for(device) for device in model.devices if system_for(device) not in there]
        for system in dict.fromkeys(idle):
            self.get_logger().warning(
                f"{model.name}: {idle.count(system)} sensors publish nothing, as in Gazebo: add to the <world> "
                f'<plugin filename="gz-sim-{system}-system" name="gz::sim::systems::{CLASSES[system]}"/>'
            )
        return working

    def ros_context(self) -> Any:
        """Return a ROS context, separate from Gazebo's own."""
        if self._ros is None:
            self._ros = Context()
            self._ros.init([], domain_id=gz_domain() - APART)
            self._ros_executor = SingleThreadedExecutor(context=self._ros)
            self.session.spawn(self._spin_ros)
        return self._ros

    def ros_executor(self) -> Any:
        """Return the executor of the ROS side."""
        self.ros_context()
        return self._ros_executor

    def _spin_ros(self) -> None:
        try:
            self._ros_executor.spin()
        except ExternalShutdownException:
            pass

    def close(self) -> None:
        """Shut down, including the ROS side."""
        super().close()
        if self._ros is not None:
            self._ros.try_shutdown()

    def _tell_poses(self) -> None:
        if any(pose.get_subscription_count() for pose in self._poses):
            self.advance()
            msg = self._gz_services.poses()
            for pose in self._poses:
                pose.publish(msg)

    def tell_clock(self, msg: Clock) -> None:
        """Publish the simulated time on both of its topics."""
        super().tell_clock(msg)
        self._world_clock.publish(msg)


def arguments(argv: list[str]) -> tuple[argparse.Namespace, list[str]]:
    """Return the known arguments of `gz sim`, and the unknown ones."""
    parser = argparse.ArgumentParser(prog="gz sim", description="Run and manage Gazebo simulations.", add_help=True)
    parser.add_argument("world", nargs="?", default="", help="a world file (SDF, yaml, a map) or one of the course's")
    parser.add_argument("-r", dest="run", action="store_true", help="run the simulation at once; without it, it is paused")
    parser.add_argument("-s", dest="server", action="store_true", help="accepted: there is always a server")
    parser.add_argument("-g", dest="gui", action="store_true", help="nothing to start: look at the world with viewer()")
    parser.add_argument("-v", "--verbose", nargs="?", const="3", default="1", help="4 lists all that is not simulated")
    parser.add_argument("--seed", type=int, default=0, help="seed of noise and drift")
    parser.add_argument("--headless-rendering", action="store_true", help="accepted")
    valued = ("--iterations", "-z", "--gui-config", "--physics-engine", "--render-engine", "--render-engine-server",
              "--render-engine-gui", "--record-path", "--force-version", "--network-role", "--network-secondaries",
              "--levels", "--record-topic", "--playback")  # fmt: skip
    for name in valued:
        parser.add_argument(name, help="accepted")
    parser.add_argument("--record", action="store_true", help="accepted")
    return parser.parse_known_args(argv)


def main(args: list[str] | None = None) -> Any:
    """Run the simulator until Ctrl-C."""
    told, rest = arguments(list(args if args is not None else sys.argv[1:]))
    if told.gui and not told.server:
        print("gz sim -g: the world has no window of its own. Look at it in a notebook, with viewer().")
        current().clock.new_event().wait()
        return 0
    rclpy.init(args=[], domain_id=gz_domain())

    def made() -> GzSim:
        node = GzSim(told.world, paused=not told.run, seed=told.seed, verbose=told.verbose not in ("0", "1", "2", "3"))
        if not told.run:
            types = "--reqtype gz.msgs.WorldControl --reptype gz.msgs.Boolean --timeout 1000"
            start = f"gz service -s /world/{node.newer}/control {types} --req 'pause: false'"
            node.get_logger().info(f"The world is paused: start it with -r, or: {start}")
        return node

    return simulate(made, [f"{word} of gz sim" for word in rest])
