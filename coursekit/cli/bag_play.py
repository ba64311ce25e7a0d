"""`ros2 bag play`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .bag_arguments import (
    add_reader,
    not_negative_float,
    not_negative_int,
    positive_float,
    qos_overrides,
    readable_file,
    refusing,
)

if TYPE_CHECKING:
    from argparse import ArgumentParser, Namespace

_DEFAULT_CLOCK_HZ = 40.0


def register(verbs: Any) -> None:
    """Add the verb."""
    parser = verbs.add_parser("play", help="Play back ROS data from a bag")
    add_reader(parser)
    _add_choice(parser)
    _add_time(parser)
    _add_behaviour(parser)
    parser.set_defaults(main=main)


def _add_choice(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--topics",
        nargs="+",
        default=[],
        help="topics to replay, separated by space. If none specified, all topics will be replayed.",
    )
    parser.add_argument(
        "--qos-profile-overrides-path",
        type=readable_file,
        help="Path to a yaml file defining overrides of the QoS profile for specific topics.",
    )
    parser.add_argument(
        "--remap",
        "-m",
        nargs="+",
        default=[],
        help='list of topics to be remapped: in the form "old_topic1:=new_topic1 old_topic2:=new_topic2 etc."',
    )
    parser.add_argument(
        "--storage-config-file", type=readable_file, help="Path to a yaml file defining storage specific configurations."
    )
    parser.add_argument(
        "--read-ahead-queue-size",
        type=int,
        default=1000,
        help="size of message queue rosbag tries to hold in memory (here messages are read as they are played)",
    )


def _add_time(parser: ArgumentParser) -> None:
    parser.add_argument(
        "-r", "--rate", type=positive_float, default=1.0, help="rate at which to play back messages. Valid range > 0.0."
    )
    parser.add_argument(
        "-l",
        "--loop",
        action="store_true",
        help="enables loop playback when playing a bagfile: it starts back at the beginning on reaching the end and "
        "plays indefinitely.",
    )
    parser.add_argument(
        "--clock",
        type=positive_float,
        nargs="?",
        const=_DEFAULT_CLOCK_HZ,
        default=0.0,
        help="Publish to /clock at a specific frequency in Hz, to act as a ROS Time Source. Value must be positive. "
        "Defaults to not publishing.",
    )
    parser.add_argument(
        "-d",
        "--delay",
        type=not_negative_float,
        default=0.0,
        help="Sleep duration before play (each loop), in seconds. Negative durations invalid.",
    )
    parser.add_argument(
        "--start-offset",
        type=not_negative_float,
        default=0.0,
        help="Start the playback player this many seconds into the bag file.",
    )


def _add_behaviour(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--disable-keyboard-controls", action="store_true", help="disables keyboard controls for playback"
    )
    parser.add_argument(
        "-p", "--start-paused", action="store_true", help="Start the playback player in a paused state."
    )
    parser.add_argument(
        "--wait-for-all-acked",
        type=not_negative_int,
        default=-1,
        metavar="TIMEOUT",
        help="Wait until all published messages are acknowledged by all subscribers or until the timeout elapses in "
        "millisecond before play is terminated.",
    )
    parser.add_argument(
        "--disable-loan-message", action="store_true", help="Disable to publish as loaned message (here none are)."
    )
    parser.add_argument(
        "--log-level", default="info", choices=["debug", "info", "warn", "error", "fatal"], help="Logging level."
    )


@refusing
def main(args: Namespace) -> int:
    """Play to the end, or until Ctrl-C."""
    from rosbag2_py import Player, StorageOptions

    config = args.storage_config_file or ""
    storage = StorageOptions(uri=args.bag_path, storage_id=args.storage, storage_config_uri=config)
    options = _play_options(args)
    Player(args.log_level).play(storage, options)
    return 0


def _play_options(args: Namespace) -> Any:
    from rosbag2_py import PlayOptions

    options = PlayOptions()
    options.topics_to_filter = args.topics
    options.topic_qos_profile_overrides = qos_overrides(args.qos_profile_overrides_path)
    options.clock_publish_frequency = args.clock
    options.wait_acked_timeout = args.wait_for_all_acked
    options.topic_remapping_options = ["--ros-args", *(word for rule in args.remap for word in ("--remap", rule))]
    same = (
        "read_ahead_queue_size", "rate", "loop", "delay", "disable_keyboard_controls", "start_paused", "start_offset",
        "disable_loan_message",
    )  # fmt: skip
    for name in same:
        setattr(options, name, getattr(args, name))
    return options
