"""Formats a launch description as a text tree."""

from __future__ import annotations

from .launch_description import LaunchDescription
from .launch_description_entity import LaunchDescriptionEntity
from .substitution import Substitution
from .utilities import is_a


def format_substitutions(subs: list[Substitution]) -> str:
    """Return the descriptions of substitutions, joined with a plus sign."""
    return " + ".join(sub.describe() for sub in subs)


class LaunchIntrospector:
    """Formats launch descriptions in human-readable form.

    >>> from launch.actions import LogInfo
    >>> print(LaunchIntrospector().format_launch_description(LaunchDescription([LogInfo(msg='hi')])))
    LaunchDescription()
    └── LogInfo('hi')
    """

    def format_launch_description(self, launch_description: LaunchDescription) -> str:
        """Return the tree of a launch description."""
        return "\n".join([_title(launch_description), *_branches(launch_description)])


def _title(entity: LaunchDescriptionEntity) -> str:
    from .actions import ExecuteLocal

    if is_a(entity, LaunchDescription):
        return "LaunchDescription()"
    if isinstance(entity, ExecuteLocal):
        command = [format_substitutions(part) for part in entity.process_description.cmd]
        return f"{type(entity).__name__}(cmd=[{', '.join(command)}])"
    return entity.describe()


def _branches(entity: LaunchDescriptionEntity) -> list[str]:
    """Return the lines of the entities inside an entity."""
    groups = [(None, entity.describe_sub_entities())]
    groups += [(text, list(subs)) for text, subs in entity.describe_conditional_sub_entities()]  # type: ignore[misc]
    items: list[tuple[str, list[str]]] = []
    for condition, entities in groups:
        if condition is not None:
            inner = _tree([(_title(sub), _branches(sub)) for sub in entities])
            items.append((f"ConditionalGroup({condition})", inner))
        else:
            items += [(_title(sub), _branches(sub)) for sub in entities]
    return _tree(items)


def _tree(items: list[tuple[str, list[str]]]) -> list[str]:
    """Return titles and their indented lines, prefixed with branches."""
    lines = []
    for index, (title, inner) in enumerate(items):
        last = index == len(items) - 1
        lines.append(("└── " if last else "├── ") + title)
        lines += [("    " if last else "│   ") + line for line in inner]
    return lines
