"""BasicNavigator: navigation under the control of a program. In ROS 2: nav2_simple_commander.robot_navigator.

from nav2_simple_commander.robot_navigator import BasicNavigator, TaskResult
"""

from __future__ import annotations

from typing import Any

from builtin_interfaces.msg import Duration
from geometry_msgs.msg import Point, PoseStamped, PoseWithCovarianceStamped
from nav2_msgs.action import (
    AssistedTeleop,
    BackUp,
    ComputePathThroughPoses,
    ComputePathToPose,
    FollowPath,
    FollowWaypoints,
    NavigateThroughPoses,
    NavigateToPose,
    SmoothPath,
    Spin,
)
from nav2_msgs.srv import ClearEntireCostmap, GetCostmap, LoadMap, ManageLifecycleNodes
from rclpy.duration import Duration as rclpyDuration
from rclpy.qos import QoSDurabilityPolicy, QoSHistoryPolicy, QoSProfile, QoSReliabilityPolicy

from nav2_simple_commander.servers import Servers, place_of
from nav2_simple_commander.task_result import TaskResult

NavigationResult = TaskResult
"""The name before Humble; programs and courses of that time use it."""
_AMCL_QOS = QoSProfile(
    durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
    reliability=QoSReliabilityPolicy.RELIABLE,
    history=QoSHistoryPolicy.KEEP_LAST,
    depth=1,
)


