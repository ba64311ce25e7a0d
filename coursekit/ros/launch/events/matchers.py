"""Matchers that check whether an event concerns an action."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..action import Action


def matches_action(target_action: Action) -> Callable[[Action], bool]:
    """Return a function that accepts `target_action` only."""
    return lambda action: action is target_action
