"""Fresh modules for each process: two runs of a program share no globals, and a rebuilt package is read again."""

from __future__ import annotations

import builtins
import importlib
import importlib.machinery
import os
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

from .patching import PRIVATE, patch_manager
from .process import Process, current_process

_real_import = builtins.__import__
_real_import_module = importlib.import_module
_lock = threading.RLock()
if hasattr(os, "register_at_fork"):  # a forked interpreter lacks the threads that may hold it
    os.register_at_fork(after_in_child=_lock._at_fork_reinit)  # type: ignore[attr-defined]
_path_lock = threading.Lock()
_added: set[str] = set()
"""Folders added to sys.path for processes."""
_KEY = "coursekit.modules"
_NEVER = ("__pycache__", "coursekit")


class PrivateModules:
    """The private modules of one process: those of the workspace packages on its path."""

    def __init__(self, folders: Sequence[str]) -> None:
        self.folders = list(folders)
        self.names = {name for folder in folders for name in top_level_names(Path(folder))}
        self.modules: dict[str, ModuleType] = {}
        self.main: ModuleType | None = None
        """The program itself, whose `__name__` is `__main__`."""
        self._depth = 0

    def find(self, name: str, wanted: Sequence[str]) -> ModuleType | None:
        """Return a module already imported by the process, if it has all the wanted attributes."""
        module = self.modules.get(name)
        if module is None or any(not hasattr(module, name) for name in wanted if name != "*"):
            return None
        return module

    @contextmanager
    def in_place(self) -> Iterator[None]:
        """Make sys.modules contain this process's modules."""
        with _lock:
            if self._depth:
                yield
                return
            self._depth += 1
            others = self._take_out()
            sys.modules.update(self.modules)
            importlib.invalidate_caches()
            # Bytecode of a source that a cell changes again within the same second would look up to date.
            keep, sys.dont_write_bytecode = sys.dont_write_bytecode, True
            try:
                yield
            finally:
                sys.dont_write_bytecode = keep
                self.modules.update(self._take_out())
                sys.modules.update(others)
                self._depth -= 1

    @contextmanager
    def in_place_with_main(self) -> Iterator[None]:
        """Make sys.modules contain the program itself, too, for look-ups of its definitions."""
        with self.in_place():
            others = sys.modules["__main__"]
            sys.modules["__main__"] = self.main or others
            try:
                yield
            finally:
                sys.modules["__main__"] = others

    def _take_out(self) -> dict[str, ModuleType]:
        mine = [name for name in list(sys.modules) if name.partition(".")[0] in self.names]
        return {name: sys.modules.pop(name) for name in mine}


def top_level_names(folder: Path) -> list[str]:
    """Return the modules and packages that can be imported from a folder, in order.

    A folder without an __init__.py does not count if a real module has that name: the `launch` folder of a package built
    with --symlink-install must not hide ROS's launch, nor a folder `numpy` numpy. Coursekit is never private.
    """
    names: list[str] = []
    bare: list[str] = []
    for entry in folder.iterdir() if folder.is_dir() else ():
        if entry.suffix == ".py":
            names.append(entry.stem)
        elif entry.is_dir() and entry.name.isidentifier() and entry.name not in _NEVER:
            (names if (entry / "__init__.py").exists() else bare).append(entry.name)
    if bare:  # few folders have any, and each entry of the path costs disk access
        here = folder.resolve()
        beside = [place for place in sys.path if Path(place or ".").resolve() != here]
        names += [name for name in bare if not _is_elsewhere(name, beside)]
    return sorted(names)


def _is_elsewhere(name: str, beside: Sequence[str]) -> bool:
    """Whether Python would import another module of this name from the folders `beside` the one that contains it."""
    spec = importlib.machinery.PathFinder.find_spec(name, beside)
    return name in sys.builtin_module_names or (spec is not None and spec.origin is not None)


def use_private_modules(process: Process, folders: Sequence[str]) -> None:
    """Give `process` fresh modules of the packages in `folders`, which also move to the front of sys.path."""
    patch_manager.enter(process.session, PRIVATE)
    _put_first(folders)
    process.locals[_KEY] = PrivateModules(folders)


def _put_first(folders: Sequence[str]) -> None:
    """Replace the list: another process that iterates over the old one must not miss a folder that is being moved."""
    with _path_lock:
        _added.update(folder for folder in folders if folder not in sys.path)
        sys.path = list(dict.fromkeys([*folders, *sys.path]))


def private_of_process() -> PrivateModules | None:
    """Return the private modules of the calling process, if it has any."""
    process = current_process()
    private: PrivateModules | None = process.locals.get(_KEY) if process is not None else None
    return private


def _private_of_caller(top: str) -> PrivateModules | None:
    private = private_of_process()
    return private if private is not None and top in private.names else None


def import_(
    name: str,
    globals: dict[str, Any] | None = None,
    locals: dict[str, Any] | None = None,
    fromlist: Any = (),
    level: int = 0,
) -> Any:
    if current_process() is None:
        return _real_import(name, globals, locals, fromlist, level)
    package = (globals or {}).get("__package__") or ""
    private = _private_of_caller((name if not level else package).partition(".")[0])
    if private is None:
        return _real_import(name, globals, locals, fromlist, level)
    known = private.find(name, fromlist or ()) if not level else None
    if known is not None:
        return known if fromlist else private.modules[name.partition(".")[0]]
    with private.in_place():
        return _real_import(name, globals, locals, fromlist, level)


def import_module(name: str, package: str | None = None) -> ModuleType:
    top = (package or "") if name.startswith(".") else name
    private = _private_of_caller(top.partition(".")[0])
    if private is None:
        return _real_import_module(name, package)
    with private.in_place():
        return _real_import_module(name, package)


def own_path(_nothing: object = None) -> Callable[[], None]:
    """Store sys.path; return the function that restores it, without folders of processes but with others' additions."""
    path, before = sys.path, list(sys.path)

    def undo() -> None:
        with _path_lock:
            others = [folder for folder in sys.path if folder not in _added and folder not in before]
            path[:] = [*others, *(folder for folder in before if folder in sys.path)]
            sys.path = path
            _added.clear()

    return undo
