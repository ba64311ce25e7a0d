"""At an import: some libraries need a hand in a session (OpenCV has no windows there), some are said to be elsewhere."""

from __future__ import annotations

import importlib
import importlib.abc
import importlib.machinery
import sys
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any

from coursekit.wiring import IMPORT_HOOKS

from .patching import is_imported
from .unavailable_packages import remark


class _Loader(importlib.abc.Loader):
    """Loads as the real loader does, then calls the helper."""

    def __init__(self, real: Any, helper: str) -> None:
        self._real = real
        self._helper = helper

    def __getattr__(self, name: str) -> Any:
        return getattr(self._real, name)

    def create_module(self, spec: importlib.machinery.ModuleSpec) -> ModuleType | None:
        return self._real.create_module(spec)

    def exec_module(self, module: ModuleType) -> None:
        self._real.exec_module(module)
        _help(self._helper)


class _Finder(importlib.abc.MetaPathFinder):
    """Looks out for the modules of IMPORT_HOOKS and for the helpers; finding them is left to the others."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        helper = IMPORT_HOOKS.get(fullname, fullname)
        if helper not in IMPORT_HOOKS.values():
            return None
        for finder in sys.meta_path:
            spec = None if finder is self else finder.find_spec(fullname, path, target)
            if spec is not None and spec.loader is not None:
                spec.loader = _Loader(spec.loader, helper)
                return spec
        return None


class _Elsewhere(importlib.abc.MetaPathFinder):
    """Comes last: a ROS package that no one has found, and that coursekit knows to be elsewhere, is told with the reason."""

    def find_spec(self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None) -> None:
        why = "" if path is not None else remark(fullname)
        if why:
            raise ModuleNotFoundError(f"No module named '{fullname}': {why}", name=fullname)


_finder = _Finder()
_elsewhere = _Elsewhere()


def _help(helper: str) -> None:
    install = getattr(importlib.import_module(helper), "install", None)
    if install is not None:  # else the helper is being imported, and helps when it has been
        install()


def watch_imports(_nothing: object = None) -> Callable[[], None]:
    """Lend a hand to what will be imported; returns what ends it."""
    sys.meta_path.insert(0, _finder)
    return lambda: _remove(_finder)


def lend_to_imported() -> None:
    """Lend a hand to what has been imported already; harmless when that is done."""
    for name, helper in IMPORT_HOOKS.items():
        if is_imported(name):
            _help(helper)


def tell_elsewhere(_nothing: object = None) -> Callable[[], None]:
    """Tell of packages that are elsewhere; returns what ends it."""
    sys.meta_path.append(_elsewhere)
    return lambda: _remove(_elsewhere)


def _remove(finder: Any) -> None:
    if finder in sys.meta_path:
        sys.meta_path.remove(finder)
