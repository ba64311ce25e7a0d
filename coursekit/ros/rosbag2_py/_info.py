"""A bag's metadata. In ROS 2: rosbag2_py._info."""

from __future__ import annotations

from coursekit.bag.reader import BagReader
from rosbag2_py._reader import say_opened
from rosbag2_py._storage import BagMetadata


class Info:
    """Reads the metadata of a bag."""

    def read_metadata(self, uri: str, storage_id: str = "") -> BagMetadata:
        """Return the metadata of a folder or a file; raises RuntimeError if it is not a bag."""
        reader = BagReader(uri, storage_id, say_opened)
        reader.close()
        return BagMetadata.of(reader.facts)
