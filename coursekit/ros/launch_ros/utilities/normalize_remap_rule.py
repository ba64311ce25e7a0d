"""Normalizes remappings."""

from __future__ import annotations

from collections.abc import Generator

from launch.utilities import ensure_argument_type, normalize_to_list_of_substitutions

from ..remap_rule_type import RemapRule, SomeRemapRule, SomeRemapRules


def normalize_remap_rule(remapping: SomeRemapRule) -> RemapRule:
    """Return a (from, to) pair as two tuples of substitutions.

    Raises:
        TypeError: if it is not a pair; lists are not accepted, as in ROS 2.
    """
    ensure_argument_type(remapping, (tuple,), "remapping")
    if len(remapping) != 2:
        raise TypeError(f"remapping rule must be a 2-tuple '(from, to)', got {remapping!r}")
    source, target = remapping
    return tuple(normalize_to_list_of_substitutions(source)), tuple(
        normalize_to_list_of_substitutions(target)
    )


def normalize_remap_rules(remappings: SomeRemapRules) -> Generator[RemapRule, None, None]:
    """Yield each pair as two tuples of substitutions."""
    for remapping in remappings:
        yield normalize_remap_rule(remapping)
