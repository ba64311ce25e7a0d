"""`ros2 run nav2_map_server map_server`: a lifecycle node that publishes a map file on /map."""

from __future__ import annotations

from nav2_msgs.srv import LoadMap
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import GetMap
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from rclpy.logging import get_logger

from coursekit.nav.map_error import MapError
from coursekit.nav.map_file import load_picture, read_description
from coursekit.nodes.nav2.map_message import MAP_QOS, to_message
from coursekit.nodes.running import run


class MapServer(LifecycleNode):
    """Loads `yaml_filename` when configured, publishes it when activated, and serves map and load_map."""

    def __init__(self) -> None:
        super().__init__("map_server")
        self.get_logger().info("Creating")
        self.declare_parameter("yaml_filename", "")
        self.declare_parameter("topic_name", "map")
        self.declare_parameter("frame_id", "map")
        self._map: OccupancyGrid | None = None
        self._active = False

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Load the map and create the topic and services; FAILURE if the map cannot be loaded."""
        self.get_logger().info("Configuring")
        file = self.get_parameter("yaml_filename").value
        if not file:
            self.get_logger().info(f"yaml-filename parameter is empty, set map through '{self.get_name()}/load_map'-service")
        elif self._load(file) != LoadMap.Response.RESULT_SUCCESS:
            self.get_logger().error(f"Failed to load map yaml file: {file}")
            return TransitionCallbackReturn.FAILURE
        name = self.get_name()
        topic = self.get_parameter("topic_name").value
        self._publisher = self.create_lifecycle_publisher(OccupancyGrid, topic, MAP_QOS)
        self._offered = [
            self.create_service(GetMap, f"{name}/map", self._get_map),
            self.create_service(LoadMap, f"{name}/load_map", self._load_map),
        ]
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Publish the map once, latched."""
        self.get_logger().info("Activating")
        answer = super().on_activate(state)
        self._active = True
        self._publish()
        return answer

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop publishing and serving."""
        self.get_logger().info("Deactivating")
        self._active = False
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Discard the map, its topic and its services."""
        self.get_logger().info("Cleaning up")
        answer = super().on_cleanup(state)
        self.destroy_lifecycle_publisher(self._publisher)
        for service in self._offered:
            self.destroy_service(service)
        self._map = None
        return answer

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Shut down."""
        self.get_logger().info("Shutting down")
        self._active = False
        return super().on_shutdown(state)

    def _publish(self) -> None:
        if self._map is not None:
            self._publisher.publish(self._map)

    def _load(self, file: str) -> int:
        """Load a map. Returns LoadMap's result code. On failure, the old map is kept."""
        log = get_logger("map_io")
        if not file:
            log.error("YAML file name is empty, can't load!")
            return LoadMap.Response.RESULT_MAP_DOES_NOT_EXIST
        log.info(f"Loading yaml file: {file}")
        try:
            description = read_description(file)
            log.info(f"Loading image_file: {description.image}")
            grid = load_picture(description)
        except MapError as error:
            log.error(f"Failed to load the map: {error}")
            picture = error.part == "picture"
            return LoadMap.Response.RESULT_INVALID_MAP_DATA if picture else LoadMap.Response.RESULT_INVALID_MAP_METADATA
        rows, columns = grid.cells.shape
        log.info(f"Read map {description.image}: {columns} X {rows} map @ {grid.resolution:g} m/cell")
        if description.crossed:
            log.warning(
                f"free_thresh {description.free_thresh:g} is above occupied_thresh {description.occupied_thresh:g}: "
                "nothing is unknown in this map. Are the two exchanged? Usual are 0.196 and 0.65"
            )
        if grid.origin[2]:
            log.warning("The origin is turned, which most readers of a map ignore: write 0 as its yaw")
        self._map = to_message(grid, self.get_parameter("frame_id").value, self.get_clock().now().to_msg())
        return LoadMap.Response.RESULT_SUCCESS

    def _get_map(self, _request: GetMap.Request, response: GetMap.Response) -> GetMap.Response:
        if not self._active:
            self.get_logger().warning("Received GetMap request but not in ACTIVE state, ignoring!")
        elif self._map is not None:
            self.get_logger().info("Handling GetMap request")
            response.map = self._map
        return response

    def _load_map(self, request: LoadMap.Request, response: LoadMap.Response) -> LoadMap.Response:
        if not self._active:
            self.get_logger().warning("Received LoadMap request but not in ACTIVE state, ignoring!")
            response.result = LoadMap.Response.RESULT_UNDEFINED_FAILURE
            return response
        self.get_logger().info("Handling LoadMap request")
        response.result = self._load(request.map_url)
        if response.result == LoadMap.Response.RESULT_SUCCESS and self._map is not None:
            response.map = self._map
            self._publish()
        return response


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(MapServer, args)
