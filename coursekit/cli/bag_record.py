"""`ros2 bag record`."""

from __future__ import annotations

import datetime
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.bag.storage import DEFAULT_STORAGE_ID, SUFFIXES
from coursekit.processes.session import current

from . import api
from .bag_arguments import qos_overrides, readable_file, refuse, refusing

if TYPE_CHECKING:
    from argparse import Namespace

_LEVELS = ("debug", "info", "warn", "error", "fatal")
_MEBIBYTES_100 = 100 * 1024 * 1024


def register(verbs: Any) -> None:
    """Add the verb."""
    parser = verbs.add_parser("record", help="Record ROS data to a bag")
    _add_choice(parser)
    _add_output(parser)
    _add_discovery(parser)
    _add_limits(parser)
    _add_compression(parser)
    _add_behaviour(parser)
    parser.set_defaults(main=main)


def _add_choice(parser: Any) -> None:
    topics = parser.add_argument("topics", nargs="*", default=None, help="List of topics to record.")
    topics.completer = api.complete_topics
    parser.add_argument(
        "-a", "--all", action="store_true", help="Record all topics. Required if no explicit topic list or regex filters."
    )
    parser.add_argument(
        "-e",
        "--regex",
        default="",
        help="Record only topics containing provided regular expression. Applies on top of topics list.",
    )
    parser.add_argument(
        "-x",
        "--exclude",
        default="",
        help="Exclude topics containing provided regular expression. Works on top of --all, --regex, or topics list.",
    )
    parser.add_argument(
        "--include-unpublished-topics",
        action="store_true",
        help="Discover and record topics which have no publisher. Subscriptions on such topics will be made with "
        "default QoS unless otherwise specified in a QoS overrides file.",
    )
    parser.add_argument(
        "--include-hidden-topics",
        action="store_true",
        help="Discover and record hidden topics as well. These are topics used internally by ROS 2 implementation.",
    )


def _add_output(parser: Any) -> None:
    parser.add_argument(
        "-o",
        "--output",
        help="destination of the bagfile to create, defaults to a timestamped folder in the current directory",
    )
    parser.add_argument(
        "-s",
        "--storage",
        default=DEFAULT_STORAGE_ID,
        choices=sorted(SUFFIXES),
        help=f"storage identifier to be used, defaults to '{DEFAULT_STORAGE_ID}'",
    )
    parser.add_argument(
        "-f",
        "--serialization-format",
        default="",
        choices=["cdr"],
        help="rmw serialization format in which the messages are saved, defaults to the rmw currently in use",
    )
    parser.add_argument(
        "--storage-preset-profile",
        default="",
        help="Select a configuration preset for storage. This flag settings can still be overriden by "
        "corresponding settings in the config passed with --storage-config-file.",
    )
    parser.add_argument(
        "--storage-config-file", type=readable_file, help="Path to a yaml file defining storage specific configurations."
    )


def _add_discovery(parser: Any) -> None:
    parser.add_argument(
        "--no-discovery",
        action="store_true",
        help="disables topic auto discovery during recording: only topics present at startup will be recorded",
    )
    parser.add_argument(
        "-p",
        "--polling-interval",
        type=int,
        default=100,
        help="time in ms to wait between querying available topics for recording. "
        "It has no effect if --no-discovery is enabled.",
    )
    parser.add_argument("--ignore-leaf-topics", action="store_true", help="Ignore topics without a publisher.")
    parser.add_argument(
        "--qos-profile-overrides-path",
        type=readable_file,
        help="Path to a yaml file defining overrides of the QoS profile for specific topics.",
    )


def _add_limits(parser: Any) -> None:
    parser.add_argument(
        "-b",
        "--max-bag-size",
        type=int,
        default=0,
        help="maximum size in bytes before the bagfile will be split. Default it is zero, recording written in "
        "single bagfile and splitting is disabled.",
    )
    parser.add_argument(
        "-d",
        "--max-bag-duration",
        type=int,
        default=0,
        help="maximum duration in seconds before the bagfile will be split. Default is zero, recording written in "
        "single bagfile and splitting is disabled. If both splitting by size and duration are enabled, the bag will "
        "split at whichever threshold is reached first.",
    )
    parser.add_argument(
        "--max-cache-size",
        type=int,
        default=_MEBIBYTES_100,
        help="maximum size (in bytes) of messages to hold in each buffer of cache. Default is 100 mebibytes.",
    )
    parser.add_argument(
        "--snapshot-mode",
        action="store_true",
        help="Enable snapshot mode. Messages will not be written to the bagfile until the "
        '"/rosbag2_recorder/snapshot" service is called.',
    )


