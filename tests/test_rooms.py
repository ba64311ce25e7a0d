"""The rooms of the house: arrows between them point one way, and no module needs itself to be imported."""

import ast
import re
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "coursekit"
ROOMS = (
    "files", "xunit", "suggestions", "words", "systems", "wiring", "geometry",  # the ground
    "tf", "urdf", "sim", "slam", "nav",  # the sciences, without ROS
    "interfaces", "bag", "cpp", "core", "rcl", "processes", "joined",  # the middleware
    "ros", "net", "packages", "nodes", "lib", "view", "jupyter",
    "grade", "cli", "lab",  # what people use
    "building",
)  # fmt: skip
"""From the ground up: a room imports from those before it."""
FACES = {
    ("ros", "cli"): "ros2cli, ros2param, ... are Humble's modules of the commands, which coursekit.cli carries out",
    ("ros", "nodes"): "turtle_tf2_py and controller_manager are Humble's modules of nodes",
}
"""Arrows upward: coursekit/ros is what sourcing ROS puts on the path, and holds the faces of other rooms, too."""
UPSTREAM = ("rclpy", "launch", "launch_ros", "launch_pytest")
"""Packages whose public modules import each other in Humble; programs import from all of them."""


def modules():
    """The package's modules by name, with their files; those below coursekit/ros by the name that programs use."""
    file_by_module = {}
    for file in PACKAGE.rglob("*.py"):
        parts = list(file.relative_to(PACKAGE.parent).with_suffix("").parts)
        parts = parts[2:] if parts[1] == "ros" else parts
        parts = parts[:-1] if parts and parts[-1] == "__init__" else parts
        if parts and parts[:2] != ["coursekit", "share"]:
            file_by_module[".".join(parts)] = file
    return file_by_module


MODULES = modules()


def room_of(module):
    parts = module.split(".")
    if parts[0] == "coursekit":
        return parts[1] if len(parts) > 1 else None
    return "ros" if module in MODULES else None


def imports(module):
    """(imported name, line) of a module, also within functions; those for type checkers apart."""
    tree, file = ast.parse(MODULES[module].read_text(encoding="utf-8")), MODULES[module]
    package = module.split(".") if file.name == "__init__.py" else module.split(".")[:-1]
    typing = {id(inner) for node in ast.walk(tree) if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test)
              for inner in ast.walk(node)}  # fmt: skip
    for node in ast.walk(tree):
        if id(node) in typing:
            continue
        if isinstance(node, ast.Import):
            yield from ((alias.name, node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else []
            base = ".".join([*above, *([node.module] if node.module else [])])
            yield from ((f"{base}.{alias.name}" if f"{base}.{alias.name}" in MODULES else base, node.lineno)
                        for alias in node.names)  # fmt: skip


def texts(module):
    """(module named by a text, line) of a module."""
    for node in ast.walk(ast.parse(MODULES[module].read_text(encoding="utf-8"))):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            named = re.fullmatch(r"(coursekit(?:\.\w+)+)(:\w+)?", node.value)
            if named and named[1] in MODULES:
                yield named[1], node.lineno


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_imports_and_names_only_what_is_below_it(room):
    above = set(ROOMS[ROOMS.index(room) + 1 :])
    wrong = [
        f"{module}:{line} {name}"
        for module in MODULES
        if room_of(module) == room and room != "wiring"
        for name, line in [*imports(module), *texts(module)]
        if room_of(name) in above and (room, room_of(name)) not in FACES
    ]
    assert wrong == []


def test_every_room_is_in_the_list():
    assert {room_of(module) for module in MODULES} - {None} == set(ROOMS)


def test_no_module_needs_itself_to_be_imported():
    graph = {module: {name for name, _ in imports(module) if name in MODULES and name != module} for module in MODULES}
    reachable = {}
    circles = []
    for start in graph:
        seen, todo = set(), list(graph[start])
        while todo:
            module = todo.pop()
            if module not in seen:
                seen.add(module)
                todo += graph[module] if module not in reachable else reachable[module]
        reachable[start] = seen
        if start in seen and start.split(".")[0] not in UPSTREAM:
            circles.append(start)
    assert circles == []
