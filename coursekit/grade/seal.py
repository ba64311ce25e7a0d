"""A seal on a trial: programs that are tried out share its interpreter, and may not change what watches them.

It notices functions of ours that were replaced, and searches through the interpreter's memory. It cannot stop a program that
goes through the stacks of other lanes; that is for the teacher's eye, as the code is handed in.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from types import FunctionType
from typing import Any

OURS = ("coursekit", "rclpy", "rosidl_runtime_py", "__main__")
_SEARCHES = frozenset({"gc.get_objects", "gc.get_referrers", "gc.get_referents", "sys._current_frames"})


class Seal:
    """Remembers our functions as they were when it was made.

    >>> import coursekit.core.names as names
    >>> seal, right = Seal(), names.expand
    >>> names.expand = lambda *_: "/forged"; seal.broken()
    'coursekit.core.names.expand was replaced'
    >>> names.expand = right; seal.broken()
    ''
    """

    def __init__(self) -> None:
        self._before = dict(_functions())
        self._searched: list[str] = []

    def watch_searches(self) -> None:
        """From now on until the process ends, searching its memory for objects raises, and breaks the seal."""
        searched = self._searched

        def hook(event: str, _args: Any) -> None:
            if event in _SEARCHES:
                searched.append(event)
                raise PermissionError(f"{event}() is not for programs of the course")

        sys.addaudithook(hook)

    def broken(self) -> str:
        """What was done to us, if anything."""
        if self._searched:
            return f"{self._searched[0]}() was called"
        now = dict(_functions())
        changed = [name for name, parts in self._before.items() if not _same(now.get(name), parts)]
        return f"{changed[0]} was replaced" if changed else ""


def hidden_seal() -> Callable[[], str]:
    """A seal of this process that no import finds, searches of the memory being watched too; ask it what was broken."""
    package, _, name = __name__.rpartition(".")
    vars(sys.modules[package]).pop(name, None)
    sys.modules.pop(__name__, None)
    seal = Seal()
    seal.watch_searches()
    return seal.broken


def _same(now: tuple[Any, ...] | None, before: tuple[Any, ...]) -> bool:
    return now is not None and all(one is other for one, other in zip(now, before, strict=True))


def _functions() -> Iterator[tuple[str, tuple[Any, ...]]]:
    for name, module in list(sys.modules.items()):
        if name.partition(".")[0] in OURS:
            yield from _of(name, vars(module))


def _of(place: str, names: Any) -> Iterator[tuple[str, tuple[Any, ...]]]:
    for name, value in list(names.items()):
        inner = getattr(value, "__func__", value) if isinstance(value, (staticmethod, classmethod)) else value
        if isinstance(inner, FunctionType):
            yield f"{place}.{name}", (inner, inner.__code__)
        elif isinstance(value, property):
            yield f"{place}.{name}", (value, value.fget)
        elif isinstance(value, type) and value.__module__ == place:
            yield f"{place}.{name}", (value, None)
            yield from _of(f"{place}.{name}", vars(value))