def _add_compression(parser: Any) -> None:
    parser.add_argument(
        "--compression-mode",
        default="none",
        choices=["none", "file", "message"],
        help="Determine whether to compress by file or message. Default is 'none'.",
    )
    parser.add_argument(
        "--compression-format",
        default="",
        choices=["zstd"],
        help="Specify the compression format/algorithm. Default is none.",
    )
    for name, default in (("queue-size", 1), ("threads", 0)):
        parser.add_argument(
            f"--compression-{name}", type=int, default=default, help="(here nothing is dropped: it changes nothing)"
        )


def _add_behaviour(parser: Any) -> None:
    parser.add_argument("--start-paused", action="store_true", help="Start the recorder in a paused state.")
    parser.add_argument(
        "--use-sim-time",
        action="store_true",
        help="Use simulation time for message timestamps by subscribing to the /clock topic. Until first /clock "
        "message is received, no messages will be written to bag.",
    )
    parser.add_argument("--node-name", default="rosbag2_recorder", help="Specify the recorder node name.")
    parser.add_argument("--disable-keyboard-controls", action="store_true", help="disables keyboard controls for recorder")
    parser.add_argument("--log-level", default="info", choices=_LEVELS, help="Logging level.")


def default_folder() -> str:
    """Return the folder of an unnamed recording: rosbag2_ and the time."""
    there = time.localtime(current().clock.now() // 10**9)
    return time.strftime("rosbag2_%Y_%m_%d-%H_%M_%S", there)


@refusing
def main(args: Namespace) -> int:
    """Record until Ctrl-C."""
    _check(args)
    uri = args.output or default_folder()
    if Path(uri).is_dir():
        raise refuse(f"Output folder '{uri}' already exists.")
    from rosbag2_py import Recorder

    storage, options = _storage_options(args, uri), _record_options(args)
    try:
        Recorder(args.log_level).record(storage, options)
    except (RuntimeError, OSError) as error:
        raise refuse(str(error)) from None
    return 0


def _check(args: Namespace) -> None:
    if args.all and args.topics:
        raise refuse("Specify either --all or topics, but not both simultaneously.")
    if not (args.all or args.topics or args.regex):
        raise refuse("Invalid choice: Must specify topic(s), --regex or --all")
    if args.all and args.regex:
        print("[WARN] [ros2bag]: --all will override --regex.")
    if args.topics and args.exclude:
        raise refuse("--exclude argument cannot be used when specifying a list of topics explicitly")
    if args.compression_format and args.compression_mode == "none":
        raise refuse("Invalid choice: Cannot specify compression format without a compression mode.")
    if args.compression_mode == "message" and args.storage == "mcap":
        raise refuse(
            "Invalid choice: compression_mode 'message' is not supported by the MCAP storage plugin. You can enable "
            "chunk compression by setting `compression: 'Zstd'` in storage config"
        )
    if args.compression_queue_size < 0:
        raise refuse("Compression queue size must be at least 0.")
    if args.use_sim_time and args.no_discovery:
        raise refuse(
            "--use-sim-time and --no-discovery both set, but are incompatible settings. "
            "The /clock topic needs to be discovered to record with sim time."
        )
    if args.polling_interval <= 0:
        raise refuse("--polling-interval must be at least 1 ms")


def _storage_options(args: Namespace, uri: str) -> Any:
    from rosbag2_py import StorageOptions

    return StorageOptions(
        uri=uri,
        storage_id=args.storage,
        max_bagfile_size=args.max_bag_size,
        max_bagfile_duration=args.max_bag_duration,
        max_cache_size=args.max_cache_size,
        storage_preset_profile=args.storage_preset_profile,
        storage_config_uri=args.storage_config_file or "",
        snapshot_mode=args.snapshot_mode,
    )


def _record_options(args: Namespace) -> Any:
    from rosbag2_py import RecordOptions

    options = RecordOptions()
    options.is_discovery_disabled = args.no_discovery
    options.rmw_serialization_format = args.serialization_format
    options.topic_polling_interval = datetime.timedelta(milliseconds=args.polling_interval)
    options.topic_qos_profile_overrides = qos_overrides(args.qos_profile_overrides_path)
    same = (
        "all", "topics", "regex", "exclude", "include_hidden_topics", "include_unpublished_topics", "node_name",
        "compression_mode", "compression_format", "compression_queue_size", "compression_threads", "start_paused",
        "ignore_leaf_topics", "use_sim_time", "disable_keyboard_controls",
    )  # fmt: skip
    for name in same:
        setattr(options, name, getattr(args, name))
    return options