class BasicNavigator(Servers):
    """Sends tasks to navigation and reports their progress. A task begins at once; `isTaskComplete` polls for its end."""

    def __init__(self, node_name: str = "basic_navigator", namespace: str = "") -> None:
        super().__init__(node_name, namespace)
        self.initial_pose = PoseStamped()
        self.initial_pose.header.frame_id = "map"
        self.initial_pose_received = False
        self.localization_pose_sub = self.create_subscription(
            PoseWithCovarianceStamped, "amcl_pose", self._amclPoseCallback, _AMCL_QOS
        )
        self.initial_pose_pub = self.create_publisher(PoseWithCovarianceStamped, "initialpose", 10)
        self._navigator_make_clients()

    def _navigator_make_clients(self) -> None:
        """Create the clients under the names that programs use."""
        self.nav_to_pose_client = self._navigator_action(NavigateToPose, "navigate_to_pose")
        self.nav_through_poses_client = self._navigator_action(NavigateThroughPoses, "navigate_through_poses")
        self.follow_waypoints_client = self._navigator_action(FollowWaypoints, "follow_waypoints")
        self.follow_path_client = self._navigator_action(FollowPath, "follow_path")
        self.compute_path_to_pose_client = self._navigator_action(ComputePathToPose, "compute_path_to_pose")
        self.compute_path_through_poses_client = self._navigator_action(
            ComputePathThroughPoses, "compute_path_through_poses"
        )
        self.smoother_client = self._navigator_action(SmoothPath, "smooth_path")
        self.spin_client, self.backup_client = self._navigator_action(Spin, "spin"), self._navigator_action(BackUp, "backup")
        self.assisted_teleop_client = self._navigator_action(AssistedTeleop, "assisted_teleop")
        self.change_maps_srv = self.create_client(LoadMap, "map_server/load_map")
        clear, get = ClearEntireCostmap, GetCostmap
        self.clear_costmap_global_srv = self.create_client(clear, "global_costmap/clear_entirely_global_costmap")
        self.clear_costmap_local_srv = self.create_client(clear, "local_costmap/clear_entirely_local_costmap")
        self.get_costmap_global_srv = self.create_client(get, "global_costmap/get_costmap")
        self.get_costmap_local_srv = self.create_client(get, "local_costmap/get_costmap")

    # -- the robot's pose

    def setInitialPose(self, initial_pose: PoseStamped) -> None:
        """Publish the robot's pose for amcl."""
        self.initial_pose_received = False
        self.initial_pose = initial_pose
        self._setInitialPose()

    def _setInitialPose(self) -> None:
        msg = PoseWithCovarianceStamped()
        msg.header = self.initial_pose.header
        msg.pose.pose = self.initial_pose.pose
        self.info("Publishing Initial Pose")
        self.initial_pose_pub.publish(msg)

    def _amclPoseCallback(self, msg: PoseWithCovarianceStamped) -> None:
        self.debug("Received amcl pose")
        self.initial_pose_received = True

    def waitUntilNav2Active(self, navigator: str = "bt_navigator", localizer: str = "amcl") -> None:
        """Wait until navigation accepts goals and amcl knows the robot's pose; robot_localization has no states."""
        if localizer != "robot_localization":
            self._waitForNodeToActivate(localizer)
        if localizer == "amcl":
            self._waitForInitialPose()
        self._waitForNodeToActivate(navigator)
        self.info("Nav2 is ready for use!")

    def _waitForInitialPose(self) -> None:
        """Publish the initial pose until amcl answers."""
        while not self.initial_pose_received:
            self.info("Setting initial pose")
            self._setInitialPose()
            self.info("Waiting for amcl_pose to be received")
            self._navigator_wait(1.0)

    # -- tasks

    def goToPose(self, pose: PoseStamped, behavior_tree: str = "") -> bool:
        """Go to a pose."""
        self.info(f"Navigating to goal: {place_of(pose)}...")
        goal = NavigateToPose.Goal(pose=pose, behavior_tree=behavior_tree)
        return self._navigator_give(self.nav_to_pose_client, "NavigateToPose", goal, f"Goal to {place_of(pose)}")

    def goThroughPoses(self, poses: list[PoseStamped], behavior_tree: str = "") -> bool:
        """Go to the last pose through the others."""
        self.info(f"Navigating with {len(poses)} goals....")
        goal = NavigateThroughPoses.Goal(poses=poses, behavior_tree=behavior_tree)
        return self._navigator_give(
            self.nav_through_poses_client, "NavigateThroughPoses", goal, f"Goal with {len(poses)} poses"
        )

    def followWaypoints(self, poses: list[PoseStamped]) -> bool:
        """Go to one pose after the other, stopping at each."""
        self.info(f"Following {len(poses)} goals....")
        goal = FollowWaypoints.Goal(poses=poses)
        return self._navigator_give(
            self.follow_waypoints_client, "FollowWaypoints", goal, f"Following {len(poses)} waypoints request"
        )

    def followPath(self, path: Any, controller_id: str = "", goal_checker_id: str = "") -> bool:
        """Drive along a path."""
        self.info("Executing path...")
        goal = FollowPath.Goal(path=path, controller_id=controller_id, goal_checker_id=goal_checker_id)
        return self._navigator_give(self.follow_path_client, "FollowPath", goal, "Follow path")

    def spin(self, spin_dist: float = 1.57, time_allowance: int = 10) -> bool:
        """Rotate in place by `spin_dist` [rad], for at most `time_allowance` seconds."""
        self.info(f"Spinning to angle {spin_dist}....")
        goal = Spin.Goal(target_yaw=float(spin_dist), time_allowance=Duration(sec=time_allowance))
        return self._navigator_give(self.spin_client, "Spin", goal, "Spin request")

    def backup(self, backup_dist: float = 0.15, backup_speed: float = 0.025, time_allowance: int = 10) -> bool:
        """Drive straight back [m, m/s], for at most `time_allowance` seconds."""
        self.info(f"Backing up {backup_dist} m at {backup_speed} m/s....")
        goal = BackUp.Goal(
            target=Point(x=float(backup_dist)), speed=float(backup_speed), time_allowance=Duration(sec=time_allowance)
        )
        return self._navigator_give(self.backup_client, "Backup", goal, "Backup request")

    def assistedTeleop(self, time_allowance: int = 30) -> bool:
        """Drive by teleoperation (topic cmd_vel_teleop), with brakes, for `time_allowance` seconds; 0 is without limit."""
        self.info("Running 'assisted_teleop'....")
        goal = AssistedTeleop.Goal(time_allowance=Duration(sec=time_allowance))
        return self._navigator_give(self.assisted_teleop_client, "assisted_teleop", goal, "Assisted Teleop request")

    # -- paths

    def _getPathImpl(self, start: PoseStamped, goal: PoseStamped, planner_id: str = "", use_start: bool = False) -> Any:
        asked = ComputePathToPose.Goal(start=start, goal=goal, planner_id=planner_id, use_start=use_start)
        self.info("Getting path...")
        return self._navigator_have_done(self.compute_path_to_pose_client, "ComputePathToPose", asked, "Get path")

    def getPath(self, start: PoseStamped, goal: PoseStamped, planner_id: str = "", use_start: bool = False) -> Any:
        """A path from the robot (with `use_start`: from `start`) to a goal; None when there is none."""
        result = self._getPathImpl(start, goal, planner_id, use_start)
        return result.path if result else None

    def getPathThroughPoses(
        self, start: PoseStamped, goals: list[PoseStamped], planner_id: str = "", use_start: bool = False
    ) -> Any:
        """A path through some poses; None when there is none."""
        asked = ComputePathThroughPoses.Goal(start=start, goals=goals, planner_id=planner_id, use_start=use_start)
        self.info("Getting path...")
        result = self._navigator_have_done(
            self.compute_path_through_poses_client, "ComputePathThroughPoses", asked, "Get path"
        )
        return result.path if result else None

    def _smoothPathImpl(
        self, path: Any, smoother_id: str = "", max_duration: float = 2.0, check_for_collision: bool = False
    ) -> Any:
        asked = SmoothPath.Goal(
            path=path, smoother_id=smoother_id, max_smoothing_duration=rclpyDuration(seconds=max_duration).to_msg(),
            check_for_collisions=check_for_collision,
        )  # fmt: skip
        self.info("Smoothing path...")
        return self._navigator_have_done(self.smoother_client, "SmoothPath", asked, "Smooth path")

    def smoothPath(
        self, path: Any, smoother_id: str = "", max_duration: float = 2.0, check_for_collision: bool = False
    ) -> Any:
        """A smoothed path; None when smoothing failed."""
        result = self._smoothPathImpl(path, smoother_id, max_duration, check_for_collision)
        return result.path if result else None

    # -- maps

    def changeMap(self, map_filepath: str) -> None:
        """Load another map in map_server."""
        answer = self._navigator_call(self.change_maps_srv, "change map", LoadMap.Request(map_url=map_filepath))
        if answer.result != LoadMap.Response.RESULT_SUCCESS:
            self.error("Change map request failed!")
        else:
            self.info("Change map request was successful!")

    def clearAllCostmaps(self) -> None:
        """Clear both costmaps."""
        self.clearLocalCostmap()
        self.clearGlobalCostmap()

    def clearLocalCostmap(self) -> None:
        """Clear the local costmap."""
        self._navigator_call(self.clear_costmap_local_srv, "Clear local costmaps", ClearEntireCostmap.Request())

    def clearGlobalCostmap(self) -> None:
        """Clear the global costmap."""
        self._navigator_call(self.clear_costmap_global_srv, "Clear global costmaps", ClearEntireCostmap.Request())

    def getGlobalCostmap(self) -> Any:
        """The global costmap (nav2_msgs/Costmap)."""
        return self._navigator_call(self.get_costmap_global_srv, "Get global costmaps", GetCostmap.Request()).map

    def getLocalCostmap(self) -> Any:
        """The local costmap (nav2_msgs/Costmap)."""
        return self._navigator_call(self.get_costmap_local_srv, "Get local costmaps", GetCostmap.Request()).map

    # -- lifecycle

    def lifecycleStartup(self) -> None:
        """Start up all lifecycle nodes of navigation."""
        self.info("Starting up lifecycle nodes based on lifecycle_manager.")
        self._navigator_manage(ManageLifecycleNodes.Request.STARTUP)
        self.info("Nav2 is ready for use!")

    def lifecycleShutdown(self) -> None:
        """Shut down all lifecycle nodes of navigation."""
        self.info("Shutting down lifecycle nodes based on lifecycle_manager.")
        self._navigator_manage(ManageLifecycleNodes.Request.SHUTDOWN)


__all__ = ["BasicNavigator", "NavigationResult", "TaskResult"]
