"""Nodes of behaviour trees that are C++ classes: a program loads their libraries and has the nodes, the tree is here."""

from __future__ import annotations

import os
from collections.abc import Iterable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from ament_index_python import get_search_paths
from rosidl_runtime_py.utilities import get_message

from coursekit.cpp.age import is_of_another_age
from coursekit.interfaces.cdr import deserialize, serialize
from coursekit.nav.behavior_tree import IDLE, RUNNING, Kinds, TreeError, TreeNode
from coursekit.nav.tree_blackboard import Board
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.host import ANOTHER_AGE
from coursekit.nodes.compiled.tree_nodes import STATUSES
from coursekit.nodes.nav2.cpp_plugins import CppPlugin
from coursekit.systems.layout import executable_files

if TYPE_CHECKING:
    from coursekit.nodes.nav2.bt_navigator import BtNavigator

PROGRAM = "__tree_nodes"
"""The name of the programs; colcon makes one for each package with such a library, and each can load all of them."""
CHILD = "NavigatorsChild"
"""The node that stands for a child there."""
_CHANGES = "changes for nodes in C++"
"""The key of a blackboard's Changes."""


class CppTreeNodes(CppPlugin):
    """The classes of nodes in libraries, and the nodes of these classes."""

    served = "tree_nodes"

    def __init__(self, program: str, libraries: Iterable[str], node: BtNavigator) -> None:
        super().__init__(program, "\n".join(libraries), "bt_navigator_navigate_to_pose_rclcpp_node", node, None)
        self._made = 0

    def configure(self) -> None:
        """Lend it the navigator's node and buffer."""
        node = self.node
        loop, patience = (int(node.number(name)) for name in ("bt_loop_duration", "default_server_timeout"))
        shared = map(self.share, (node, node.where.buffer_for_plugins()))
        self.ask("configure", self.name, *shared, loop, patience, node.text("odom_topic"))

    def kinds(self) -> Kinds:
        """Return the classes by the names that they are registered with."""
        answer, names = self.ask("kinds"), []
        while answer.rest():
            names.append(answer.text())
        return {name: partial(CppTreeNode, self, name) for name in names}

    def number(self) -> int:
        """Return a number for a new node or blackboard."""
        self._made += 1
        return self._made


class CppTreeNode(TreeNode):
    """A node of a C++ class. Its calls raise CppFault when it throws."""

    arity = (0, float("inf"))

    def __init__(self, nodes: CppTreeNodes, kind: str, *given: Any) -> None:
        self._nodes, self._kind = nodes, kind
        super().__init__(*given)

    def prepare(self) -> None:
        """Make it there. Raises TreeError, for ports that it does not have as well."""
        if _CHANGES not in self.board:
            self.board[_CHANGES] = Changes(self._nodes.number())
            if self.board.get("node") is None:  # in a subtree, as on a robot
                self._nodes.ask("empty_board", self.board[_CHANGES].number)
        self._number, self._shared = self._nodes.number(), self._nodes.share(self) if self.children else 0
        try:
            self._ask("create", self._description())
        except CppFault as fault:
            raise TreeError(f"Exception when loading BT: {fault}") from None

    def _description(self) -> str:
        root = ElementTree.Element("root")
        tree = ElementTree.SubElement(root, "BehaviorTree", ID="Main")
        element = ElementTree.SubElement(tree, self._kind, {**self.ports, "name": self.name})
        for place in range(len(self.children)):
            ElementTree.SubElement(element, CHILD, of=str(self._shared), place=str(place))
        return ElementTree.tostring(root, encoding="unicode")

    def step(self) -> str:
        """Tick it."""
        return STATUSES[self._ask("tick")]

    def halt(self) -> None:
        """Halt it if it is running, and let it begin anew."""
        if self.status != IDLE:
            self._ask("halt" if self.status == RUNNING else "rest")
        self._note(self.status, IDLE)
        self.status = IDLE
        for child in self.children:
            child.halt()

    def retire(self) -> None:
        """Destroy it."""
        self._nodes.ask("forget", self._number)
        self._nodes.unshare(self._shared)
        changes = self.board.pop(_CHANGES, None)
        if changes is not None:
            self._nodes.ask("forget_board", changes.number)
        super().retire()

    def _ask(self, what: str, *words: str) -> int:
        """Let it do something, with the same blackboard on both sides. Returns the number of a tick's status."""
        changes: Changes = self.board[_CHANGES]
        answer = self._nodes.ask(what, changes.number, rest=changes.told(self.board) + packed(self._number, *words))
        status = answer.integer() if what == "tick" else 0
        changes.take(answer, self.board)
        return status


