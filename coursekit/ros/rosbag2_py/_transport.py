"""Recorder, player and converter of bags. In ROS 2: rosbag2_py._transport."""

from __future__ import annotations

import contextlib
import datetime
import weakref
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rclpy.context import Context
from rclpy.qos import QoSProfile

from coursekit.processes.process import current_process
from rosbag2_py._compression_options import CompressionOptions, compression_mode_from_string
from rosbag2_py._keys import until_told_to_end
from rosbag2_py._storage import StorageOptions
from rosbag2_py._writer import settings_of

__all__ = ["PlayOptions", "Player", "RecordOptions", "Recorder", "bag_rewrite"]


@dataclass
class PlayOptions:
    """The options of playback; `delay` and `start_offset` are in seconds, `wait_acked_timeout` in milliseconds."""

    read_ahead_queue_size: int = 1000
    node_prefix: str = ""
    rate: float = 1.0
    topics_to_filter: list[str] = field(default_factory=list)
    topic_qos_profile_overrides: dict[str, QoSProfile] = field(default_factory=dict)
    loop: bool = False
    topic_remapping_options: list[str] = field(default_factory=list)
    clock_publish_frequency: float = 0.0
    delay: float = 0.0
    disable_keyboard_controls: bool = False
    start_paused: bool = False
    start_offset: float = 0.0
    wait_acked_timeout: int = -1
    disable_loan_message: bool = False


@dataclass
class RecordOptions:
    """The options of recording."""

    all: bool = False
    is_discovery_disabled: bool = False
    topics: list[str] = field(default_factory=list)
    rmw_serialization_format: str = ""
    topic_polling_interval: datetime.timedelta = datetime.timedelta(milliseconds=100)
    regex: str = ""
    exclude: str = ""
    node_prefix: str = ""
    node_name: str = "rosbag2_recorder"
    compression_mode: str = ""
    compression_format: str = ""
    compression_queue_size: int = 1
    compression_threads: int = 0
    topic_qos_profile_overrides: dict[str, QoSProfile] = field(default_factory=dict)
    include_hidden_topics: bool = False
    include_unpublished_topics: bool = False
    disable_keyboard_controls: bool = False
    start_paused: bool = False
    ignore_leaf_topics: bool = False
    use_sim_time: bool = False

    def packing(self) -> CompressionOptions:
        """The compression of the bag."""
        return CompressionOptions(self.compression_format, compression_mode_from_string(self.compression_mode))


class _Runner:
    """Runs in a context of its own, as in rclcpp; the program's rclpy context is not affected."""

    _made: weakref.WeakSet[Any]
    """The instances of the class that exist."""

    def __init__(self, log_level: str = "info") -> None:
        self._context = Context()
        self._context.init(["--ros-args", "--log-level", log_level])
        self._process = current_process()
        self._node: Any = None
        self._cancelled = False
        self._made.add(self)

    def __init_subclass__(cls) -> None:
        cls._made = weakref.WeakSet()

    def __del__(self) -> None:
        self._context.try_shutdown()

    @classmethod
    def cancel(cls) -> None:
        """End the runs of the program's instances of this class, also runs about to start in another thread."""
        for transport in list(cls._made):
            if transport._process is current_process():
                transport._cancelled = True
                if transport._node is not None:
                    transport._node.end()

    @contextlib.contextmanager
    def _running(self, node: Any) -> Iterator[None]:
        self._node = node
        if self._cancelled:
            node.end()
        try:
            with until_told_to_end(node.end):
                yield
        finally:
            self._node, self._cancelled = None, False


class Player(_Runner):
    """Plays bags."""

    def play(self, storage_options: StorageOptions, play_options: PlayOptions) -> None:
        """Play a bag to its end, or until Ctrl-C or `Player.cancel()`; raises RuntimeError if it cannot be read."""
        from rosbag2_py._player import PlayerNode

        node = PlayerNode(storage_options, play_options, self._context)
        with self._running(node):
            node.play()


class Recorder(_Runner):
    """Records bags."""

    def record(self, storage_options: StorageOptions, record_options: RecordOptions) -> None:
        """Record until Ctrl-C or `Recorder.cancel()`; raises RuntimeError if the bag cannot be written."""
        from rosbag2_py._recorder import RecorderNode

        settings = settings_of(storage_options, record_options.packing())
        node = RecorderNode(settings, record_options, self._context)
        with self._running(node):
            node.record()


def bag_rewrite(input_options: Sequence[StorageOptions], output_config_file: str) -> None:
    """Copy bags to bags with other settings, which a YAML file lists under `output_bags`."""
    from coursekit.bag.reader import BagReader
    from coursekit.bag.rewrite import rewrite
    from rosbag2_py._reader import say_opened
    from rosbag2_py._rewrite_options import outputs_in

    outputs = outputs_in(Path(output_config_file))
    readers = [BagReader(option.uri, option.storage_id, say_opened) for option in input_options]
    try:
        rewrite(readers, outputs)
    finally:
        for reader in readers:
            reader.close()
