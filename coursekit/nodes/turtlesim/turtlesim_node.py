"""The node `turtlesim`: a world of turtles behind topics, services, parameters and an action.

The window itself is drawn by its viewer: `coursekit.lab.turtlesim_window()` in a notebook.
"""

from __future__ import annotations

from contextlib import closing

import rclpy
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.exceptions import InvalidTopicNameException
from std_srvs.srv import Empty
from turtlesim.srv import Kill, Spawn

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import to_the_end
from coursekit.nodes.turtlesim.simulators import simulators
from coursekit.nodes.turtlesim.turtle import TurtleInterface
from coursekit.processes.process import current_process
from coursekit.processes.session import current
from coursekit.sim.turtle import SIDE, STEP, World

BACKGROUND = {"r": ("Red", 69), "g": ("Green", 86), "b": ("Blue", 255)}


class TurtleSim(CppNode):
    """The simulator."""

    def __init__(self) -> None:
        super().__init__("turtlesim")
        self.session = current()
        self.world = World()
        self.running = True
        self.frames = 0
        self._interfaces: dict[str, TurtleInterface] = {}
        self._declare_parameters()
        self.create_service(Empty, "clear", self._clear)
        self.create_service(Empty, "reset", self._reset)
        self.create_service(Spawn, "spawn", self._spawn)
        self.create_service(Kill, "kill", self._kill)
        self.get_logger().info(f"Starting turtlesim with node name {self.full_name}")
        self._add("", SIDE / 2, SIDE / 2, 0.0)
        self.create_timer(STEP, self._frame)
        simulators.add(self)

    @property
    def full_name(self) -> str:
        """For example '/turtlesim'."""
        return self.get_fully_qualified_name()

    @property
    def namespace(self) -> str:
        """For example '/'."""
        return self.get_namespace()

    def background(self) -> tuple[int, int, int]:
        """The parameters background_r, background_g and background_b."""
        red, green, blue = (int(self.get_parameter(f"background_{channel}").value) for channel in BACKGROUND)
        return red, green, blue

    def close(self) -> None:
        """Stop, and notify the code that draws it."""
        self.running = False
        simulators.remove(self)

    def _declare_parameters(self) -> None:
        for letter, (colour, value) in BACKGROUND.items():
            descriptor = ParameterDescriptor(
                description=f"{colour} channel of the background color",
                integer_range=[IntegerRange(from_value=0, to_value=255, step=1)],
            )
            self.declare_parameter(f"background_{letter}", value, descriptor)
        holonomic = ParameterDescriptor(description="If true, then turtles will be holonomic")
        self.declare_parameter("holonomic", False, holonomic)

    # -- services

    def _clear(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        self.get_logger().info("Clearing turtlesim.")
        self.world.paper.clear()
        return response

    def _reset(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        self.get_logger().info("Resetting turtlesim.")
        for interface in self._interfaces.values():
            interface.close()
        self._interfaces.clear()
        self.world.reset()
        self._add("", SIDE / 2, SIDE / 2, 0.0)
        return response

    def _spawn(self, request: Spawn.Request, response: Spawn.Response) -> Spawn.Response:
        response.name = self._add(request.name, request.x, request.y, request.theta)
        return response

    def _kill(self, request: Kill.Request, response: Kill.Response) -> Kill.Response:
        interface = self._interfaces.pop(request.name, None)
        if interface is None:
            self.get_logger().error(f"Tried to kill turtle [{request.name}], which does not exist")
            return response
        interface.close()
        self.world.kill(request.name)
        return response

    def _add(self, name: str, x: float, y: float, theta: float) -> str:
        """Add a turtle. Return its name, or '' if the name is taken or invalid in topics."""
        now = self.get_clock().now().nanoseconds * 1e-9
        try:
            turtle = self.world.spawn(name, x, y, theta, now)
        except KeyError:
            self.get_logger().error(f"A turtle named [{name}] already exists")
            return ""
        try:
            self._interfaces[turtle.name] = TurtleInterface(self, turtle)
        except InvalidTopicNameException as error:
            self.world.kill(turtle.name)
            self.get_logger().error(f"A turtle's name must be good for topics: {error}")
            return ""
        where = f"x=[{turtle.x:.6f}], y=[{turtle.y:.6f}], theta=[{turtle.theta:.6f}]"
        self.get_logger().info(f"Spawning turtle [{turtle.name}] at {where}")
        return turtle.name

    # -- frames

    def _frame(self) -> None:
        for _, interface in sorted(self._interfaces.items()):
            interface.before_step()
        hits = self.world.step(self.get_clock().now().nanoseconds * 1e-9)
        for _turtle, (x, y) in hits:
            self.get_logger().warning(f"Oh no! I hit the wall! (Clamping from [x={x:.6f}, y={SIDE - y:.6f}])")
        for _, interface in sorted(self._interfaces.items()):
            interface.after_step()
        self.frames += 1
        simulators.tell(self)


def main(args: list[str] | None = None) -> int:
    """Run the simulator until Ctrl-C."""
    rclpy.init(args=args)
    node = TurtleSim()
    process = current_process()
    if process is not None:
        process.cleanups.append(node.close)
    with to_the_end(node), closing(node):
        rclpy.spin(node)
    return 0
