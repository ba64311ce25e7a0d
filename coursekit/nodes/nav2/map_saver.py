"""`ros2 run nav2_map_server map_saver_cli` and `map_saver_server`: save a map topic to files."""

from __future__ import annotations

import argparse
import sys
from typing import Any

import rclpy
from nav2_msgs.srv import SaveMap
from nav_msgs.msg import OccupancyGrid
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from rclpy.logging import get_logger
from rclpy.task import Future
from rclpy.utilities import remove_ros_args

from coursekit.nav.map_cells import MODES, OCCUPIED_ABOVE
from coursekit.nav.map_file import save_map
from coursekit.nav.map_picture import FORMATS
from coursekit.nodes.nav2.map_message import MAP_QOS, from_message
from coursekit.nodes.running import run

FREE_DEFAULT = 0.25
"""The threshold written by Humble's map saver; above 0.196, the shade of unknown cells, so they are loaded as free."""


class MapSaver(LifecycleNode):
    """Waits for a map and saves it; as a server, it provides save_map once configured."""

    def __init__(self) -> None:
        super().__init__("map_saver")
        self.get_logger().info("Creating")
        self._timeout = float(self.declare_parameter("save_map_timeout", 2.0).value)
        self._free = float(self.declare_parameter("free_thresh_default", FREE_DEFAULT).value)
        self._occupied = float(self.declare_parameter("occupied_thresh_default", OCCUPIED_ABOVE).value)
        self._latched = self.declare_parameter("map_subscribe_transient_local", True).value
        self._group = ReentrantCallbackGroup()  # maps arrive while a request waits for them
        self._service: Any = None

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the service."""
        self.get_logger().info("Configuring")
        name = f"{self.get_name()}/save_map"
        self._service = self.create_service(SaveMap, name, self._save_map, callback_group=self._group)
        return super().on_configure(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the service."""
        self.get_logger().info("Cleaning up")
        self.destroy_service(self._service)
        return super().on_cleanup(state)

    async def _save_map(self, request: SaveMap.Request, response: SaveMap.Response) -> SaveMap.Response:
        response.result = await self.save(
            request.map_topic or "map",
            request.map_url,
            mode=request.map_mode,
            image_format=request.image_format,
            free=round(request.free_thresh, 6),
            occupied=round(request.occupied_thresh, 6),
        )
        return response

    async def save(
        self, topic: str, url: str, *, mode: str = "", image_format: str = "", free: float = 0.0, occupied: float = 0.0
    ) -> bool:
        """Save the next map on `topic` to url.yaml and an image; a threshold of 0 means the default."""
        log = self.get_logger()
        log.info(f"Saving map from '{topic}' topic to '{url}' file")
        if not free:
            log.warning(f"Free threshold unspecified. Setting it to default value: {self._free:.6f}")
        if not occupied:
            log.warning(f"Occupied threshold unspecified. Setting it to default value: {self._occupied:.6f}")
        msg = await self._next_map(topic)
        if msg is None:
            log.error("Failed to spin map subscription")
            log.error(
                f"No map came on '{topic}' in {self._timeout:g} s: is it published, reliable and transient_local? "
                f"`ros2 topic info -v {topic}` shows it"
            )
            return False
        return self._write(msg, url, mode, image_format, free or self._free, occupied or self._occupied)

    async def _next_map(self, topic: str) -> OccupancyGrid | None:
        received: Future = Future()

        def finish(msg: OccupancyGrid | None = None) -> None:
            if not received.done():
                received.set_result(msg)

        qos = MAP_QOS if self._latched else 1
        subscription = self.create_subscription(OccupancyGrid, topic, finish, qos, callback_group=self._group)
        timer = self.create_timer(self._timeout, finish, callback_group=self._group)
        try:
            return await received
        finally:
            self.destroy_timer(timer)
            self.destroy_subscription(subscription)

    def _write(self, msg: OccupancyGrid, url: str, mode: str, image_format: str, free: float, occupied: float) -> bool:
        log = get_logger("map_io")
        info = msg.info
        log.info(f"Received a {info.width} X {info.height} map @ {info.resolution:.6g} m/pix")
        try:
            files = save_map(
                url,
                from_message(msg),
                mode=mode or "trinary",
                image_format=image_format,
                free_thresh=free,
                occupied_thresh=occupied,
            )
        except (ValueError, OSError) as error:
            log.error(f"Failed to write map for reason: {error}")
            return False
        log.info(f"Writing map occupancy data to {files[1]}")
        log.info(f"Writing map metadata to {files[0]}")
        log.info("Map saved")
        self.get_logger().info("Map saved successfully")
        return True


def _arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="map_saver_cli", description="Save a map topic as NAME.yaml and a picture.")
    parser.add_argument("-t", dest="topic", default="map", metavar="TOPIC", help="the map's topic (map)")
    parser.add_argument("-f", dest="file", default="", metavar="NAME", help="the files' name without its ending")
    parser.add_argument("--occ", type=float, default=0.0, help=f"occupied from here on, 0 ... 1 ({OCCUPIED_ABOVE})")
    parser.add_argument("--free", type=float, default=0.0, help=f"free up to here, 0 ... 1 ({FREE_DEFAULT})")
    parser.add_argument("--fmt", default="", choices=FORMATS, help="the picture's format (pgm; png in mode scale)")
    parser.add_argument("--mode", default="", choices=MODES, help="trinary, scale or raw (trinary)")
    return parser.parse_args(words)


def main_cli(args: list[str] | None = None) -> int:
    """Save one map. Returns 1 if none arrived or it could not be written."""
    given = _arguments(remove_ros_args(sys.argv if args is None else args)[1:])
    rclpy.init(args=args)
    node = MapSaver()
    try:
        file = given.file or f"map_{node.get_clock().now().nanoseconds // 1_000_000_000}"
        executor = rclpy.get_global_executor()
        executor.add_node(node)
        saved = executor.create_task(
            node.save, given.topic, file, mode=given.mode, image_format=given.fmt, free=given.free, occupied=given.occ
        )
        executor.spin_until_future_complete(saved)
        return 0 if saved.result() else 1
    except (KeyboardInterrupt, ExternalShutdownException):
        return 1
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


def main_server(args: list[str] | None = None) -> int:
    """Run the server until Ctrl-C."""
    return run(MapSaver, args)
