"""Behaviour trees as in nav2: nodes that are ticked and return running, success or failure, read from XML."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Mapping
from typing import Any

from coursekit.nav.tree_blackboard import STATUS_CHANGED, Board, board_of, key_of

IDLE, RUNNING, SUCCESS, FAILURE = "idle", "running", "success", "failure"
DEEPEST, MOST_NODES = 100, 5000
"""Maximum number of levels and nodes of a tree: a tree whose subtrees contain each other would be infinite."""


class TreeError(ValueError):
    """An invalid tree; the message gives the reason."""


class TreeNode:
    """A node of a tree; `ports` are its attributes in the XML, `board` is the blackboard that it shares with others.

    >>> class Battery(TreeNode):
    ...     def step(self):
    ...         return SUCCESS if self.board["charge"] > self.number("least", 0.2) else FAILURE
    >>> board = {"charge": 0.3}
    >>> Battery("battery", {"least": "0.5"}, [], board).tick(), Battery("battery", {}, [], board).tick()
    ('failure', 'success')
    """

    arity: tuple[int, float] = (0, 0)
    """Minimum and maximum number of children."""
    uid = 0
    """Its number in the tree: a node before its children."""

    def __init__(self, name: str, ports: Mapping[str, str], children: list[TreeNode], board: Board) -> None:
        self.name, self.ports, self.children, self.board, self.status = name, ports, children, board, IDLE
        self.prepare()

    def prepare(self) -> None:
        """Check the ports and initialize the node; ValueError when a port is invalid."""

    def step(self) -> str:
        """Do the work of a tick; return RUNNING, SUCCESS or FAILURE."""
        raise NotImplementedError(self.name)

    def stop(self) -> None:
        """Cancel work in progress and return to the initial state."""

    def tick(self) -> str:
        """Do one step of work and return the status. The child of a decorator begins anew after its end."""
        before = self.status
        if self.children and before != RUNNING:  # a parent runs before its children do
            self._note(before, RUNNING)
            before = RUNNING
        self.status = self.step()
        self._note(before, self.status)
        if self.arity == (1, 1) and self.children and self.children[0].status in (SUCCESS, FAILURE):
            self.children[0].halt()
        return self.status

    def halt(self) -> None:
        """Stop the node and its children if they are running."""
        if self.status == RUNNING:
            self.stop()
        self._note(self.status, IDLE)
        self.status = IDLE
        for child in self.children:
            child.halt()

    def _note(self, before: str, after: str) -> None:
        note = self.board.get(STATUS_CHANGED)
        if note is not None and before != after:
            note(self, before, after)

    def retire(self) -> None:
        """Let go of what the node and its children hold: their tree is not ticked any more."""
        for child in self.children:
            child.retire()

    # -- ports

    def get(self, port: str, default: Any = None) -> Any:
        """Return the value of a port: a string, or the blackboard value of `{key}`.

        >>> node = TreeNode("drive", {"goal": "{dock}", "speed": "0.3"}, [], {"dock": (1.0, 2.0)})
        >>> node.get("goal"), node.get("speed"), node.get("path", "none")
        ((1.0, 2.0), '0.3', 'none')
        """
        text = self.ports.get(port)
        if text is None:
            return default
        key = key_of(text)
        return text if key is None else self.board.get(key, default)

    def number(self, port: str, default: float) -> float:
        """Return a port as a number; TreeError when it is not one."""
        try:
            return float(self.get(port, default))
        except (TypeError, ValueError):
            raise TreeError(f"{self.name}: {port} is {self.ports.get(port)!r}, not a number") from None

    def put(self, port: str, value: Any) -> None:
        """Set the blackboard value, if the port names a `{key}`.

        >>> board = {}
        >>> TreeNode("plan", {"path": "{way}"}, [], board).put("path", [(0.0, 0.0), (1.0, 0.0)])
        >>> board
        {'way': [(0.0, 0.0), (1.0, 0.0)]}
        """
        key = key_of(self.ports.get(port, ""))
        if key is not None:
            self.board[key] = value


class SubTree(TreeNode):
    """Ticks the tree that it names."""

    arity = (1, 1)

    def step(self) -> str:
        """Tick the top of that tree."""
        return self.children[0].tick()


Kinds = Mapping[str, Callable[..., TreeNode]]


def read_tree(text: str, kinds: Kinds, board: Board) -> TreeNode:
    """Parse the main tree of an XML text; TreeError when it is invalid, or has nodes that are not in `kinds`.

    >>> from coursekit.nav.tree_controls import CONTROLS
    >>> text = '''<root main_tree_to_execute="Main"><BehaviorTree ID="Main">
    ...   <Fallback><AlwaysFailure/><Inverter><AlwaysFailure/></Inverter></Fallback></BehaviorTree></root>'''
    >>> read_tree(text, CONTROLS, {}).tick()
    'success'
    """
    try:
        root = ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError) as fault:
        raise TreeError(f"is no XML: {fault}") from None
    trees = {tree.get("ID", ""): tree for tree in root.iter("BehaviorTree")}
    main = root.get("main_tree_to_execute") or next(iter(trees), "")
    if root.tag != "root" or main not in trees:
        raise TreeError(f"has no <BehaviorTree ID='{main}'>; it has: {', '.join(trees) or 'none'}")
    return _Reader(trees, kinds).tree(main, board, 0)


class _Reader:
    """Creates nodes from elements; each use of a subtree creates its own nodes."""

    def __init__(self, trees: Mapping[str, ElementTree.Element], kinds: Kinds) -> None:
        self._trees, self._kinds = trees, kinds
        self._made = 0

    def tree(self, name: str, board: Board, depth: int) -> TreeNode:
        if name not in self._trees:
            raise TreeError(f"names a subtree '{name}', which it does not have; it has: {', '.join(self._trees)}")
        nodes = self._trees[name]
        if len(nodes) != 1:
            raise TreeError(f"tree '{name}' has {len(nodes)} nodes at its top; it should have one")
        return self._node(nodes[0], board, depth + 1)

    def _node(self, element: ElementTree.Element, board: Board, depth: int) -> TreeNode:
        number = self._number(depth)
        ports = dict(element.attrib)
        kind = ports.pop("ID", "") if element.tag in ("Action", "Condition", "Control", "Decorator") else element.tag
        if kind in ("SubTree", "SubTreePlus"):
            return self._subtree(element, board, depth, number)
        if kind not in self._kinds:
            known = ", ".join(sorted(self._kinds))
            raise TreeError(f"has a node '{kind}', which is not known here; known are: {known}")
        children = [self._node(child, board, depth + 1) for child in element]
        tree_node = self._kinds[kind](ports.pop("name", kind), ports, children, board)
        tree_node.uid = number
        low, high = tree_node.arity
        if not low <= len(children) <= high:
            wanted = low if low == high else f"{low} or more"
            raise TreeError(f"'{kind}' has {len(children)} children; it should have {wanted}")
        return tree_node

    def _subtree(self, element: ElementTree.Element, board: Board, depth: int, number: int) -> TreeNode:
        name = element.get("ID", "")
        inside = self._trees.get(name, element)
        node = SubTree(name, {}, [self.tree(name, board_of(element, inside, board), depth)], board)
        node.uid = number
        return node

    def _number(self, depth: int) -> int:
        """Return the number of the next node; TreeError for a tree that is too large."""
        self._made += 1
        if depth > DEEPEST:
            raise TreeError(f"is more than {DEEPEST} levels deep: does a subtree contain itself?")
        if self._made > MOST_NODES:
            raise TreeError(f"has more than {MOST_NODES} nodes, its subtrees counted as often as they are named")
        return self._made
