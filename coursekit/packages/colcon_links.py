"""colcon's build of Python packages, without queries whose answers are known, and without links where they are refused.

Most accounts on Windows may not create links. `colcon build --symlink-install` needs none: Python modules are read from
the source, whose folder comes first on PYTHONPATH, as the folder with the links does elsewhere. Data files are copied, and
copied again when their package is looked up: coursekit.systems.link_copies.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.metadata
import os
import re
from pathlib import Path
from typing import Any

from colcon_core.argument_parser import ArgumentParserDecorator, ArgumentParserDecoratorExtensionPoint
from colcon_core.plugin_system import satisfies_version
from colcon_core.shell import create_environment_hook
from colcon_core.task.python import get_data_files_mapping, get_setup_data
from colcon_core.task.python.build import PythonBuildTask

from coursekit.files import read_text
from coursekit.systems import link_copies
from coursekit.systems.links import can_link

from .outdated import outdate

_OWNERS = ("colcon_core.task.python.build", "colcon_ros.task.ament_python.build")
"""The modules in which colcon looks up its build of Python packages."""
_COMMANDS = {"build", "build_py", "develop", "egg_info", "install", "install_data", "symlink_data"}
"""The commands of setuptools and colcon that colcon queries or calls."""
_EDITABLE_UNTIL = 80
"""The first version of setuptools whose `develop` has no --editable."""
_stands_for_links = False


def stands_for_links() -> bool:
    """Whether links were requested in this build and cannot be created."""
    return _stands_for_links


class LinksWherePossible(ArgumentParserDecoratorExtensionPoint):  # type: ignore[misc]
    """Inspects the parsed command line of every verb."""

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(ArgumentParserDecoratorExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    def decorate_argument_parser(self, *, parser: Any) -> Any:
        """Return the parser, wrapped to inspect its result."""
        return _Looking(parser)


class _Looking(ArgumentParserDecorator):  # type: ignore[misc]
    def parse_args(self, *args: Any, **kwargs: Any) -> argparse.Namespace:
        parsed: argparse.Namespace = self._parser.parse_args(*args, **kwargs)
        if hasattr(parsed, "symlink_install"):
            _prepare(parsed)
        return parsed


def _prepare(parsed: argparse.Namespace) -> None:
    global _stands_for_links
    _stands_for_links = parsed.symlink_install and not can_link(Path(parsed.build_base).resolve())
    parsed.symlink_install = parsed.symlink_install and not _stands_for_links
    for owner in _OWNERS:
        importlib.import_module(owner).PythonBuildTask = PythonBuild  # type: ignore[attr-defined]


class PythonBuild(PythonBuildTask):  # type: ignore[misc]
    """colcon's build of a Python package, which records copies made instead of links and starts setup.py less often."""

    async def build(self, *, additional_hooks: list[Any] | None = None) -> int:
        """Return the exit code of the build."""
        args, name = self.context.args, self.context.pkg.name
        link_copies.forget(Path(args.install_base), name)
        self._hooks = list(additional_hooks or [])
        done = await super().build(additional_hooks=self._hooks)
        return int(done or 0)

    async def _get_available_commands(self, path: str, env: Any) -> set[str]:
        """Return the commands; for setuptools they are known, which saves colcon a start of setup.py in every build."""
        return _COMMANDS if _is_by_setuptools(path) else await super()._get_available_commands(path, env)

    async def _get_available_options(self, path: str, env: Any, command: str) -> set[str]:
        """Return the options of a command, likewise."""
        known = command == "develop" and _is_by_setuptools(path)
        return {"--editable"} if known else await super()._get_available_options(path, env, command)

    async def _undo_develop(self, pkg: Any, args: Any, env: Any) -> Any:
        """Extend colcon's step before copying, when the build environment is known and scripts are not written yet."""
        undone = await super()._undo_develop(pkg, args, env)
        outdate(Path(args.build_base), Path(args.install_base))
        if not undone and _stands_for_links:
            self._read_from_source(get_setup_data(pkg, env))
        return undone

    def _read_from_source(self, setup: dict[str, Any]) -> None:
        args, name = self.context.args, self.context.pkg.name
        source = Path(os.path.abspath(args.path))
        folder = source / (setup.get("package_dir") or {}).get("", "")
        modules = [folder / module for module in _modules(setup)]
        if all(module.exists() for module in modules):
            hook = ("pythonpath_develop", Path(args.build_base), name, "PYTHONPATH", str(folder))
            self._hooks += create_environment_hook(*hook, mode="prepend")
        else:  # `package_dir` maps them to differently named folders
            modules = []
            print(f"{name} is copied: build it again after every change of a Python file", flush=True)
        files = get_data_files_mapping(setup.get("data_files") or [])
        noted = {Path(target).as_posix(): source / file for file, target in files.items()}
        link_copies.note(Path(args.install_base), name, noted, modules)


def _is_by_setuptools(folder: str) -> bool:
    """Whether a setup.py uses the setuptools version that coursekit requires."""
    major = int(importlib.metadata.version("setuptools").partition(".")[0])
    text = read_text(Path(folder, "setup.py"), errors="replace")
    return major < _EDITABLE_UNTIL and bool(re.search(r"^\s*(from|import)\s+setuptools\b", text, re.MULTILINE))


def _modules(setup: dict[str, Any]) -> list[str]:
    """Return the folders and files of a package's modules, derived from their names."""
    folders = [package for package in setup.get("packages") or [] if "." not in package]
    return folders + [module.replace(".", os.sep) + ".py" for module in setup.get("py_modules") or []]


__all__ = ["LinksWherePossible", "PythonBuild", "stands_for_links"]
