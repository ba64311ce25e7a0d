"""A simulated robot with navigation as a user starts it, and who watches whether it touches anything."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pymunk
import rclpy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from scipy import ndimage

from coursekit.cli.parser import run as run_cli
from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_file import GridMap, save_map
from coursekit.nodes.gazebo.simulators import simulators
from coursekit.nodes.gazebo.world_lookup import open_world
from coursekit.nodes.scanning.planar import to_pose
from coursekit.processes.executables import find
from coursekit.sim import Simulation

ROBOT = Path(__file__).parents[2] / "robots" / "urdf" / "rdk_x3_robot.urdf"
HEIGHT, CELL = 0.15, 0.05


def true_map(world: str, cell: float = CELL, start: tuple[float, float] | None = None) -> GridMap:
    """The map of a world without what moves: walls as a LiDAR meets them, free where the floor of a start goes on."""
    true_world = open_world(world).world
    outline = Simulation(true_world).scene(HEIGHT).fixed
    x0, y0, x1, y1 = (round(edge / cell) * cell for edge in true_world.bounds())
    x0, y0 = x0 - 10 * cell, y0 - 10 * cell
    rows, columns = round((y1 - y0) / cell) + 10, round((x1 - x0) / cell) + 10
    cells = np.zeros((rows, columns), np.int8)
    lengths = np.hypot(*(outline.edges[:, 2:4] - outline.edges[:, :2]).T)
    pairs = zip(outline.edges, lengths, strict=True)
    points = [np.linspace(edge[:2], edge[2:4], max(int(long / cell * 3), 2)) for edge, long in pairs]
    turn = np.linspace(0, 2 * math.pi, 60)
    points += [np.column_stack([x + r * np.cos(turn), y + r * np.sin(turn)]) for x, y, r in outline.circles[:, :3]]
    at = np.floor((np.concatenate(points) - (x0, y0)) / cell).astype(int)
    cells[at[:, 1], at[:, 0]] = 100
    areas, _ = ndimage.label(cells == 0)
    x, y = start or (true_world.start.x, true_world.start.y)
    home = areas[int((y - y0) / cell), int((x - x0) / cell)]
    cells[(cells == 0) & (areas != home)] = -1
    return GridMap(cells, cell, (x0, y0, 0.0))


class Stage:
    """Simulator, robot and navigation in a session; `go` takes the robot to a goal and counts what it touched."""

    def __init__(self, session: Any, folder: Path, world: str = "tec_warehouse", robot: Path = ROBOT, *more: str) -> None:
        self.session, self.world = session, world
        self.map = true_map(world)
        self.map_file = save_map(folder / "map", self.map)[0]
        self._start("gazebo_ros", "gzserver", world)
        session.clock.sleep(0.2)
        self._start("robot_state_publisher", "robot_state_publisher", str(robot), "--ros-args", "-p", "use_sim_time:=true")
        spawned = self._start("gazebo_ros", "spawn_entity.py", "-entity", "rdk", "-file", str(robot))
        spawned.wait(20.0)
        self.simulation = simulators.running(session)[0].simulation
        self.robot = self.simulation.robots["rdk"]
        arguments = ["launch", "nav2_bringup", "bringup_launch.py", f"map:={self.map_file}", "use_sim_time:=True", *more]
        self.launch = session.start(lambda: run_cli(arguments), name="ros2", argv=arguments)
        self.context = rclpy.context.Context()
        rclpy.init(context=self.context)
        self.node = rclpy.create_node("tourist", context=self.context, cli_args=["--ros-args", "-p", "use_sim_time:=true"])
        self.executor = rclpy.executors.SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.touched: dict[str, float] = {}
        self.movers: list[Mover] = []
        self.spin(4.0)

    def _start(self, package: str, executable: str, *argv: str) -> Any:
        return self.session.start_executable(find(package, executable), argv, name=executable)

    def close(self) -> None:
        """Leave the session."""
        rclpy.shutdown(context=self.context)

    def spin(self, seconds: float) -> None:
        """Let time pass, and watch."""
        until = self.session.clock.steady() + round(seconds * 1e9)
        while (left := until - self.session.clock.steady()) > 0:
            self.executor.spin_once(timeout_sec=min(left * 1e-9, 0.02))
            self.watch()

    def watch(self) -> None:
        """Note what the robot touches; move what moves."""
        for name in self.robot.contacts:
            self.touched.setdefault(name, self.simulation.now_ns * 1e-9)
        for mover in self.movers:
            mover.work(self.simulation)

    def tell_pose(self, pose: Pose2D) -> None:
        """2D Pose Estimate."""
        publisher = self.node.create_publisher(PoseWithCovarianceStamped, "initialpose", 1)
        msg = PoseWithCovarianceStamped()
        msg.header.frame_id, msg.pose.pose = "map", to_pose(pose)
        msg.pose.covariance[0] = msg.pose.covariance[7] = 0.25
        msg.pose.covariance[35] = 0.07
        publisher.publish(msg)
        self.spin(1.5)

    def stamped(self, pose: Pose2D) -> PoseStamped:
        """A goal in the map."""
        msg = PoseStamped()
        msg.header.frame_id, msg.pose = "map", to_pose(pose)
        return msg

    def until(self, future: Any, seconds: float = 300.0) -> Any:
        """Wait for a future; None when it takes too long."""
        end = self.session.clock.steady() + round(seconds * 1e9)
        while not future.done() and self.session.clock.steady() < end:
            self.spin(0.02)
        return future.result() if future.done() else None

    def distance_to(self, pose: Pose2D) -> float:
        """How far the robot truly is from there [m]."""
        return math.hypot(self.robot.place.x - pose.x, self.robot.place.y - pose.y)

    def free_places(self, clearance: float, count: int, seed: int) -> list[Pose2D]:
        """Random places so far from everything that is on the map, or stands in the world without being on it [m]."""
        room = ndimage.distance_transform_edt(self.map.cells == 0) * self.map.resolution
        rows, columns = np.nonzero(room > clearance)
        rng = np.random.default_rng(seed)
        chosen = rng.choice(len(rows), count, replace=False)
        x, y, _ = self.map.origin
        headings = rng.uniform(-math.pi, math.pi, count)
        drawn = [
            Pose2D(x + (columns[k] + 0.5) * CELL, y + (rows[k] + 0.5) * CELL, float(heading))
            for k, heading in zip(chosen, headings, strict=True)
        ]
        free = [place for place in drawn if not self._taken(place, clearance)]
        return free + self.free_places(clearance, count - len(free), seed + 1) if len(free) < count else free

    def _taken(self, place: Pose2D, clearance: float) -> bool:
        """Whether something stands there that is not on the map, and that nobody takes away."""
        near = self.simulation.space.point_query((place.x, place.y), clearance, pymunk.ShapeFilter())
        stay = set(self.simulation.things) - {mover.name for mover in self.movers}
        return any(hit.shape.name in stay for hit in near)


class Mover:
    """A box that goes to and fro between two places; it stops while the robot stands close in front of it."""

    def __init__(self, name: str, ends: Any, speed: float, wary: float = 0.0) -> None:
        self.name, self.ends, self.speed, self.wary, self.to = name, ends, speed, wary, 1

    def work(self, simulation: Simulation) -> None:
        """Keep going."""
        here = simulation.pose_of(self.name)
        dx, dy = (self.ends[self.to][k] - here[k] for k in (0, 1))
        gap = math.hypot(dx, dy)
        if gap < 0.1:
            self.to = 1 - self.to
            return
        speed = self.speed
        for robot in simulation.robots.values():
            rx, ry = robot.place.x - here.x, robot.place.y - here.y
            if math.hypot(rx, ry) < self.wary and rx * dx + ry * dy > 0:
                speed = 0.0
        simulation.put(self.name, Pose2D(*here), (dx / gap * speed, dy / gap * speed, 0.0))
