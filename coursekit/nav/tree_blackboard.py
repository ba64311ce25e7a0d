"""The blackboards of subtrees, as BehaviorTree.CPP has them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, MutableMapping
from typing import Any
from xml.etree.ElementTree import Element

STATUS_CHANGED = "__status_changed"
"""The key of a function that is told of each change: the node, its status before and after."""
SECONDS = "__seconds"
"""The key of a function that returns the time [s]."""
OF_ALL = (STATUS_CHANGED, SECONDS)
"""Keys that all blackboards of a tree share."""

Board = MutableMapping[str, Any]


class SubtreeBoard(Board):
    """A blackboard of its own; the keys in `mapped` are those of the outer one, under other names or the same.

    >>> outer = {"dock": (1.0, 2.0)}
    >>> board = SubtreeBoard(outer, {"goal": "dock", "path": "way"})
    >>> board["path"], board["tries"] = [], 3
    >>> board["goal"], sorted(board), outer
    ((1.0, 2.0), ['goal', 'path', 'tries'], {'dock': (1.0, 2.0), 'way': []})
    """

    def __init__(self, outer: Board, mapped: Mapping[str, str]) -> None:
        self._outer, self._mapped = outer, {key: key for key in OF_ALL} | dict(mapped)
        self._own: dict[str, Any] = {}

    def _place(self, key: str) -> tuple[Board, str]:
        """Return the blackboard that has a key, and its name there."""
        return (self._outer, self._mapped[key]) if key in self._mapped else (self._own, key)

    def __getitem__(self, key: str) -> Any:
        board, name = self._place(key)
        return board[name]

    def __setitem__(self, key: str, value: Any) -> None:
        board, name = self._place(key)
        board[name] = value

    def __delitem__(self, key: str) -> None:
        board, name = self._place(key)
        del board[name]

    def __iter__(self) -> Iterator[str]:
        yield from (key for key, outer in self._mapped.items() if outer in self._outer)
        yield from self._own

    def __len__(self) -> int:
        return sum(1 for _ in self)


def key_of(text: str) -> str | None:
    """Return the key in the text of a port; None for a plain value.

    >>> key_of("{goal}"), key_of("0.3")
    ('goal', None)
    """
    return text[1:-1] if text.startswith("{") and text.endswith("}") else None


def board_of(element: Element, tree: Element, outer: Board) -> Board:
    """Return the blackboard for a tree that a <SubTree> or <SubTreePlus> names.

    The ports of a <SubTree> are names of keys, those of a <SubTreePlus> `{keys}` or values.
    """
    ports = {name: text for name, text in element.attrib.items() if name not in ("ID", "name") and name[:2] != "__"}
    if element.tag == "SubTree":
        return outer if _true(element.get("__shared_blackboard")) else SubtreeBoard(outer, ports)
    mapped = {name: key for name, text in ports.items() if (key := key_of(text)) is not None}
    if _true(element.get("__autoremap")):
        inside = {key_of(text) for node in tree.iter() for text in node.attrib.values()}
        mapped |= {key: key for key in inside if key is not None and key not in ports}
    board = SubtreeBoard(outer, mapped)
    board.update({name: text for name, text in ports.items() if name not in mapped})
    return board


def _true(text: str | None) -> bool:
    return text in ("1", "true", "True", "TRUE")
