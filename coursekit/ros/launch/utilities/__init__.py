"""Helpers shared by actions, substitutions and users' launch files."""

from .class_tools_impl import is_a, is_a_subclass, isclassinstance
from .ensure_argument_type_impl import ensure_argument_type
from .entities import visit_all_entities_and_collect_futures
from .futures import create_future, create_futures
from .normalize_to_list_of_substitutions_impl import (
    normalize_to_list_of_entities,
    normalize_to_list_of_substitutions,
)
from .perform_substitutions_impl import perform_substitutions
from .signal_management import AsyncSafeSignalManager

__all__ = [
    "AsyncSafeSignalManager",
    "create_future",
    "create_futures",
    "ensure_argument_type",
    "is_a",
    "is_a_subclass",
    "isclassinstance",
    "normalize_to_list_of_entities",
    "normalize_to_list_of_substitutions",
    "perform_substitutions",
    "visit_all_entities_and_collect_futures",
]
