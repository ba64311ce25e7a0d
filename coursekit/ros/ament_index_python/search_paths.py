"""The prefixes that are searched: sourced workspaces, then coursekit's underlay."""

from __future__ import annotations

from coursekit.interfaces.find import prefixes


def get_search_paths() -> list[str]:
    """Return the existing prefixes, in the order of search.

    In ROS 2 this raises an error when nothing is sourced; here the underlay is always there.
    """
    return [str(prefix) for prefix in prefixes() if prefix.exists()]
