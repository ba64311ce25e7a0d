"""Filters for the output of nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from ament_index_python import get_resource, has_resource
from launch_testing.tools import output

_KINDS = ("prefixes", "patterns")


def get_rmw_output_filter(rmw_implementation: str, filter_type: str) -> list[str]:
    """Return the prefixes or patterns of lines that a middleware itself writes; it may list them in the ament index.

    Raises:
        TypeError: when `filter_type` is neither 'prefixes' nor 'patterns'.
    """
    if filter_type not in _KINDS:
        raise TypeError(f'Unsupported filter_type "{filter_type}". Supported types: {list(_KINDS)}')
    resource = f"rmw_output_{filter_type}"
    if not has_resource(resource, rmw_implementation):
        return []
    return get_resource(resource, rmw_implementation)[0].splitlines()


def basic_output_filter(
    filtered_prefixes: Iterable[str] | None = None,
    filtered_patterns: Iterable[str] | None = None,
    filtered_rmw_implementation: str | None = None,
) -> Callable[[str], str]:
    """Return a function that removes lines as launch_testing's does, and also those of a middleware."""
    prefixes = output.get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes
    patterns = output.get_default_filtered_patterns() if filtered_patterns is None else filtered_patterns
    if filtered_rmw_implementation:
        prefixes = [*prefixes, *get_rmw_output_filter(filtered_rmw_implementation, "prefixes")]
        patterns = [*patterns, *get_rmw_output_filter(filtered_rmw_implementation, "patterns")]
    return output.basic_output_filter(prefixes, patterns)
