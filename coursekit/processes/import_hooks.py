"""Import hooks: some libraries are patched for a session (OpenCV has no windows there), missing packages are explained."""

from __future__ import annotations

import importlib
import importlib.abc
import importlib.machinery
import sys
from collections.abc import Callable, Mapping, Sequence
from types import ModuleType
from typing import Any

from coursekit.wiring import IMPORT_HOOKS

from .patching import is_imported, patch_manager
from .unavailable_packages import remark

_loading: set[str] = set()
"""Modules that are being loaded: cv2 imports its library under its own name, and is helped once it is whole."""


_WITH_OLDER_NAMES = ("numpy", "cv2", "scipy", "matplotlib.pyplot")
"""Modules whose helpers add names that a script may say above its first node."""


class _Loader(importlib.abc.Loader):
    """Loads a module with the real loader, then calls the helper."""

    def __init__(self, real: Any, helper: str) -> None:
        self._real = real
        self._helper = helper

    def __getattr__(self, name: str) -> Any:
        return getattr(self._real, name)

    def create_module(self, spec: importlib.machinery.ModuleSpec) -> ModuleType | None:
        return self._real.create_module(spec)

    def exec_module(self, module: ModuleType) -> None:
        _loading.add(module.__name__)
        try:
            self._real.exec_module(module)
        finally:
            _loading.discard(module.__name__)
        _help(self._helper)


class _Finder(importlib.abc.MetaPathFinder):
    """Detects imports of the modules in IMPORT_HOOKS and of the helpers; the other finders find them."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        helper = IMPORT_HOOKS.get(fullname, fullname)
        if helper not in IMPORT_HOOKS.values() or fullname in _loading:
            return None
        for finder in sys.meta_path:
            spec = None if finder is self else finder.find_spec(fullname, path, target)
            if spec is not None and spec.loader is not None:
                spec.loader = _Loader(spec.loader, helper)
                return spec
        return None


class _Elsewhere(importlib.abc.MetaPathFinder):
    """The last finder: it explains the absence of ROS packages that no other finder has found."""

    def find_spec(self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None) -> None:
        why = "" if path is not None else remark(fullname)
        if why:
            raise ModuleNotFoundError(f"No module named '{fullname}': {why}", name=fullname)


_finder = _Finder()
_elsewhere = _Elsewhere()


def is_loaded(module: str) -> bool:
    """Whether a module is in `sys.modules` and whole: also one that has just been loaded, whose importer waits for help."""
    return module in sys.modules and module not in _loading


def _help(helper: str) -> None:
    install = getattr(importlib.import_module(helper), "install", None)
    if install is not None:  # else the helper is being imported, and helps afterwards
        install()


def watch_imports(_nothing: object = None) -> Callable[[], None]:
    """Patch libraries when they are imported; return the function that ends this."""
    sys.meta_path.insert(0, _finder)
    return lambda: _remove(_finder)


def lend_to_imported() -> None:
    """Patch libraries that have been imported already; harmless when that is done."""
    _help_imported(IMPORT_HOOKS)


def lend_older_names() -> None:
    """Give libraries the names of Humble's versions: what says them above its first node has no session yet."""
    patch_manager.put_at_once("sys.meta_path (first)")
    _help_imported({name: IMPORT_HOOKS[name] for name in _WITH_OLDER_NAMES})


def _help_imported(hooks: Mapping[str, str]) -> None:
    for name, helper in hooks.items():
        if is_imported(name):
            _help(helper)


def tell_elsewhere(_nothing: object = None) -> Callable[[], None]:
    """Explain missing ROS packages; return the function that ends this."""
    sys.meta_path.append(_elsewhere)
    return lambda: _remove(_elsewhere)


def _remove(finder: Any) -> None:
    if finder in sys.meta_path:
        sys.meta_path.remove(finder)
