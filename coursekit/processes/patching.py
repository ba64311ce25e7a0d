"""How something of Python or of a library is replaced while sessions are open, and put back after the last one.

All replacements are in the table of `coursekit.processes.patches`; no other module assigns to what is not its own.
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
"""The attribute of `sys` that has the manager while anything is patched."""
GROUPS = (IMPORTS, PROCESSES, VIRTUAL, PRIVATE)
"""While what a patch is in place: any session; one with processes; a virtual clock; processes with modules of their own.

Those of KERNEL mend a notebook's kernel for as long as it runs; the patch_manager does not look after them.
"""


@dataclass(eq=False)
class Patch:
    """One name of Python's or of a library's, and its replacement while sessions are open.

    >>> import string
    >>> patch = Patch("string.digits", lambda real: real[::-1], "an example", "tests/processes/test_patches.py")
    >>> patch.put(); string.digits
    '9876543210'
    >>> patch.take_back(); string.digits
    '0123456789'
    """

    target: str
    make: Callable[[Any], Any]
    """Gives the replacement, made from the original."""
    reason: str
    test: str
    """The test file that shows what it is for."""
    group: str = PROCESSES
    versions: str = "3.10 to 3.14"
    only_on: str = ""
    """The value of sys.platform without which there is no such name."""
    bare: Callable[[Any], Any] = field(default=lambda value: value, repr=False)
    """A value without a replacement around it that came back in the meantime."""
    _owner: Any = field(default=_MISSING, init=False, repr=False)
    _found: Any = field(default=_MISSING, init=False, repr=False)
    _ours: Any = field(default=_MISSING, init=False, repr=False)

    def put(self) -> None:
        """Replace; harmless when it is replaced, or when this system does not have the name."""
        owner, name = self._place()
        present = vars(owner).get(name, _MISSING) if owner is not None else _MISSING
        if present is _MISSING or present is self._ours:
            return
        self._found = self.bare(present)
        self._ours = self.make(self._found)
        setattr(owner, name, self._ours)

    def put_once(self) -> None:
        """Replace, unless that was done: what somebody else has put there since stays."""
        if self._ours is _MISSING:
            self.put()

    def take_back(self) -> None:
        """Put back what was found; what somebody else has put there since stays."""
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
                with contextlib.suppress(ImportError, AttributeError):  # another system's module
                    self._owner = pkgutil.resolve_name(path)
        return self._owner, name


@dataclass(eq=False)
class Change(Patch):
    """A change that is no assignment to a name: `make` does it, and returns what undoes it."""

    def put(self) -> None:
        """Do it; harmless when it is done."""
        if self._ours is _MISSING:
            self._ours = self.make(None)

    def take_back(self) -> None:
        """Undo it."""
        undo, self._ours = self._ours, _MISSING
        if undo is not _MISSING:
            undo()


def always(replacement: Any) -> Callable[[Any], Any]:
    """A `make` for a replacement that does not depend on what it replaces."""
    return lambda _found: replacement


class PatchManager:
    """Which patches are in place, and for which sessions."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._wanted: dict[str, list[Any]] = {group: [] for group in GROUPS}
        self._own: list[Patch] = []
        self._lent: list[Patch] = []
        self.on_open: list[Callable[[], None]] = []
        """Called when a session wants patches for the first time."""

    def register(self, *patches: Patch) -> None:
        """Add the patches that sessions always want."""
        self._own += patches

    def table(self) -> list[Patch]:
        """All patches: those that are registered, and those lent for libraries that have been imported."""
        return [*self._own, *self._lent]

    def enter(self, session: Any, *groups: str) -> None:
        """Put the patches of `groups` in place until `session` closes; also those that somebody has overwritten."""
        with self._lock:
            self._replace_a_forgotten_one()
            is_new = session not in self._wanted[IMPORTS]
            for group in groups:
                if session not in self._wanted[group]:
                    self._wanted[group].append(session)
            self.renew()
        if is_new:
            for listener in self.on_open:  # outside of the lock: it imports, and who imports a library may wait to lend
                listener()

    def _replace_a_forgotten_one(self) -> None:
        """Take back what an earlier copy of this module has patched: pytest's pytester forgets modules after each test."""
        earlier = vars(sys).get(HELD)
        if earlier is not None and earlier is not self:
            earlier.leave_all()
        vars(sys)[HELD] = self

    def leave_all(self) -> None:
        """Take back everything, whoever wants it."""
        with self._lock:
            for session in {id(one): one for group in self._wanted.values() for one in group}.values():
                self.leave(session)

    def renew(self) -> None:
        """Put in place again what is wanted, and has been overwritten: pytest gives each test streams of its own.

        What a program has put into a library stays: it may have a camera of its own.
        """
        with self._lock:
            for patch in self.table():
                if self._wanted[patch.group]:
                    patch.put_once() if patch in self._lent else patch.put()

    def put_at_once(self, target: str) -> None:
        """Put one patch in place before any session wants it; it goes when the last session does."""
        with self._lock:
            for patch in self.table():
                if patch.target == target:
                    patch.put()

    def leave(self, session: Any) -> None:
        """Take back what no other session wants: after the last one Python is as it was found."""
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

    def lend(self, *patches: Patch) -> None:
        """Add the patches of a library that has been imported; harmless when they are there."""
        with self._lock:
            known = {patch.target for patch in self._lent}
            self._lent += [patch for patch in patches if patch.target not in known]
            for patch in self._lent:
                if self._wanted[patch.group]:
                    patch.put_once()

    def is_open(self) -> bool:
        """Whether any session wants patches."""
        return any(self._wanted.values())


patch_manager = PatchManager()


def is_imported(module: str) -> bool:
    """Whether a module has been imported whole."""
    spec = getattr(sys.modules.get(module), "__spec__", None)
    return spec is not None and not getattr(spec, "_initializing", False)
