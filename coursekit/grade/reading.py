"""The judges' reading functions for a student's workspace: each takes a file and returns validated facts.

In a notebook they are called directly. In grading they run in their own sandbox after the student's programs have
ended, and only facts come out. A hostile file can therefore only make its reader return facts that it could also
contain.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.interfaces.model import Message
from coursekit.suggestions import similar

from .sandbox_facts import BuildFacts, RobotFacts, facts_of
from .verdict import NO_HINT, Wrong

if TYPE_CHECKING:
    from coursekit.urdf import UrdfError

LONGEST = 1 << 20
"""The maximum size of a text file [bytes]."""
_OPEN = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)


def text(workspace: Path, path: str) -> str:
    """Return the text of a file."""
    return _bytes(_file(workspace, path)).decode(errors="replace")


def exists(workspace: Path, path: str) -> bool:
    """Whether a file or folder of that name exists."""
    return (workspace / path).exists()


def installed(workspace: Path, package: str, path: str) -> bool:
    """Whether the last build of a package installed this file of its share folder.

    A file that is no longer in `data_files` stays in install/, as with every colcon; setuptools' list is of the last build.
    """
    shares = (workspace / "install" / folder / "share" / package for folder in (package, ""))
    file = next((share / path for share in shares if (share / "package.xml").exists()), None)
    if file is None or not file.exists():
        return False
    log = workspace / "build" / package / "install.log"
    if file.is_symlink() or not log.is_file():  # colcon takes away its old links, and cmake writes no such list
        return True
    lines = _bytes(log).decode(errors="replace").replace(os.sep, "/").splitlines()
    return any(line.endswith(f"/share/{package}/{path}") for line in lines)


def build(workspace: Path, package: str, of: Sequence[str] = ()) -> BuildFacts:
    """Return whether a package was built, and why the build differs from its source."""
    from coursekit.packages.build_state import build_fault

    prefixes = (workspace / "install" / package, workspace / "install")
    marker = Path("share", "ament_index", "resource_index", "packages", package)
    return BuildFacts(any((prefix / marker).exists() for prefix in prefixes), build_fault(workspace, package, of))


def robot(workspace: Path, path: str) -> RobotFacts:
    """Return a robot's description with xacro expanded."""
    from coursekit.urdf import UrdfError, load

    file = _file(workspace, path)
    try:
        description = load(file)
        if description.faults:  # ROS drops the rest of such a link and continues; a judge would not notice
            raise description.faults[0]
        return facts_of(description)
    except UrdfError as error:
        told = f"{_place(file, error)}: {error.what}"
        raise Wrong("a description that ROS takes", told, error.cure.split("\n")[0]) from None
    except ValueError as error:
        raise Wrong("a description that can be judged", str(error), hint=NO_HINT) from None


def _place(file: Path, error: UrdfError) -> str:
    """Return the position of a fault; lines refer to the expanded text, so a xacro file's fault is located by element."""
    if file.suffix == ".xacro" and error.element:
        return f"{file.name}, expanded: {error.element}"
    return f"{file.name}:{error.line}" if error.line else file.name


def message(workspace: Path, path: str) -> Message:
    """Return a message definition; its package is the folder above `msg`."""
    from coursekit.interfaces.errors import InterfaceError
    from coursekit.interfaces.parser import parse_file

    file = _file(workspace, path)
    _bytes(file)
    try:
        message = parse_file(file.parent.parent.name, file)
    except InterfaceError as error:
        raise Wrong(f"{file.name} that can be read", str(error).replace(str(workspace), "~/ros2_ws"), hint=NO_HINT) from None
    if not isinstance(message, Message):
        raise Wrong("a message definition", file.name, hint=NO_HINT)
    return message


def _cause_in_yaml(said: str) -> str:
    if "ros__parameters" in said:
        return "Two underscores in ros__parameters, and two spaces more before each line below it?"
    return "YAML is indented with spaces, never with tabs." if r"\t" in said else ""


def parameters(workspace: Path, path: str, nodes: Sequence[str]) -> dict[str, dict[str, Any]]:
    """Return the parameters that a file sets for each of these nodes, as parsed by ROS."""
    from coursekit.rcl.arguments import parse_ros_arguments

    file = _file(workspace, path)
    _bytes(file)
    try:
        read = parse_ros_arguments(["--ros-args", "--params-file", str(file)])
        return {node: read.parameters_for(node) for node in nodes}
    except Exception as error:
        said = str(error).replace(str(file), file.name)
        raise Wrong("a parameter file that ROS can read", said[:500], _cause_in_yaml(said), hint=NO_HINT) from None


READINGS: dict[str, Callable[..., Any]] = {
    "text": text,
    "exists": exists,
    "installed": installed,
    "build": build,
    "robot": robot,
    "message": message,
    "parameters": parameters,
}
KINDS: dict[str, Any] = {
    "text": str,
    "exists": bool,
    "installed": bool,
    "build": BuildFacts,
    "robot": RobotFacts,
    "message": Message,
    "parameters": dict[str, dict[str, bool | int | float | str | list[bool] | list[int] | list[float] | list[str] | None]],
}
"""The reading functions by name."""


def _file(workspace: Path, path: str) -> Path:
    file = workspace / path
    if not file.is_file():
        raise Wrong(f"the file {path} in {workspace.name}/", "it is not there", _near(file))
    return file


def _bytes(file: Path) -> bytes:
    """Read a regular file of bounded size, never a pipe or device."""
    try:
        descriptor = os.open(file, _OPEN)
    except OSError as error:
        raise Wrong(f"{file.name} that can be read", error.strerror or "it cannot be opened", hint=NO_HINT) from None
    with os.fdopen(descriptor, "rb") as opened:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise Wrong(f"{file.name} as a file", "it is something else", hint=NO_HINT)
        data = opened.read(LONGEST + 1)
    if len(data) > LONGEST:
        raise Wrong(f"{file.name} of at most {LONGEST >> 20} MB", "it is larger", hint=NO_HINT)
    return data


def _near(path: Path) -> str:
    """Return the files in the folder instead, similar names first."""
    folder = path.parent
    if not folder.is_dir():
        return f"The folder {folder.name}/ does not exist either."
    names = sorted(entry.name for entry in folder.iterdir())
    close = similar(path.name, names, 3)
    return f"{folder.name}/ has: {', '.join([*close, *(name for name in names if name not in close)][:8]) or 'nothing'}"
