"""A robot's way to a goal, as nav2's default behaviour tree goes it: plan, follow, plan again; recover when that fails."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from geometry_msgs.msg import Point, PoseStamped
from nav2_msgs.action import BackUp, ComputePathThroughPoses, ComputePathToPose, FollowPath, Spin, Wait
from nav2_msgs.srv import ClearEntireCostmap, IsPathValid
from nav_msgs.msg import Path
from rclpy.duration import Duration

from coursekit.geometry.plane import Pose2D
from coursekit.nav.planner import length
from coursekit.nav.second_thoughts import remaining, worth_it
from coursekit.nodes.nav2.errands import Errand, call
from coursekit.nodes.nav2.running import Beat, pause

MOST_RECOVERIES = 6
REPLAN_SECONDS = 1.0
PASSED_WITHIN = 0.7
"""A place to pass on the way counts as passed from so near [m]."""


class Helpers:
    """The servers that do the work."""

    def __init__(self, node: Any) -> None:
        self.node = node
        self.plan = Errand(node, ComputePathToPose, "compute_path_to_pose")
        self.plan_through = Errand(node, ComputePathThroughPoses, "compute_path_through_poses")
        self.follow = Errand(node, FollowPath, "follow_path")
        self.spin, self.wait = Errand(node, Spin, "spin"), Errand(node, Wait, "wait")
        self.back_up = Errand(node, BackUp, "backup")
        self.is_valid = node.create_client(IsPathValid, "is_path_valid")
        self.clears = {
            name: node.create_client(ClearEntireCostmap, f"{name}_costmap/clear_entirely_{name}_costmap")
            for name in ("local", "global")
        }

    async def clear(self, *names: str) -> None:
        """Clear costmaps."""
        for name in names:
            await call(self.node, self.clears[name])

    def destroy(self) -> None:
        """Ask nobody any more."""
        for errand in (self.plan, self.plan_through, self.follow, self.spin, self.wait, self.back_up):
            errand.destroy()
        for client in (self.is_valid, *self.clears.values()):
            self.node.destroy_client(client)


class Trip:
    """One goal: `await run()` tells 'succeeded', 'failed' or 'stopped' (when `stop()` said so).

    `where()` gives the robot's pose, or None; `tell(trip)` is called ten times a second.
    """

    def __init__(
        self, helpers: Helpers, goals: list[PoseStamped], where: Callable[[], Pose2D | None],
        stop: Callable[[], bool], tell: Callable[[Trip], None],
    ) -> None:  # fmt: skip
        self.helpers, self.goals, self._where, self._stop, self._tell = helpers, goals, where, stop, tell
        self.recoveries = self._turn = 0
        self.path: np.ndarray = np.zeros((0, 2))

    @property
    def distance(self) -> float:
        """What is left of the path [m]."""
        return length(self._ahead())

    def _ahead(self) -> np.ndarray:
        """What is left of the path (n, 2); nothing where the robot's pose is not known."""
        here = self._where()
        return remaining(self.path, here.x, here.y) if here is not None and len(self.path) else self.path[:0]

    async def run(self) -> str:
        """Go."""
        while True:
            end = await self._attempt()
            if end != "failed" or self._stop():
                return end if end != "failed" else "stopped"
            if self.recoveries >= MOST_RECOVERIES:
                return "failed"
            self.recoveries += 1
            await self._recover()

    async def _attempt(self) -> str:
        """Plan and follow, with a cleared costmap the second time."""
        for again in (False, True):
            if not await self._plan():
                return "failed"
            if not await self._follow():
                return "failed"
            end = await self._on_the_way()
            if end != "failed" or again:
                return end
            await self.helpers.clear("local")
        return "failed"

    async def _on_the_way(self) -> str:
        """Wait for the end of the way, with a new plan every second."""
        node, follow = self.helpers.node, self.helpers.follow
        beat, since = Beat(node, 0.1), 0.0
        try:
            while not follow.ended:
                if self._stop():
                    return "stopped"
                self._tell(self)
                await beat.next()
                since += 0.1
                if since > REPLAN_SECONDS and not follow.ended:
                    since = 0.0
                    if not (await self._plan(under_way=True) and (follow.ended or await self._follow())):
                        await follow.cancel()
                        return "stopped" if self._stop() else "failed"
        finally:
            beat.stop()
        return "succeeded" if follow.succeeded else "failed"

    async def _plan(self, *, under_way: bool = False) -> bool:
        """A path, if need be through a cleared costmap; under way the one that is driven, if that is as good."""
        for again in (False, True):
            if self._stop():
                return False
            if await self._plan_once(under_way):
                return True
            if not again:
                await self.helpers.clear("global")
                await pause(self.helpers.node, 0.5)
        return False

    async def _plan_once(self, under_way: bool) -> bool:
        before = len(self.goals)
        self._drop_passed()
        if len(self.goals) == 1:
            asked: Errand = self.helpers.plan
            goal: Any = ComputePathToPose.Goal(goal=self.goals[0])
        else:
            asked, goal = self.helpers.plan_through, ComputePathThroughPoses.Goal(goals=self.goals)
        if not await asked.do(goal, self._stop):
            return False
        message = asked.result.path
        path = np.array([(one.pose.position.x, one.pose.position.y) for one in message.poses])
        if not (under_way and len(self.goals) == before and await self._keeps_its_way(path)):
            self._message, self.path = message, path
        return True

    async def _keeps_its_way(self, new: np.ndarray) -> bool:
        """Whether the way that is driven is still free, and the new one is another that is hardly shorter."""
        old = self._ahead()
        if not len(old) or not len(new) or worth_it(new, old):
            return False
        ahead = Path(header=self._message.header, poses=self._message.poses[-len(old) :])
        answer = await call(self.helpers.node, self.helpers.is_valid, IsPathValid.Request(path=ahead))
        return bool(answer is not None and answer.is_valid)

    def _drop_passed(self) -> None:
        here = self._where()
        while here is not None and len(self.goals) > 1:
            first = self.goals[0].pose.position
            if math.hypot(first.x - here.x, first.y - here.y) > PASSED_WITHIN:
                break
            self.goals = self.goals[1:]

    async def _follow(self) -> bool:
        return await self.helpers.follow.begin(FollowPath.Goal(path=self._message, controller_id="FollowPath"))

    async def _recover(self) -> None:
        """The next of: clear both costmaps, turn, wait, back up; what does not work gives way to the next."""
        helpers = self.helpers
        long = Duration(seconds=10).to_msg()
        for _ in range(4):
            self._tell(self)
            turn, self._turn = self._turn, (self._turn + 1) % 4
            if turn == 0:
                await helpers.clear("local", "global")
                await pause(helpers.node, 0.5)
                return
            errand, goal = {
                1: (helpers.spin, Spin.Goal(target_yaw=1.57, time_allowance=long)),
                2: (helpers.wait, Wait.Goal(time=Duration(seconds=5).to_msg())),
                3: (helpers.back_up, BackUp.Goal(target=Point(x=0.30), speed=0.05, time_allowance=long)),
            }[turn]
            if await errand.do(goal, self._stop) or self._stop():
                return
