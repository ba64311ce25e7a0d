"""Modules such as `std_msgs.msg`: their names become classes on first use."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from coursekit.interfaces.errors import suggestion
from coursekit.interfaces.find import UNDERLAY, interfaces_of, remember
from coursekit.interfaces.registry import _SUFFIX, load, register_module


def expose(module: str, file: str) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """Return `__getattr__`, `__dir__` and `__all__` for the module 'package.kind' whose source is `file`."""
    package, kind = module.rsplit(".", 1)
    prefix = _prefix_of(Path(file), package)
    if prefix is not None:
        remember(prefix)
    names = interfaces_of(package, kind)
    for name in names:
        register_module(package, kind, name)

    def __getattr__(name: str) -> Any:
        known = interfaces_of(package, kind)
        stem = name if kind == "msg" else _SUFFIX.sub("", name)
        if stem not in known:
            hint = suggestion(name, known)
            raise AttributeError(f"module '{module}' has no attribute '{name}'{hint}")
        value = load(f"{package}/{kind}/{name}")
        if prefix == UNDERLAY:  # a student's definition may change while the session runs
            setattr(sys.modules[module], name, value)
        return value

    def __dir__() -> list[str]:
        return [*names, "__all__", "__name__"]

    return __getattr__, __dir__, names


def _prefix_of(file: Path, package: str) -> Path | None:
    for parent in file.resolve().parents:
        if (parent / "share" / package / "package.xml").is_file():
            return parent
    return None
