"""Replacing parts of Python and of libraries while sessions are open, and restoring them after the last one.

All replacements are in the table of `coursekit.processes.patches`; no other module assigns to foreign names.
"""

from __future__ import annotations

import contextlib
import pkgutil
import sys
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

_MISSING: Any = object()
IMPORTS, PROCESSES, VIRTUAL, PRIVATE = "any session", "processes", "virtual clock", "private modules"
KERNEL = "kernel"
HELD = "_coursekit_patches"
"""The attribute of `sys` that holds the manager while anything is patched."""
GROUPS = (IMPORTS, PROCESSES, VIRTUAL, PRIVATE)
"""When a patch is active: in any session; in one with processes; on a virtual clock; for processes with private modules.

Patches of KERNEL fix a notebook's kernel for as long as it runs; the patch_manager does not manage them.
"""


@dataclass(eq=False)
class Patch:
    """One name in Python or a library, and its replacement while sessions are open.

    >>> import string
    >>> patch = Patch("string.digits", lambda real: real[::-1], "an example", "tests/processes/test_patches.py")
    >>> patch.put(); string.digits
    '9876543210'
    >>> patch.take_back(); string.digits
    '0123456789'
    """

    target: str
    make: Callable[[Any], Any]
    """Creates the replacement from the original."""
    reason: str
    test: str
    """The test file that demonstrates its purpose."""
    group: str = PROCESSES
    versions: str = "3.10 to 3.14"
    only_on: str = ""
    """The value of sys.platform to which the name is limited."""
    bare: Callable[[Any], Any] = field(default=lambda value: value, repr=False)
    """Unwraps a value that was wrapped in a replacement in the meantime."""
    _owner: Any = field(default=_MISSING, init=False, repr=False)
    _found: Any = field(default=_MISSING, init=False, repr=False)
    _ours: Any = field(default=_MISSING, init=False, repr=False)

    def put(self) -> None:
        """Replace; harmless when it is already replaced, or when this system lacks the name."""
        owner, name = self._place()
        present = vars(owner).get(name, _MISSING) if owner is not None else _MISSING
        if present is _MISSING or present is self._ours:
            return
        self._found = self.bare(present)
        self._ours = self.make(self._found)
        setattr(owner, name, self._ours)

    def put_once(self) -> None:
        """Replace once: a later assignment by other code is kept."""
        if self._ours is _MISSING:
            self.put()

    def take_back(self) -> None:
        """Restore the original; a later assignment by other code is kept."""
        if self._ours is _MISSING:
            return
        owner, name = self._place()
        present = vars(owner).get(name, _MISSING)
        if present is self._ours:
            setattr(owner, name, self._found)
        elif present is not _MISSING and self.bare(present) is not present:
            setattr(owner, name, self.bare(present))
        self._found = self._ours = _MISSING

    def _place(self) -> tuple[Any, str]:
        path, _, name = self.target.rpartition(".")
        if self._owner is _MISSING:
            self._owner = None
            if self.only_on in ("", sys.platform):
                with contextlib.suppress(ImportError, AttributeError):  # a module of another system
                    self._owner = pkgutil.resolve_name(path)
        return self._owner, name


@dataclass(eq=False)
class Change(Patch):
    """A change other than an assignment to a name: `make` applies it, and returns the function that undoes it."""

    def put(self) -> None:
        """Apply it; harmless when it is already applied."""
        if self._ours is _MISSING:
            self._ours = self.make(None)

    def take_back(self) -> None:
        """Undo it."""
        undo, self._ours = self._ours, _MISSING
        if undo is not _MISSING:
            undo()


def always(replacement: Any) -> Callable[[Any], Any]:
    """Return a `make` for a replacement that does not depend on the original."""
    return lambda _found: replacement


class PatchManager:
    """The active patches, and the sessions that need them."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._wanted: dict[str, list[Any]] = {group: [] for group in GROUPS}
        self._own: list[Patch] = []
        self._lent: list[Patch] = []
        self.on_open: list[Callable[[], None]] = []
        """Called when a session needs patches for the first time."""

    def register(self, *patches: Patch) -> None:
        """Add patches that sessions always need."""
        self._own += patches

    def table(self) -> list[Patch]:
        """Return all patches: the registered ones, and those added for imported libraries."""
        return [*self._own, *self._lent]

    def enter(self, session: Any, *groups: str) -> None:
        """Activate the patches of `groups` until `session` closes, including overwritten ones."""
        with self._lock:
            self._replace_a_forgotten_one()
            is_new = session not in self._wanted[IMPORTS]
            for group in groups:
                if session not in self._wanted[group]:
                    self._wanted[group].append(session)
            self.renew()
        if is_new:
            for listener in self.on_open:  # outside of the lock: it imports, and an importing thread may wait in `lend`
                listener()

    def _replace_a_forgotten_one(self) -> None:
        """Undo the patches of an earlier copy of this module: pytest's pytester forgets modules after each test."""
        earlier = vars(sys).get(HELD)
        if earlier is not None and earlier is not self:
            earlier.leave_all()
        vars(sys)[HELD] = self

    def leave_all(self) -> None:
        """Undo everything, for all sessions."""
        with self._lock:
            for session in {id(session): session for group in self._wanted.values() for session in group}.values():
                self.leave(session)

    def renew(self) -> None:
        """Apply overwritten patches again: pytest gives each test its own streams.

        Values that a program has put into a library are kept: it may have its own camera.
        """
        with self._lock:
            for patch in self.table():
                if self._wanted[patch.group]:
                    patch.put_once() if patch in self._lent else patch.put()

    def put_at_once(self, target: str) -> None:
        """Apply one patch before any session needs it; it is undone with the last session."""
        with self._lock:
            for patch in self.table():
                if patch.target == target:
                    patch.put()

    def leave(self, session: Any) -> None:
        """Undo the patches that no other session needs: after the last one Python is in its original state."""
        with self._lock:
            for sessions in self._wanted.values():
                if session in sessions:
                    sessions.remove(session)
            for patch in reversed(self.table()):
                if not self._wanted[patch.group]:
                    patch.take_back()
            if not self._wanted[IMPORTS]:
                self._lent.clear()
            if not self.is_open() and vars(sys).get(HELD) is self:
                del vars(sys)[HELD]

    def lend(self, *patches: Patch, at_once: bool = False) -> None:
        """Add the patches of an imported library; harmless when they are already added.

        Those that only add names can be applied `at_once`, before any session: a script says them above its first node.
        """
        with self._lock:
            known = {patch.target for patch in self._lent}
            self._lent += [patch for patch in patches if patch.target not in known]
            for patch in self._lent:
                if self._wanted[patch.group] or (at_once and patch in patches):
                    patch.put_once()

    def is_open(self) -> bool:
        """Whether any session needs patches."""
        return any(self._wanted.values())


patch_manager = PatchManager()


def is_imported(module: str) -> bool:
    """Whether a module is completely imported."""
    spec = getattr(sys.modules.get(module), "__spec__", None)
    return spec is not None and not getattr(spec, "_initializing", False)
