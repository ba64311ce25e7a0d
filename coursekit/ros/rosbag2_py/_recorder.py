"""The node that records a bag."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

from rclpy.clock import Clock, ClockType
from rclpy.executors import SingleThreadedExecutor
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rosbag2_interfaces.msg import WriteSplitEvent
from rosbag2_interfaces.srv import Snapshot
from rosidl_runtime_py.utilities import get_message

from coursekit.bag.errors import BagError
from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.storage import Message
from coursekit.bag.writer import BagWriter, WriteSettings
from rosbag2_py._inbox import Inbox
from rosbag2_py._keys import NAMES, SPACE, Keyboard
from rosbag2_py._qos import offers_text, request_for
from rosbag2_py._topic_filter import TopicFilter

if TYPE_CHECKING:
    from rclpy.context import Context


class RecorderNode(Node):
    """Subscribes to topics as they appear, and writes their messages to a bag."""

    def __init__(self, settings: WriteSettings, options: Any, context: Context) -> None:
        sim_time = Parameter("use_sim_time", value=options.use_sim_time)
        name = options.node_name
        super().__init__(name, context=context, parameter_overrides=[sim_time])
        self._options, self._settings = options, settings
        self._paused = options.start_paused
        self._recorded: dict[str, Any] = {}
        self._mismatched: set[str] = set()
        self._discovery: Any = None
        self._keys = Keyboard(self._pressed, self.end)
        self._executor_here = SingleThreadedExecutor(context=context)
        self._inbox = Inbox(self)
        self._over = False
        self._seen = -1  # the graph's version at the last search for topics
        self._bag: BagWriter | None = None
        if not options.disable_keyboard_controls:
            self.get_logger().info(f"Press {NAMES[SPACE]} for pausing/resuming")
        self._topics = [self.resolve_topic_name(topic, only_expand=True) for topic in options.topics]
        self._filter = TopicFilter(options, self._topics, self)

    # -- the run

    def record(self) -> None:
        """Record until `end()` is called."""
        self._start()
        self._executor_here.add_node(self)
        try:
            while not self._over and self.context.ok():
                self._executor_here.spin_once()
            self._say_the_end()
            self._close()
        except (BagError, OSError) as error:
            raise BagError(f"{error}{self._rescued()}") from None
        finally:
            self._keys.stop()
            self._close()

    def end(self) -> None:
        """Make `record()` return."""
        self._inbox.put(self._set_over)

    def _set_over(self) -> None:
        self._over = True

    def _start(self) -> None:
        log, options = self.get_logger(), self._options
        self._settings.on_split = self._tell_split
        self._bag = BagWriter(self._settings)
        if self._settings.snapshot_mode:
            self.create_service(Snapshot, "~/snapshot", self._take_snapshot)
        self._split_event = self.create_publisher(WriteSplitEvent, "events/write_split", 1)
        log.info("Listening for topics...")
        log.info("Event publisher thread: Starting")
        if options.use_sim_time:
            log.info("use_sim_time set, waiting for /clock before starting recording...")
        else:
            self._look_for_topics()
        starting = f"Waiting for recording: Press {NAMES[SPACE]} to start." if self._paused else "Recording..."
        log.info(starting)
        if not options.is_discovery_disabled:
            self._discovery = self.create_timer(
                options.topic_polling_interval.total_seconds(), self._discover, clock=Clock(clock_type=ClockType.STEADY_TIME)
            )
            self._stop_when_complete()
        if not options.disable_keyboard_controls:
            self._keys.start()

    def _say_the_end(self) -> None:
        if self._settings.max_cache_size and self.context.ok():
            text = "Writing remaining messages from cache to the bag. It may take a while"
            get_logger("rosbag2_cpp").info(text)
        self.get_logger().info("Event publisher thread: Exiting")
        self.get_logger().info("Recording stopped")

    def _rescued(self) -> str:
        """Close a bag that can no longer be written. Return advice on how to rescue it."""
        if self._bag is None:
            return ""
        self._bag.abandon()
        return f". What was recorded before is kept. Make room, then: ros2 bag reindex {self._bag.folder}"

    def _close(self) -> None:
        if self._bag is not None:
            self._bag.close()
        with contextlib.suppress(Exception):  # the context may have ended first
            self.destroy_node()

    # -- topics

    def _discover(self) -> None:
        """Look for topics again; with simulated time, not before /clock is received."""
        if self._options.use_sim_time and not self._recorded:
            if self.get_clock().now().nanoseconds == 0:
                return
            self.get_logger().info("Sim time /clock found, starting recording.", once=True)
        if self._rclpy_graph.version != self._seen:
            self._look_for_topics()
            self._stop_when_complete()

    def _look_for_topics(self) -> None:
        self._seen = self._rclpy_graph.version
        for name, kind in self._filter.select().items():
            if name in self._recorded:
                self._warn_of_new_publishers(name)
            else:
                self._subscribe(name, kind)

    def _stop_when_complete(self) -> None:
        only_these = bool(self._topics) and not self._options.regex
        if only_these and len(self._recorded) == len(set(self._topics)):
            self.get_logger().info("All requested topics are subscribed. Stopping discovery...")
            self.destroy_timer(self._discovery)

    def _subscribe(self, name: str, kind: str) -> None:
        offers = [info.qos_profile for info in self.get_publishers_info_by_topic(name)]
        assert self._bag is not None
        self._bag.create_topic(TopicMetadata(name, kind, "cdr", offers_text(offers)))
        profile = self._profile(name, offers)
        self._recorded[name] = profile
        self.create_subscription(get_message(kind), name, lambda data: self._keep(name, data), profile, raw=True)
        self.get_logger().info(f"Subscribed to topic '{name}'")

    def _profile(self, name: str, offers: list[QoSProfile]) -> QoSProfile:
        chosen = self._options.topic_qos_profile_overrides.get(name)
        if chosen is not None:
            self.get_logger().info(f"Overriding subscription profile for {name}")
            return chosen
        profile = request_for(name, offers, get_logger("rosbag2_transport").warning)
        # History does not affect compatibility, and no message may be lost while the bag is written.
        profile.history = HistoryPolicy.KEEP_ALL
        return profile

    def _warn_of_new_publishers(self, name: str) -> None:
        used = self._recorded[name]
        if name in self._mismatched:
            return
        for info in self.get_publishers_info_by_topic(name):
            offer = info.qos_profile
            if offer.reliability == ReliabilityPolicy.BEST_EFFORT != used.reliability:
                self._warn_once(name, "RELIABILITY_BEST_EFFORT", "rosbag", "RELIABILITY_RELIABLE")
            elif offer.durability == DurabilityPolicy.VOLATILE != used.durability:
                self._warn_once(name, "DURABILITY_VOLATILE", "rosbag2", "DURABILITY_TRANSIENT_LOCAL")

    def _warn_once(self, name: str, offered: str, who: str, asked: str) -> None:
        if name not in self._mismatched:
            self._mismatched.add(name)
            self.get_logger().warning(
                f"A new publisher for subscribed topic {name} was found offering RMW_QOS_POLICY_{offered}, but {who} "
                f"already subscribed requesting RMW_QOS_POLICY_{asked}. "
                "Messages from this new publisher will not be recorded."
            )

    # -- callbacks

    def _keep(self, name: str, data: bytes) -> None:
        if not self._paused and self._bag is not None:
            self._bag.write(Message(name, data, self.get_clock().now().nanoseconds))

    def _pressed(self, key: str) -> None:
        if key == SPACE:
            self._inbox.put(self._toggle_paused)

    def _toggle_paused(self) -> None:
        self._paused = not self._paused
        self.get_logger().info("Pausing recording." if self._paused else "Resuming recording.")

    def _take_snapshot(self, _request: Any, response: Any) -> Any:
        response.success = self._bag is not None and self._bag.take_snapshot()
        return response

    def _tell_split(self, closed: str, opened: str) -> None:
        self._split_event.publish(WriteSplitEvent(closed_file=closed, opened_file=opened))
