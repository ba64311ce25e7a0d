"""`ros2 run nav2_controller controller_server`: follows paths, avoiding obstacles in the local costmap."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import Twist
from nav2_msgs.action import FollowPath
from nav2_msgs.msg import SpeedLimit
from nav_msgs.msg import Odometry, Path
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn

from coursekit.nav.checkers import GoalChecker
from coursekit.nav.controller import Controller
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.controller_parameters import SERVER, controller, goal_checkers, progress_checker
from coursekit.nodes.nav2.costmap_node import CostmapNode
from coursekit.nodes.nav2.cpp_controller import CppController, CppGoalChecker
from coursekit.nodes.nav2.cpp_plugins import CppPlugins
from coursekit.nodes.nav2.drive import CppDrive, Drive
from coursekit.nodes.nav2.local_plan import LocalPlan
from coursekit.nodes.nav2.parameters import Obedience, declare
from coursekit.nodes.nav2.running import AsyncRate, Server, run

if TYPE_CHECKING:
    from rclpy.action.goal_handle import ServerGoalHandle


class ControllerServer(Server):
    """Provides the action follow_path; publishes cmd_vel."""

    def __init__(self) -> None:
        super().__init__("controller_server")
        declare(self, SERVER)
        self.costmap = CostmapNode("local_costmap", self)
        self._foreign = CppPlugins(self, self.costmap)

    # -- states

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Configure the costmap, create the plugins; FAILURE for invalid parameters."""
        self.get_logger().info("Configuring controller interface")
        self.get_logger().info("getting goal checker plugins..")
        try:
            self.get_logger().info(f"Controller frequency set to {self.number('controller_frequency'):.4f}Hz")
        except ValueError as fault:
            return self._foreign.refused(fault)
        if self.costmap.trigger_configure() != TransitionCallbackReturn.SUCCESS:
            return TransitionCallbackReturn.FAILURE
        try:
            self._make_plugins()
        except (ValueError, CppFault) as fault:
            self.costmap.trigger_cleanup()
            return self._foreign.refused(fault)
        self._make_topics()
        self._obedience = Obedience(self, self._make_plugins)
        self.serve(FollowPath, "follow_path", self._follow)
        return super().on_configure(state)

    def _make_plugins(self) -> None:
        """Read the parameters. ValueError for invalid ones."""
        given = declare(self, SERVER)
        frequency = given["controller_frequency"]
        if not frequency > 0:
            raise ValueError(f"controller_frequency is {frequency}: give Hz, for example 20.0")
        self._period, self.patience = 1.0 / frequency, given["failure_tolerance"]
        self.progress = progress_checker(self, given["progress_checker_plugin"], self._foreign)
        self._goals = goal_checkers(self, given["goal_checker_plugins"], self._foreign)
        self._foreign.log_available("Controller Server", "goal checkers", self._goals)
        self._controllers = {
            name: controller(self, name, self.costmap, self._period, self._foreign) for name in given["controller_plugins"]
        }
        self._foreign.log_available("Controller Server", "controllers", self._controllers)

    def _make_topics(self) -> None:
        self.velocity, self._limit, self._limit_share = Twist(), 0.0, 0.0
        self._cmd_out = self.create_lifecycle_publisher(Twist, "cmd_vel", 1)
        self._plan_out = self.create_lifecycle_publisher(Path, "received_global_plan", 1)
        self.local_plan = LocalPlan(self)
        self._heard = [
            self.create_subscription(Odometry, self.text("odom_topic"), self._take_odometry, 10),
            self.create_subscription(SpeedLimit, self.text("speed_limit_topic"), self._take_limit, 10),
        ]

    def activate_parts(self) -> bool:
        """Activate the costmap and the plugins."""
        if self.costmap.trigger_activate() is not TransitionCallbackReturn.SUCCESS:
            return False
        self._foreign.change("activate")
        return True

    def deactivate_parts(self) -> None:
        """Deactivate the plugins, stop the robot and deactivate the costmap."""
        self._foreign.change("deactivate")
        self.stop()
        self.costmap.trigger_deactivate()

    def clean_parts(self) -> None:
        """Destroy the plugins and the costmap."""
        self._obedience.end()
        self._foreign.retire()
        self.costmap.trigger_cleanup()
        for heard in self._heard:
            self.destroy_subscription(heard)
        self.local_plan.destroy()
        for publisher in (self._cmd_out, self._plan_out):
            self.destroy_lifecycle_publisher(publisher)

    # -- inputs

    def _take_odometry(self, msg: Odometry) -> None:
        self.velocity = msg.twist.twist

    def _take_limit(self, msg: SpeedLimit) -> None:
        """Handle a limit in m/s, or in percent of the maximum speed; 0 means no limit."""
        self._limit, self._limit_share = (0.0, msg.speed_limit / 100) if msg.percentage else (msg.speed_limit, 0.0)
        for known in self._controllers.values():
            if isinstance(known, CppController):
                known.limit(msg.speed_limit, msg.percentage)

    @property
    def speeds(self) -> tuple[float, float]:
        """How fast the robot drives [m/s] and turns [rad/s]."""
        return self.velocity.linear.x, self.velocity.angular.z

    def top(self, one: Controller) -> float:
        """Return the speed to which a controller is limited; 0 for none."""
        return self._limit or self._limit_share * one.limits.max_speed

    # -- path following

    async def _follow(self, handle: ServerGoalHandle) -> Any:
        """Drive until the goal is reached, fails, or is cancelled."""
        result, request = FollowPath.Result(), handle.request
        fault = self._unknown(request)
        if fault:
            self.get_logger().error(fault)
            handle.abort()
            self.stop()
            return result
        fresh = self.actions[0].fresh
        self.get_logger().info(
            "Received a goal, begin computing control effort." if fresh else "Passing new path to controller."
        )
        self._plan_out.publish(request.path)
        chosen = self._controllers[request.controller_id or next(iter(self._controllers))]
        drive = CppDrive(self, handle, chosen) if isinstance(chosen, CppController) else Drive(self, handle, chosen)
        rate = AsyncRate(self, self._period)
        try:
            while not drive.step():
                await rate.sleep()
        finally:
            rate.destroy()
        return result

    def _unknown(self, request: FollowPath.Goal) -> str:
        """Return what is wrong with a goal, or ''."""
        if request.controller_id and request.controller_id not in self._controllers:
            known = ", ".join(self._controllers)
            return f"FollowPath called with controller name {request.controller_id}, which does not exist. Known: {known}"
        if request.goal_checker_id and request.goal_checker_id not in self._goals:
            known = ", ".join(self._goals)
            return (
                f"FollowPath called with goal_checker name {request.goal_checker_id}, which does not exist. Known: {known}"
            )
        return "" if request.path.poses else "Invalid path, Path is empty."

    def goal_checker(self, name: str) -> GoalChecker | CppGoalChecker:
        """Return a goal checker by name, or the first one."""
        return self._goals[name or next(iter(self._goals))]

    def drive(self, velocity: Twist) -> None:
        """Publish the velocity command."""
        self._cmd_out.publish(velocity)

    def stop(self) -> None:
        """Let the robot stand."""
        self.drive(Twist())


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(ControllerServer, args)
