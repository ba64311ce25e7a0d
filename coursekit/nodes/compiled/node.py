"""The node that represents one of a compiled program: executors may serve its callback groups separately."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.callback_groups import CallbackGroup
from rclpy.node import Node

from coursekit.nodes.cpp_node import CppNode

if TYPE_CHECKING:
    from rclpy.executors import Executor


class GroupsApart(Node):
    """Has groups that an executor serves without the node, or that are not served before an executor gets them."""

    def __init__(self, node_name: str, **options: Any) -> None:
        self._apart: dict[CallbackGroup, Any] = {}
        """Groups separate from the node, and the executors that serve them."""
        super().__init__(node_name, **options)

    def set_apart(self, group: CallbackGroup, executor: Executor | None = None) -> None:
        """Assign a group to an executor, or to none."""
        self._apart[group] = executor
        for entity in self._rclpy_entities():
            if entity.callback_group is group:
                _serve(entity, executor)

    def serve_entity(self, entity: Any) -> None:
        """Attach an entity to the executor of its group."""
        group = entity.callback_group
        _serve(entity, self._apart.get(group, self.executor))

    def _rclpy_own(self, kept: list[Any], entity: Any, group: CallbackGroup) -> Any:
        if group not in self._apart:
            return super()._rclpy_own(kept, entity, group)
        group.add_entity(entity)
        kept.append(entity)
        _serve(entity, self._apart[group])
        return entity

    def _rclpy_attach(self, executor: Executor) -> None:
        for entity in self._rclpy_entities():
            if entity.callback_group not in self._apart:
                executor._attach(entity)


class CompiledNode(GroupsApart, CppNode):
    """A node of a compiled program."""


def _serve(entity: Any, executor: Executor | None) -> None:
    if executor is not None:
        executor._attach(entity)
        return
    for source in entity._sources():
        source.attach(None, None)
