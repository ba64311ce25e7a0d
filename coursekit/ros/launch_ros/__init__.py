"""The part of the launch system for nodes, parameters, remappings and namespaces."""

from . import actions, descriptions, event_handlers, events, substitutions, utilities
from .parameters_type import SomeParameters
from .remap_rule_type import SomeRemapRules

__all__ = [
    "SomeParameters",
    "SomeRemapRules",
    "actions",
    "descriptions",
    "event_handlers",
    "events",
    "substitutions",
    "utilities",
]
