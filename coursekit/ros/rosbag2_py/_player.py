"""The node that plays a bag."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

from rclpy.clock import Clock, ClockType
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rosgraph_msgs.msg import Clock as ClockMessage
from rosidl_runtime_py.utilities import get_message

from coursekit.bag.errors import BagError
from coursekit.bag.metadata import TopicMetadata
from coursekit.interfaces.errors import CdrError
from coursekit.interfaces.find import known_packages, prefixes
from coursekit.processes.session import current
from rosbag2_py._inbox import Inbox
from rosbag2_py._keys import DOWN, NAMES, RIGHT, SPACE, UP, Keyboard
from rosbag2_py._play_clock import PlayClock
from rosbag2_py._play_services import offer_services
from rosbag2_py._qos import offer_for, parse_offers
from rosbag2_py._reader import SequentialReader
from rosbag2_py._storage import StorageFilter, StorageOptions

if TYPE_CHECKING:
    from rclpy.context import Context

_WITHOUT_PAUSE = 64
"""The maximum number of messages published in a row before services and keys are handled."""


class PlayerNode(Node):
    """Publishes the messages of a bag at the times at which they were recorded."""

    def __init__(self, storage: StorageOptions, options: Any, context: Context) -> None:
        self.reader = SequentialReader()
        self.reader.open(storage)
        super().__init__("rosbag2_player", context=context, cli_args=options.topic_remapping_options)
        self._options, self._storage = options, storage
        self._executor_here = SingleThreadedExecutor(context=context)
        self._executor_here.add_node(self)
        self._inbox = Inbox(self)
        self._over = False
        self._position = self._start_ns = self._first_time()
        self.clock = PlayClock(current().clock, self._start_ns, paused=options.start_paused)
        self.set_rate(options.rate)
        self._topics = [self.resolve_topic_name(topic, only_expand=True) for topic in options.topics_to_filter]
        self._outs = self._publishers_of_bag()
        self._spoilt: set[str] = set()
        offer_services(self)
        self._keys = Keyboard(self._pressed, self.end)
        if not options.disable_keyboard_controls:
            self._say_keys()

    def _first_time(self) -> int:
        start = self.reader.get_metadata().starting_time_ns
        return start + round(max(0.0, self._options.start_offset) * 1e9)

    def _say_keys(self) -> None:
        log = self.get_logger()
        log.info("Adding keyboard callbacks.")
        names = {SPACE: "Pause/Resume", RIGHT: "Play Next Message", UP: "Increase Rate 10%", DOWN: "Decrease Rate 10%"}
        for key, text in names.items():
            log.info(f"Press {NAMES[key]} for {text}")

    # -- publishers

    def _publishers_of_bag(self) -> dict[str, Any]:
        publisher_by_topic = {}
        for topic in self.reader.get_all_topics_and_types():
            if not self._topics or topic.name in self._topics:
                try:
                    publisher_by_topic[topic.name] = self.create_publisher(_type_of(topic), topic.name, self._profile(topic))
                except Exception as error:  # an invalid type or name must not prevent the playback of the other topics
                    self.get_logger().warning(f"Ignoring a topic '{topic.name}', reason: {error}.")
        return publisher_by_topic

    def _profile(self, topic: TopicMetadata) -> QoSProfile:
        chosen = self._options.topic_qos_profile_overrides.get(topic.name)
        if chosen is not None:
            self.get_logger().info(f"Overriding QoS profile for topic {topic.name}")
            return chosen
        warn = get_logger("rosbag2_transport").warning
        return offer_for(topic.name, parse_offers(topic.offered_qos_profiles), warn)

    # -- the run

    def play(self) -> None:
        """Play to the end, or until `end()` is called."""
        if not self._options.disable_keyboard_controls:
            self._keys.start()
        if self._options.clock_publish_frequency > 0:
            self._publish_clock()
        try:
            self._play_once()
            while self._options.loop and self._goes_on():
                self._play_once()
            self._wait_for_listeners()
        finally:
            self._keys.stop()
            self.reader.close()
            self._executor_here.shutdown()
            with contextlib.suppress(Exception):  # the context may have ended first
                self.destroy_node()

    def end(self) -> None:
        """Make `play()` return."""
        self._inbox.put(self._set_over)

    def _set_over(self) -> None:
        self._over = True

    def _goes_on(self) -> bool:
        return not self._over and self.context.ok()

    def _wait(self, delay: float) -> None:
        """Wait for `delay` seconds before playback; services are answered meanwhile."""
        if delay > 0 and self._goes_on():
            self.get_logger().info(f"Sleep {round(delay * 1e9)} ns")
            steady = current().clock.steady
            until = steady() + round(delay * 1e9)
            while self._goes_on() and (left := until - steady()) > 0:
                self._executor_here.spin_once(timeout_sec=left * 1e-9)

    def _play_once(self) -> None:
        self.reader.open(self._storage)
        self.reader.set_filter(StorageFilter(list(self._outs) if self._topics else []))
        self.seek(self._start_ns)
        self._wait(self._options.delay)
        self.clock.jump(self._position)  # the position that keys and services have set in the meantime
        in_a_row = 0
        while self._goes_on() and (message := self.reader.peek()) is not None:
            left = self.clock.seconds_until(message.stamp)
            if left == 0.0 and in_a_row < _WITHOUT_PAUSE:
                in_a_row += 1
                self._publish(self.reader.read_next())
            else:
                in_a_row = 0
                self._executor_here.spin_once(timeout_sec=left)

    def _publish(self, message: tuple[str, bytes, int]) -> None:
        topic, data, _ = message
        out = self._outs.get(topic)
        if out is None:
            return
        try:
            out.publish(data)
        except CdrError as error:
            if topic not in self._spoilt:
                self._spoilt.add(topic)
                self.get_logger().error(f"A message of topic '{topic}' cannot be published: {error}")

    def _publish_clock(self) -> None:
        out = self.create_publisher(ClockMessage, "/clock", 1)

        def tell() -> None:
            sec, nanosec = divmod(max(0, self.clock.now()), 10**9)
            message = ClockMessage()
            message.clock.sec, message.clock.nanosec = sec, nanosec
            out.publish(message)

        steady = Clock(clock_type=ClockType.STEADY_TIME)
        self.create_timer(1.0 / self._options.clock_publish_frequency, tell, clock=steady)

    def _wait_for_listeners(self) -> None:
        timeout = self._options.wait_acked_timeout
        for topic, out in self._outs.items() if timeout >= 0 else ():
            if not out.wait_for_all_acked(Duration(nanoseconds=timeout * 10**6) if timeout else Duration(seconds=-1)):
                self.get_logger().error(
                    f"Timed out while waiting for all published messages to be acknowledged for topic {topic}"
                )

    # -- control

    def set_rate(self, rate: float) -> bool:
        """Play at another rate. Return False for a rate that is not finite and above 0."""
        if self.clock.set_rate(rate):
            self.get_logger().info(f"Set rate to {rate:g}")
            return True
        self.get_logger().warning(f"Failed to set rate to invalid value {rate:g}")
        return False

    def pause(self) -> None:
        """Pause playback."""
        self.clock.pause()
        self.get_logger().info("Pausing play.")

    def resume(self) -> None:
        """Resume playback."""
        self.clock.resume()
        self.get_logger().info("Resuming play.")

    def toggle_paused(self) -> None:
        """Pause, or resume."""
        (self.resume if self.clock.paused else self.pause)()

    def play_next(self) -> bool:
        """While paused: publish the next message. Return whether there was one."""
        if not self.clock.paused:
            self.get_logger().warning("Called play next, but not in paused state.")
            return False
        return self._skip_to_next()

    def _skip_to_next(self) -> bool:
        while self.reader.has_next():
            message = self.reader.read_next()
            self._jump(message[2])
            if message[0] in self._outs:
                self._publish(message)
                return True
        return False

    def burst(self, count: int) -> int:
        """While paused: publish `count` messages at once (0: all that are left). Return the number published."""
        if not self.clock.paused:
            self.get_logger().warning("Burst can only be used when in the paused state.")
            return 0
        played = 0
        while (count == 0 or played < count) and self._skip_to_next():
            played += 1
        self.get_logger().info(f"Burst {played} messages.")
        return played

    def seek(self, time: int) -> None:
        """Jump to a time in the recording (ns since 1970), not before its start."""
        time = max(time, self._start_ns)
        self.reader.seek(time)
        self._jump(time)

    def _jump(self, time: int) -> None:
        self._position = time
        self.clock.jump(time)

    def _pressed(self, key: str) -> None:
        acts = {
            SPACE: self.toggle_paused,
            RIGHT: self.play_next,
            UP: lambda: self.set_rate(self.clock.rate * 1.1),
            DOWN: lambda: self.set_rate(self.clock.rate * 0.9),
        }
        self._inbox.put(acts[key])


def _type_of(topic: TopicMetadata) -> Any:
    package = topic.type.split("/")[0]
    if package not in known_packages():
        raise BagError(f"package '{package}' not found, searching: [{', '.join(map(str, prefixes()))}]")
    return get_message(topic.type)
