"""A YAML loader whose mappings have line numbers."""

from __future__ import annotations

from typing import Any

import yaml


class PlacedDict(dict):  # type: ignore[type-arg]
    """A mapping with the line of its first key."""

    line = 0


class PlacedLoader(yaml.SafeLoader):
    """Reads plain YAML; every mapping becomes a PlacedDict."""


def _construct_mapping(loader: PlacedLoader, node: yaml.MappingNode) -> Any:
    mapping = PlacedDict()
    mapping.line = node.start_mark.line + 1
    yield mapping
    mapping.update(loader.construct_mapping(node))


PlacedLoader.add_constructor("tag:yaml.org,2002:map", _construct_mapping)


def read_yaml(text: str) -> Any:
    """Return the value of a YAML text.

    >>> read_yaml('launch:\\n- log: {message: hi}')['launch'][0].line
    2

    Raises:
        yaml.YAMLError: if the text is not YAML.
    """
    loader = PlacedLoader(text)
    try:
        return loader.get_single_data()
    finally:
        loader.dispose()
