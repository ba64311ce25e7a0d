"""Behaviour trees as nav2 runs them: nodes that are ticked and say running, success or failure, read from XML."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Mapping
from typing import Any

IDLE, RUNNING, SUCCESS, FAILURE = "idle", "running", "success", "failure"
DEEPEST = 100
"""Levels of a tree, at the most: one whose subtrees contain each other has no end."""


class TreeError(ValueError):
    """No tree, and why."""


class TreeNode:
    """A node of a tree; `ports` are its attributes in the XML, `board` is where nodes leave things for each other."""

    arity: tuple[int, float] = (0, 0)
    """How many children it may have."""

    def __init__(self, name: str, ports: Mapping[str, str], children: list[TreeNode], board: dict[str, Any]) -> None:
        self.name, self.ports, self.children, self.board, self.status = name, ports, children, board, IDLE
        self.prepare()

    def prepare(self) -> None:
        """What a node does once; ValueError when a port cannot work."""

    def step(self) -> str:
        """The work of a tick: RUNNING, SUCCESS or FAILURE."""
        raise NotImplementedError(self.name)

    def stop(self) -> None:
        """Give up what is under way, and be as at first."""

    def tick(self) -> str:
        """Work a little."""
        self.status = self.step()
        return self.status

    def halt(self) -> None:
        """Stop if it is running."""
        if self.status == RUNNING:
            self.stop()
        self.status = IDLE
        for child in self.children:
            child.halt()

    # -- ports

    def get(self, port: str, default: Any = None) -> Any:
        """The value of a port: a text, or what `{key}` has on the board."""
        text = self.ports.get(port)
        if text is None:
            return default
        return self.board.get(text[1:-1], default) if text.startswith("{") and text.endswith("}") else text

    def number(self, port: str, default: float) -> float:
        """A port as a number; TreeError when it is none."""
        try:
            return float(self.get(port, default))
        except (TypeError, ValueError):
            raise TreeError(f"{self.name}: {port} is {self.ports.get(port)!r}, not a number") from None

    def put(self, port: str, value: Any) -> None:
        """Leave a value for others, where the port names a `{key}`."""
        text = self.ports.get(port, "")
        if text.startswith("{") and text.endswith("}"):
            self.board[text[1:-1]] = value


Kinds = Mapping[str, Callable[..., TreeNode]]


def read_tree(text: str, kinds: Kinds, board: dict[str, Any]) -> TreeNode:
    """The main tree of an XML text; TreeError when it is none, or has nodes that are not among `kinds`."""
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError as fault:
        raise TreeError(f"is no XML: {fault}") from None
    trees = {tree.get("ID", ""): tree for tree in root.iter("BehaviorTree")}
    main = root.get("main_tree_to_execute") or next(iter(trees), "")
    if root.tag != "root" or main not in trees:
        raise TreeError(f"has no <BehaviorTree ID='{main}'>; it has: {', '.join(trees) or 'none'}")
    return _tree(trees, main, kinds, board, 0)


def _tree(trees: Mapping[str, ElementTree.Element], name: str, kinds: Kinds, board: dict[str, Any], depth: int) -> TreeNode:
    if name not in trees:
        raise TreeError(f"names a subtree '{name}', which it does not have; it has: {', '.join(trees)}")
    if len(trees[name]) != 1:
        raise TreeError(f"tree '{name}' has {len(trees[name])} nodes at its top; it should have one")
    return _node(trees[name][0], trees, kinds, board, depth + 1)


def _node(
    element: ElementTree.Element, trees: Mapping[str, ElementTree.Element], kinds: Kinds, board: dict[str, Any], depth: int
) -> TreeNode:
    if depth > DEEPEST:
        raise TreeError(f"is more than {DEEPEST} levels deep: does a subtree contain itself?")
    ports = dict(element.attrib)
    kind = ports.pop("ID", "") if element.tag in ("Action", "Condition", "Control", "Decorator") else element.tag
    if kind in ("SubTree", "SubTreePlus"):
        return _tree(trees, ports.get("ID", ""), kinds, board, depth)
    if kind not in kinds:
        raise TreeError(f"has a node '{kind}', which is not known here; known are: {', '.join(sorted(kinds))}")
    children = [_node(one, trees, kinds, board, depth + 1) for one in element]
    made = kinds[kind](ports.pop("name", kind), ports, children, board)
    low, high = made.arity
    if not low <= len(children) <= high:
        raise TreeError(f"'{kind}' has {len(children)} children; it should have {low if low == high else f'{low} or more'}")
    return made
