"""Bags from Python: readers, writers, recorder, player; Humble's names. In ROS 2: rosbag2_py.

Names are imported on first use. A program thus loads only the modules that it uses.
"""

from __future__ import annotations

import importlib
from typing import Any

from coursekit.processes import script

_HOMES = {
    "_compression_options": (
        "CompressionMode",
        "CompressionOptions",
        "compression_mode_from_string",
        "compression_mode_to_string",
    ),
    "_info": ("Info",),
    "_reader": ("SequentialCompressionReader", "SequentialReader", "get_registered_readers"),
    "_reindexer": ("Reindexer",),
    "_storage": (
        "BagMetadata",
        "ConverterOptions",
        "FileInformation",
        "ReadOrder",
        "ReadOrderSortBy",
        "StorageFilter",
        "StorageOptions",
        "TopicInformation",
        "TopicMetadata",
        "get_default_storage_id",
    ),
    "_transport": ("PlayOptions", "Player", "RecordOptions", "Recorder", "bag_rewrite"),
    "_writer": (
        "SequentialCompressionWriter",
        "SequentialWriter",
        "get_registered_compressors",
        "get_registered_serializers",
        "get_registered_writers",
    ),
}
_HOME = {name: home for home, names in _HOMES.items() for name in names}
__all__ = sorted(_HOME)


def __getattr__(name: str) -> Any:
    if name in _HOMES:  # programs in the tutorials use rosbag2_py._storage.StorageOptions
        return importlib.import_module(f"rosbag2_py.{name}")
    if name not in _HOME:
        raise AttributeError(f"module 'rosbag2_py' has no attribute '{name}'")
    return getattr(importlib.import_module(f"rosbag2_py.{_HOME[name]}"), name)


def __dir__() -> list[str]:
    return __all__


script.join()
