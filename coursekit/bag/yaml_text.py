"""YAML in rosbag2's layout."""

from __future__ import annotations

from typing import Any

import yaml


class _Dumper(yaml.SafeDumper):
    """Indents lists and quotes strings as rosbag2 does."""

    def increase_indent(self, flow: bool = False, indentless: bool = False) -> Any:
        return super().increase_indent(flow, False)


def _text(dumper: yaml.SafeDumper, text: str) -> yaml.ScalarNode:
    style = '"' if not text or "\n" in text else None
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style=style)


_Dumper.add_representer(str, _text)


def dump(value: Any) -> str:
    """Return YAML text in rosbag2's layout, without the final line break.

    >>> print(dump({"topics": ["/scan", "/odom"], "note": ""}))
    topics:
      - /scan
      - /odom
    note: ""
    """
    return yaml.dump(value, Dumper=_Dumper, sort_keys=False, width=10**9, allow_unicode=True).rstrip("\n")
