"""`ros2 run nav2_planner planner_server`: plans paths in the global costmap."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import PoseStamped
from nav2_msgs.action import ComputePathThroughPoses, ComputePathToPose
from nav2_msgs.srv import IsPathValid
from nav_msgs.msg import Path
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn
from tf2_ros import TransformException

from coursekit.geometry.plane import Pose2D
from coursekit.nav.costmap import Costmap
from coursekit.nav.planner import PlanError, Planner
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.costmap_node import CostmapNode
from coursekit.nodes.nav2.cpp_planner import CppPlanner
from coursekit.nodes.nav2.cpp_plugins import CppPlugins
from coursekit.nodes.nav2.parameters import Obedience, declare
from coursekit.nodes.nav2.running import AsyncRate, Server, run
from coursekit.nodes.nav2.transform_lookup import path_message, stamped
from coursekit.nodes.scanning.planar import plane

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time as TimeMsg
    from rclpy.action.goal_handle import ServerGoalHandle

_SERVER = {"planner_plugins": ["GridBased"], "expected_planner_frequency": 1.0}
PATIENCE = 30
"""How long a goal waits for the first costmap, in tenths of a second."""
_USUAL = "nav2_navfn_planner/NavfnPlanner"
_KINDS = {
    _USUAL: 0.5,
    "nav2_smac_planner/SmacPlanner2D": 0.125,
    "nav2_smac_planner/SmacPlannerHybrid": 0.25,
    "nav2_smac_planner/SmacPlannerLattice": 0.25,
    "nav2_theta_star_planner/ThetaStarPlanner": 0.5,
}
"""Planner plugins, all made by the same search, and their tolerances [m]."""
_PLUGIN = {"tolerance": 0.5, "allow_unknown": True, "use_astar": False, "cost_factor": 0.8}


class PlannerServer(Server):
    """The actions compute_path_to_pose and compute_path_through_poses, the service is_path_valid."""

    def __init__(self) -> None:
        super().__init__("planner_server")
        declare(self, _SERVER)
        self.costmap = CostmapNode("global_costmap", self)
        self._foreign = CppPlugins(self, self.costmap)
        self._planners: dict[str, Planner | CppPlanner] = {}
        self._ends: list[tuple[Pose2D, tuple[float, float]]] = []
        """The goals of the last plan, and where the ways to them ended."""

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Bring the costmap up, make the planners; FAILURE when a parameter cannot work."""
        self.get_logger().info("Configuring")
        if self.costmap.trigger_configure() != TransitionCallbackReturn.SUCCESS:
            return TransitionCallbackReturn.FAILURE
        try:
            self._make_planners()
        except (ValueError, CppFault) as fault:
            self.costmap.trigger_cleanup()
            return self._foreign.refused(fault)
        self._obedience = Obedience(self, self._make_planners)
        self._plan_out = self.create_lifecycle_publisher(Path, "plan", 1)
        self.serve(ComputePathToPose, "compute_path_to_pose", self._to_pose)
        self.serve(ComputePathThroughPoses, "compute_path_through_poses", self._through_poses)
        self._valid = self.create_service(IsPathValid, "is_path_valid", self._is_valid)
        return super().on_configure(state)

    def _make_planners(self) -> None:
        """Take the parameters; ValueError when they cannot work."""
        self._planners = {name: self._make(name) for name in declare(self, _SERVER)["planner_plugins"]}
        self._foreign.log_available("Planner Server", "planners", self._planners)

    def _make(self, name: str) -> Planner | CppPlanner:
        kind = declare(self, {"plugin": _USUAL}, name)["plugin"]
        if kind not in _KINDS:
            return self._foreign.get(CppPlanner, name, kind, _KINDS)
        given = declare(self, {**_PLUGIN, "tolerance": _KINDS[kind]}, name)
        self._foreign.log_created(CppPlanner, name, kind)
        return Planner(given["tolerance"], given["allow_unknown"], given["cost_factor"])

    def activate_parts(self) -> bool:
        """Activate the costmap and the planners."""
        if self.costmap.trigger_activate() is not TransitionCallbackReturn.SUCCESS:
            return False
        self._foreign.change("activate")
        return True

    def deactivate_parts(self) -> None:
        """Deactivate the planners and the costmap."""
        self._foreign.change("deactivate")
        self.costmap.trigger_deactivate()

    def clean_parts(self) -> None:
        """Destroy planners and costmap."""
        self._obedience.end()
        self._foreign.retire()
        self.costmap.trigger_cleanup()
        self._planners.clear()
        self.destroy_service(self._valid)
        self.destroy_lifecycle_publisher(self._plan_out)

    # -- planning

    async def _to_pose(self, handle: ServerGoalHandle) -> Any:
        return await self._answer(handle, ComputePathToPose.Result(), [handle.request.goal])

    async def _through_poses(self, handle: ServerGoalHandle) -> Any:
        return await self._answer(handle, ComputePathThroughPoses.Result(), handle.request.goals)

    async def _answer(
        self, handle: ServerGoalHandle, result: ComputePathToPose.Result | ComputePathThroughPoses.Result, goals: list[Any]
    ) -> Any:
        """Plan through the goals, and tell."""
        if not await self._costs_come(handle):
            handle.canceled() if handle.is_cancel_requested else handle.abort()
            return result
        begin, stopwatch = self.get_clock().now(), time.perf_counter()
        try:
            result.path = self._plan(handle.request, goals, begin.to_msg())
        except (PlanError, TransformException) as fault:
            self.get_logger().warning(str(fault))
            handle.abort()
            return result
        result.planning_time = Duration(nanoseconds=(self.get_clock().now() - begin).nanoseconds).to_msg()
        self._plan_out.publish(result.path)
        self._complain(time.perf_counter() - stopwatch)
        handle.succeed()
        return result

    def _complain(self, seconds: float) -> None:
        wanted = self.number("expected_planner_frequency")
        if wanted > 0 and seconds > 1 / wanted:
            self.get_logger().warning(
                f"Planner loop missed its desired rate of {wanted:.4f} Hz. Current loop rate is {1 / seconds:.4f} Hz"
            )

    def _plan(
        self, request: ComputePathToPose.Goal | ComputePathThroughPoses.Goal, goals: list[Any], stamp: TimeMsg
    ) -> Path:
        """Return the whole way. Raises PlanError, TransformException."""
        name = request.planner_id or next(iter(self._planners))
        if name not in self._planners:
            known = " ".join(self._planners)
            raise PlanError(f"planner {name} is not a valid planner. Planner names are: {known}")
        if not goals:
            raise PlanError("Compute path through poses requested a plan with no viapoint poses, returning.")
        costs = self._costs()
        frame, where = self.costmap.frame, self.costmap.where
        at = where.pose_in(frame, request.start) if request.use_start else where.robot(frame)
        whole, ends = Path(), []
        for goal in goals:
            to = where.pose_in(frame, goal)
            piece = self._piece(name, costs, stamped(at, frame, stamp), stamped(to, frame, stamp))
            whole.header = piece.header
            met = bool(whole.poses) and whole.poses[-1].pose == piece.poses[0].pose
            whole.poses += piece.poses[met:]
            last = piece.poses[-1].pose
            at = plane(last.position, last.orientation)
            ends.append((to, (at.x, at.y)))
        self._ends = ends
        return whole

    def _piece(self, name: str, costs: Costmap, start: PoseStamped, goal: PoseStamped) -> Path:
        """Return the way from a pose to another. Raises PlanError."""
        planner, to = self._planners[name], goal.pose.position
        try:
            if isinstance(planner, CppPlanner):
                path = planner.plan(start, goal)
            else:
                path = self._searched(planner, costs, start, goal)
        except (PlanError, CppFault) as fault:
            raise PlanError(f'{name} plugin failed to plan calculation to ({to.x:.2f}, {to.y:.2f}): "{fault}"') from None
        if not path.poses:
            raise PlanError(f"Planning algorithm {name} failed to generate a valid path to ({to.x:.2f}, {to.y:.2f})")
        return path

    def _searched(self, planner: Planner, costs: Costmap, start: PoseStamped, goal: PoseStamped) -> Path:
        at, to = (plane(stamped.pose.position, stamped.pose.orientation) for stamped in (start, goal))
        before = next((end for last, end in self._ends if last.distance(to) < costs.resolution), None)
        return path_message(planner.plan(costs, at, to, before), self.costmap.frame, start.header.stamp)

    async def _costs_come(self, handle: ServerGoalHandle) -> bool:
        """Wait a little for the first map and the first transform; whether someone still wants the path."""
        rate = AsyncRate(self, 0.1)
        try:
            for _ in range(PATIENCE):
                wanted = not handle.is_cancel_requested and self.actions[0].active
                if not wanted or self.costmap.latest is not None:
                    return wanted
                await rate.sleep()
                self.costmap.fresh()
        finally:
            rate.destroy()
        return True

    def _costs(self) -> Costmap:
        costs = self.costmap.latest or self.costmap.fresh()
        if costs is None:
            raise PlanError(
                "The global costmap has no map or no robot yet: is map_server active, and does tf know "
                f"{self.costmap.frame} -> {self.costmap.given['robot_base_frame']}? (2D Pose Estimate tells amcl)"
            )
        return costs

    def _is_valid(self, request: IsPathValid.Request, response: IsPathValid.Response) -> IsPathValid.Response:
        costs = self.costmap.latest
        if costs is None:
            return response
        path = request.path.poses
        poses = [plane(stamped.pose.position, stamped.pose.orientation) for stamped in path]
        response.is_valid = bool(poses) and all(costs.cost(pose.x, pose.y) not in (253, 254) for pose in poses)
        return response


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(PlannerServer, args)