class Changes:
    """What nodes in C++ know of a blackboard: values that cross are the same on both sides."""

    def __init__(self, number: int) -> None:
        self.number = number
        self._known: dict[str, Any] = {}

    def told(self, board: Board) -> bytes:
        """Pack the values that they do not know yet."""
        news = [(key, value) for key, value in board.items() if self._known.get(key, self) is not value]
        self._known.update(news)
        crossing = [packed(key, name, data) for key, value in news for name, data in crossed(value)]
        return packed(len(crossing)) + b"".join(crossing)

    def take(self, answer: Unpacker, board: Board) -> None:
        """Set the values that they have set."""
        while answer.rest():
            key, kind, data = answer.text(), answer.text(), answer.blob()
            board[key] = self._known[key] = value_of(kind, data)


def crossed(value: Any) -> Iterable[tuple[str, bytes]]:
    """Yield the name of a value's type, and the value; nothing for one that stays here.

    >>> list(crossed("dock")), list(crossed(2)), list(crossed(object()))
    ([('str', b'dock')], [('int', b'2')], [])
    """
    kind = type(value)
    if kind in (str, bool, int, float):
        yield kind.__name__, str(value).encode()
    elif hasattr(kind, "get_fields_and_field_types"):
        yield _name(kind), serialize(value)
    elif isinstance(value, list) and value and hasattr(value[0], "get_fields_and_field_types"):
        yield f"{_name(type(value[0]))}[]", packed(*value)


def value_of(kind: str, data: bytes) -> Any:
    """Return the value that C++ packed under a name.

    >>> value_of("int", b"2"), value_of("bool", b"True")
    (2, True)
    """
    frame = Unpacker(data)
    if kind == "float":
        return frame.real()
    if kind in ("str", "int", "bool"):
        text = data.decode(errors="replace")
        return text if kind == "str" else int(text) if kind == "int" else text == "True"
    if not kind.endswith("[]"):
        return deserialize(data, get_message(kind))
    messages = []
    while frame.rest():
        messages.append(frame.message(get_message(kind.removesuffix("[]"))))
    return messages


def _name(kind: type[Any]) -> str:
    package, middle, *_ = kind.__module__.split(".")
    return f"{package}/{middle}/{kind.__name__}"


def load(names: Iterable[str], node: BtNavigator) -> CppTreeNodes | None:
    """Load the libraries of these names that workspaces have; None if there is none.

    Raises CppFault for a name that is neither theirs nor nav2's.
    """
    libraries = [library for name in names if (library := _library(name)) is not None]
    if not libraries:
        return None
    return CppTreeNodes(_program(libraries[0]), map(str, libraries), node)


def _library(name: str) -> Path | None:
    folders = [Path(prefix, "lib") for prefix in get_search_paths()]
    folders += [Path(folder) for folder in os.environ.get("LD_LIBRARY_PATH", "").split(os.pathsep) if folder]
    for folder in folders:
        if (path := folder / f"lib{name}.so").is_file():
            return path
    if name.startswith("nav2_"):
        return None
    text = f"lib{name}.so: cannot open shared object file: No such file or directory"
    raise CppFault("BT::RuntimeError", f"Could not load library: {text}")


def _program(library: Path) -> str:
    """Return the program beside a library, or another one that can load it."""
    for folder in (library.parent, *(Path(prefix, "lib") for prefix in get_search_paths())):
        for path in (file for package in sorted(folder.glob("*/")) for file in executable_files(package, PROGRAM)):
            if path.is_file() and is_of_another_age(path):
                raise CppFault("BT::RuntimeError", ANOTHER_AGE.format(name=library.name))
            if path.is_file():
                return str(path)
    text = f"Could not load library: {library.name}: no package was built with BT_PLUGIN_EXPORT among its definitions"
    raise CppFault("BT::RuntimeError", text)
