"""slam_toolbox's services."""

from __future__ import annotations

from typing import Any

from nav_msgs.srv import GetMap
from rclpy.parameter import Parameter
from slam_toolbox.srv import (
    Clear,
    ClearQueue,
    DeserializePoseGraph,
    LoopClosure,
    Pause,
    Reset,
    SaveMap,
    SerializePoseGraph,
    ToggleInteractive,
)

from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_file import save_map
from coursekit.nodes.nav2.map_message import from_message
from coursekit.nodes.nav2.map_saver import FREE_DEFAULT
from coursekit.nodes.slam_toolbox.engines import Mapping, load_localizing, load_slam, localizing
from coursekit.nodes.slam_toolbox.toolbox import SlamToolbox
from coursekit.slam import storage
from coursekit.slam.slam import Slam

ENDING = ".posegraph"


class Services:
    """The services of a node; with `localize`, deserialize_map starts localisation."""

    def __init__(self, node: SlamToolbox, *, localize: bool = False, queue: bool = False) -> None:
        self._node, self._localize = node, localize
        self._mapping: Mapping | None = None
        """What mapped before localisation began."""
        offered: list[tuple[Any, str, Any]] = [
            (GetMap, "dynamic_map", self._get_map),
            (Pause, "pause_new_measurements", self._pause),
            (SerializePoseGraph, "serialize_map", self._serialize),
            (DeserializePoseGraph, "deserialize_map", self._deserialize),
            (LoopClosure, "manual_loop_closure", self._close_loops),
            (ToggleInteractive, "toggle_interactive_mode", self._toggle),
            (Clear, "clear_changes", self._clear),
            (Reset, "reset", self._reset),
        ]
        if node.get_parameter("use_map_saver").value:
            offered.append((SaveMap, "save_map", self._save))
        if queue:
            offered.append((ClearQueue, "clear_queue", self._clear_queue))
        for kind, name, answer in offered:
            node.create_service(kind, f"slam_toolbox/{name}", answer)

    # -- the map

    def _get_map(self, _request: GetMap.Request, response: GetMap.Response) -> GetMap.Response:
        grid = self._node.map_topic.latest
        if grid is not None:
            response.map = grid
        return response

    def _save(self, request: SaveMap.Request, response: SaveMap.Response) -> SaveMap.Response:
        """Save the map in nav2's format."""
        log, name = self._node.get_logger(), request.name.data
        self._node.publish_map()
        grid = self._node.map_topic.latest
        if grid is None:
            topic = self._node.get_parameter("map_name").value
            log.warning(f"Map Saver: Cannot save map, no map yet received on topic {topic}.")
            response.result = SaveMap.Response.RESULT_NO_MAP_RECEIEVD
            return response
        log.info(f"SlamToolbox: Saving map as {name}." if name else "SlamToolbox: Saving map in current directory.")
        name = name or f"map_{self._node.get_clock().now().nanoseconds // 10**9}"
        try:
            files = save_map(name, from_message(grid), free_thresh=FREE_DEFAULT)  # Humble calls nav2's map saver
        except (OSError, ValueError) as fault:
            log.error(f"The map cannot be saved: {fault}")
            response.result = SaveMap.Response.RESULT_UNDEFINED_FAILURE
            return response
        log.info("Map saved: {} and {}".format(*files))
        response.result = SaveMap.Response.RESULT_SUCCESS
        return response

    # -- the session

    def _serialize(
        self, request: SerializePoseGraph.Request, response: SerializePoseGraph.Response
    ) -> SerializePoseGraph.Response:
        """Save the pose graph with its scans."""
        log, engine = self._node.get_logger(), self._node.engine
        response.result = SerializePoseGraph.Response.RESULT_FAILED_TO_WRITE_FILE
        if not request.filename or not isinstance(engine, Mapping):
            log.error("SerializePoseGraph: Failed to write file: a name, and a node that maps, are needed")
            return response
        try:
            name = request.filename
            file = storage.save(engine.slam, name if name.endswith(ENDING) else name + ENDING)
        except (OSError, ValueError) as fault:
            log.error(f"SerializePoseGraph: Failed to write file: {fault}")
            return response
        log.info(f"Pose graph saved: {file} (the map itself is saved by slam_toolbox/save_map)")
        response.result = SerializePoseGraph.Response.RESULT_SUCCESS
        return response

    def _deserialize(
        self, request: DeserializePoseGraph.Request, response: DeserializePoseGraph.Response
    ) -> DeserializePoseGraph.Response:
        kind, pose = DeserializePoseGraph.Request, request.initial_pose
        if request.match_type == kind.UNSET:
            self._node.get_logger().error("Deserialization called without valid match type set. Aborting.")
            return response
        at = None if request.match_type == kind.START_AT_FIRST_NODE else Pose2D.of((pose.x, pose.y, pose.theta))
        self.load(request.filename, at, localize=self._localize or request.match_type == kind.LOCALIZE_AT_POSE)
        return response

    def load(self, name: str, at: Pose2D | None, *, localize: bool, anywhere: bool = False) -> bool:
        """Continue a saved session at a pose or at its first one; with `anywhere`, search for the robot's pose."""
        log, params = self._node.get_logger(), self._node.slam_params
        if not name:
            log.warning("DeserializePoseGraph: Failed to read file: no name was given")
            return False
        try:
            near = at if anywhere or at is not None else Pose2D()
            engine = load_localizing(name, near, params) if localize else Mapping(load_slam(name, at, params))
        except (OSError, ValueError) as fault:
            log.error(f"DeserializePoseGraph: Failed to read file: {fault}")
            return False
        self._node.use(engine)
        self._node.publish_map()
        log.info(f"Loaded {name}")
        return True

    def set_localization(self, on: bool) -> str:
        """Localise in the current map, or resume mapping. Return the reason if that is not possible, else ''."""
        engine = self._node.engine
        if on and isinstance(engine, Mapping):
            if not engine.slam.keyframes:
                return "there is no map yet to localise in"
            self._mapping = engine
            localizer = localizing(engine.slam, None)
            localizer.look_near(engine.pose)
            self._node.use(localizer)
        elif not on and not isinstance(engine, Mapping):
            slam = Slam(self._node.slam_params) if self._mapping is None else self._mapping.slam
            if slam.keyframes:
                storage.resume(slam, engine.pose)
            self._node.use(Mapping(slam))
        return ""

    def _reset(self, request: Reset.Request, response: Reset.Response) -> Reset.Response:
        """Start an empty map."""
        self._node.use(Mapping(Slam(self._node.slam_params)))
        self._set("paused_new_measurements", bool(request.pause_new_measurements))
        self._node.get_logger().info("SlamToolbox: Reset")
        response.result = Reset.Response.RESULT_SUCCESS
        return response

    def _close_loops(self, _request: LoopClosure.Request, response: LoopClosure.Response) -> LoopClosure.Response:
        """Optimize the graph with all loops found so far."""
        if isinstance(self._node.engine, Mapping):
            self._node.engine.slam.finish()
            self._node.publish_map()
        return response

    # -- switches

    def _set(self, name: str, value: bool) -> None:
        self._node.set_parameters([Parameter(name, value=value)])

    def _pause(self, _request: Pause.Request, response: Pause.Response) -> Pause.Response:
        paused = not self._node.paused
        self._set("paused_new_measurements", paused)
        now = "pause taking new measurements." if paused else "actively taking new measurements."
        self._node.get_logger().info(f"SlamToolbox: Toggled to {now}")
        response.status = True
        return response

    def _toggle(
        self, _request: ToggleInteractive.Request, response: ToggleInteractive.Response
    ) -> ToggleInteractive.Response:
        on = not self._node.get_parameter("enable_interactive_mode").value
        self._set("enable_interactive_mode", on)
        self._node.get_logger().info(f"SlamToolbox: Toggling {'on' if on else 'off'} interactive mode.")
        return response

    def _clear(self, _request: Clear.Request, response: Clear.Response) -> Clear.Response:
        """Redraw the markers. There are no manual changes to discard, because nothing can be moved by hand."""
        self._node.publish_map()
        return response

    def _clear_queue(self, _request: ClearQueue.Request, response: ClearQueue.Response) -> ClearQueue.Response:
        self._node.get_logger().info("SynchronousSlamToolbox: Clearing all queued scans to add to map.")
        response.status = self._node.forget_waiting()
        return response
