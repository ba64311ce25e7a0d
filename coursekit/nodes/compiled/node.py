"""The node that stands for one of a compiled program: executors may serve its callback groups apart."""

from __future__ import annotations

from typing import Any

from rclpy.callback_groups import CallbackGroup

from coursekit.nodes.cpp_node import CppNode


class CompiledNode(CppNode):
    """Has groups that an executor serves without the node, or that none serves before it is given to one."""

    def __init__(self, node_name: str, **options: Any) -> None:
        self._apart: dict[CallbackGroup, Any] = {}
        """Groups apart from the node, and the executors that serve them."""
        super().__init__(node_name, **options)

    def set_apart(self, group: CallbackGroup, executor: Any = None) -> None:
        """Have an executor serve a group, or none."""
        self._apart[group] = executor
        for entity in self._rclpy_entities():
            if entity.callback_group is group:
                _serve(entity, executor)

    def serve(self, entity: Any) -> None:
        """Have the executor that serves an entity's group look at what makes the entity ready."""
        group = entity.callback_group
        _serve(entity, self._apart.get(group, self.executor))

    def _rclpy_own(self, kept: list[Any], entity: Any, group: Any) -> Any:
        if group not in self._apart:
            return super()._rclpy_own(kept, entity, group)
        group.add_entity(entity)
        kept.append(entity)
        _serve(entity, self._apart[group])
        return entity

    def _rclpy_attach(self, executor: Any) -> None:
        for entity in self._rclpy_entities():
            if entity.callback_group not in self._apart:
                executor._attach(entity)


def _serve(entity: Any, executor: Any) -> None:
    if executor is not None:
        executor._attach(entity)
        return
    for source in entity._sources():
        source.attach(None, None)
