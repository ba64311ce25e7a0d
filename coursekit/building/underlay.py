"""The generated files of the underlay: Python packages of interfaces, their type stubs, executables.

`python -m coursekit.building.underlay` writes them into this checkout; every build and installation does so, too. They are
not in Git: .gitignore lists them.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from pathlib import Path

from coursekit.files import in_order
from coursekit.interfaces.find import KINDS, UNDERLAY
from coursekit.interfaces.stubs import package_stubs

from .executables import EXECUTABLES

_WORDS = {"msg": "Messages", "srv": "Services", "action": "Actions"}
_EXECUTABLE = 0o755


def files() -> dict[str, str]:
    """Return the text of each generated file, by its path relative to the package.

    >>> "ros/std_msgs/msg/__init__.py" in files(), "lib/demo_nodes_py/talker" in files()
    (True, True)
    """
    return {**dict(_interfaces()), **dict(_programs())}


def write(package: Path = UNDERLAY) -> list[Path]:
    """Write the files that have changed; return the paths of all generated files."""
    text_by_path = {package / name: text for name, text in files().items()}
    for path, text in text_by_path.items():
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="\n")
        if package / "lib" in path.parents:
            path.chmod(_EXECUTABLE)
    return list(text_by_path)


def _interfaces() -> Iterator[tuple[str, str]]:
    for folder in in_order((UNDERLAY / "share").iterdir()):
        definitions = {kind: in_order((folder / kind).glob(f"*.{kind}")) for kind in KINDS}
        for kind in (kind for kind, paths in definitions.items() if paths):
            yield f"ros/{folder.name}/__init__.py", f'"""Interfaces of {folder.name}."""\n'
            yield f"ros/{folder.name}/{kind}/__init__.py", _module(folder.name, kind)
        stubs = package_stubs(folder.name, chain.from_iterable(definitions.values()))
        yield from ((f"ros/{name}", text) for name, text in stubs.items())


def _module(package: str, kind: str) -> str:
    return (
        f'"""{_WORDS[kind]} of {package}, made from their definition files when first used."""\n\n'
        "from coursekit.interfaces.face import expose\n\n"
        "__getattr__, __dir__, __all__ = expose(__name__, __file__)\n"
    )


def _programs() -> Iterator[tuple[str, str]]:
    for package, programs in EXECUTABLES.items():
        for name, place in programs.items():
            module, _, function = place.partition(":")
            imported = function if function == "main" else f"{function} as main"
            yield f"lib/{package}/{name}", (
                "#!/usr/bin/env python3\n"
                f'"""ros2 run {package} {name}"""\n\nimport sys\n\nfrom {module} import {imported}\n\n'
                'if __name__ == "__main__":\n    sys.exit(main())\n'
            )


if __name__ == "__main__":
    write()
