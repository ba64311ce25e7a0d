"""The YAML file that configures the output of `ros2 bag convert`."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from coursekit.bag.errors import BagError
from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.metadata_file import load_settings
from coursekit.bag.rewrite import Output
from rosbag2_py._compression_options import CompressionOptions, compression_mode_from_string
from rosbag2_py._storage import StorageOptions
from rosbag2_py._writer import settings_of

_STORAGE = {
    "uri": str,
    "storage_id": str,
    "max_bagfile_size": int,
    "max_bagfile_duration": int,
    "max_cache_size": int,
    "storage_preset_profile": str,
    "storage_config_uri": str,
}
_CHOICE = {
    "all": bool,
    "topics": list,
    "regex": str,
    "exclude": str,
    "compression_mode": str,
    "compression_format": str,
}
_WITHOUT_EFFECT = (
    "snapshot_mode", "is_discovery_disabled", "rmw_serialization_format", "topic_polling_interval", "node_prefix",
    "compression_queue_size", "compression_threads", "topic_qos_profile_overrides", "include_hidden_topics",
    "include_unpublished_topics", "start_paused", "ignore_leaf_topics", "use_sim_time", "output_serialization_format",
)  # fmt: skip
"""Options of recording that have no effect on an existing bag."""


def outputs_in(path: Path) -> list[Output]:
    """Read the file; raises RuntimeError with the fault in it."""
    document = load_settings(path)
    if not isinstance(document, dict) or "output_bags" not in document:
        raise BagError("Output bag config YAML file must have top-level key 'output_bags'")
    bags = document["output_bags"]
    if not isinstance(bags, list) or not all(isinstance(bag, dict) for bag in bags):
        raise BagError("Top-level key 'output_bags' must contain a list of StorageOptions/RecordOptions dicts.")
    return [_output(bag, path) for bag in bags]


def _output(values: dict[str, Any], path: Path) -> Output:
    for key, value in values.items():
        kind = (_STORAGE | _CHOICE).get(key)
        if kind is None and key not in _WITHOUT_EFFECT:
            known = ", ".join([*_STORAGE, *_CHOICE])
            raise BagError(f"{path}: there is no option '{key}'; there are {known}")
        if kind is not None and not isinstance(value, kind):
            raise BagError(f"{path}: '{key}' is {value!r}, and should be {kind.__name__}")
    if not values.get("uri"):
        raise BagError(f"{path}: each of output_bags needs a 'uri', the folder of the bag to write")
    storage = StorageOptions(**{key: value for key, value in values.items() if key in _STORAGE})
    mode = compression_mode_from_string(values.get("compression_mode", ""))
    packing = CompressionOptions(values.get("compression_format", ""), mode)
    return Output(settings_of(storage, packing), _Choice(values, path))


class _Choice:
    """Whether a topic is written to an output bag."""

    def __init__(self, values: dict[str, Any], path: Path) -> None:
        self._all = values.get("all", False)
        self._topics = set(map(str, values.get("topics", ())))
        try:
            self._regex = re.compile(values["regex"]) if values.get("regex") else None
            self._exclude = re.compile(values["exclude"]) if values.get("exclude") else None
        except re.error as error:
            raise BagError(f"{path}: a regular expression is wrong: {error}") from None

    def __call__(self, topic: TopicMetadata) -> bool:
        if self._exclude and self._exclude.search(topic.name):
            return False
        return bool(self._all or topic.name in self._topics or (self._regex and self._regex.search(topic.name)))
