"""Reconstruction of a bag's metadata. In ROS 2: rosbag2_py._reindexer."""

from __future__ import annotations

from pathlib import Path

from rclpy.logging import get_logger

from coursekit.bag.reindex import reindex
from rosbag2_py._storage import StorageOptions


class Reindexer:
    """Reconstructs metadata.yaml from the files of a bag."""

    def reindex(self, storage_options: StorageOptions) -> None:
        """Read the files and write metadata.yaml; raises RuntimeError if there are none or they are damaged."""
        log = get_logger("rosbag2_cpp")
        log.info(f"Beginning reindexing bag in directory: {storage_options.uri}")
        reindex(Path(storage_options.uri), storage_options.storage_id)
        log.info("Reindexing complete.")
