"""`ros2 bag record|play|info|list|convert|reindex`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.cli import api, bag_play, bag_record
from coursekit.cli.bag_arguments import add_reader, refuse, refusing

if TYPE_CHECKING:
    import argparse
    from argparse import Namespace

_PLUGINS = {
    "storage": {
        "mcap": ("rosbag2 storage plugin for mcap files", "rosbag2_storage_plugins::MCAPStorage"),
        "sqlite3": ("rosbag2 storage plugin for sqlite3 files", "rosbag2_storage_plugins::SqliteStorage"),
    },
    "converter": {"cdr_converter": ("messages as they travel in ROS 2", "rosbag2_cpp::CdrConverter")},
    "compressor": {"zstd": ("zstd, for messages or files", "rosbag2_compression_zstd::ZstdCompressor")},
    "decompressor": {"zstd": ("zstd, for messages or files", "rosbag2_compression_zstd::ZstdDecompressor")},
}
_BASES = {
    "storage": "rosbag2_storage::storage_interfaces::ReadWriteInterface",
    "converter": "rosbag2_cpp::converter_interfaces::SerializationFormatConverter",
    "compressor": "rosbag2_compression::BaseCompressorInterface",
    "decompressor": "rosbag2_compression::BaseDecompressorInterface",
}


def register(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command."""
    parser = subparsers.add_parser("bag", help="Various rosbag related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    _register_convert(verbs)
    info = verbs.add_parser("info", help="Print information about a bag to the screen")
    add_reader(info)
    info.set_defaults(main=show_info)
    lister = verbs.add_parser("list", help="Print information about available plugins to the screen")
    lister.add_argument("plugin_type", choices=list(_PLUGINS), help="lists available plugins")
    lister.add_argument("--verbose", action="store_true", help="output verbose information about the available plugin")
    lister.set_defaults(main=list_plugins)
    bag_play.register(verbs)
    bag_record.register(verbs)
    reindex = verbs.add_parser("reindex", help="Reconstruct metadata file for a bag")
    add_reader(reindex)
    reindex.set_defaults(main=make_metadata)


def _register_convert(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    convert = verbs.add_parser("convert", help="Given an input bag, write out a new bag with different settings")
    convert.add_argument(
        "-i",
        "--input",
        required=True,
        action="append",
        nargs="+",
        metavar=("uri", "storage_id"),
        help="URI (and optional storage ID) of an input bag. May be provided more than once for multiple input bags",
    )
    convert.add_argument(
        "-o", "--output-options", required=True, help="YAML file with the key 'output_bags': what to write, and how"
    )
    convert.set_defaults(main=convert_bags)


@refusing
def show_info(args: Namespace) -> int:
    """Print the metadata of a bag."""
    from rosbag2_py import Info

    print(Info().read_metadata(args.bag_path, args.storage))
    return 0


@refusing
def make_metadata(args: Namespace) -> int:
    """Recreate the metadata.yaml of a bag."""
    from pathlib import Path

    from rosbag2_py import Reindexer, StorageOptions

    if not Path(args.bag_path).is_dir():
        raise refuse("Must specify a bag directory")
    Reindexer().reindex(StorageOptions(uri=args.bag_path, storage_id=args.storage))
    return 0


@refusing
def convert_bags(args: Namespace) -> int:
    """Write bags with other settings."""
    from rosbag2_py import StorageOptions, bag_rewrite

    for words in args.input:
        if len(words) > 2:
            raise api.Unhappy(f"--input expects 1 or 2 arguments, {len(words)} provided")
    bag_rewrite([StorageOptions(*words) for words in args.input], args.output_options)
    return 0


def list_plugins(args: Namespace) -> int:
    """Print the plugins of a kind."""
    if args.verbose:
        print(f"available {args.plugin_type} plugins are:")
    for name, (description, kind) in _PLUGINS[args.plugin_type].items():
        print(f"{'name: ' if args.verbose else ''}{name}")
        if args.verbose:
            print(f"\t{description}\n\ttype: {kind}\n\tbase_class: {_BASES[args.plugin_type]}")
    return 0


