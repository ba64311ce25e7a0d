"""Marking on Windows and macOS: all of it runs in a Linux container, and each submission in a sandbox there.

What keeps a student's program in is bubblewrap, as on Linux. The container gives it the system that it needs, has no
network, and sees of this computer only what was handed in, the teacher's lists and the folder of the results.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from coursekit.systems import which

from .container_image import Image
from .time_zone import posix_zone

ENGINES = ("podman", "docker")
"""The programs that run containers, in the order in which they are looked for."""
_OPEN_PROC = {"podman": "unmask=ALL", "docker": "systempaths=unconfined"}
"""bubblewrap shows each sandbox a /proc of its own, which a system allows that hides nothing of the outer one."""
_SECURITY = ("seccomp=unconfined", "apparmor=unconfined", "label=disable")
"""Likewise the calls with which it makes its walls, and files of this computer whatever their SELinux label."""
_FILES = ("folder", "notebooks", "roster", "variants", "policy")
"""Words of `coursekit grade` that name something to be read."""
_FLAGS = ("anonymous",)
_VALUES = ("jobs", "count", "csv", "platform")
_LISTS = ("chapters", "again")


class NoContainer(Exception):
    """Why nothing was marked, in words for the teacher."""


def is_needed() -> bool:
    """Whether this system has nothing of its own that keeps a program in."""
    return which.WINDOWS or which.MAC


def engine() -> str:
    """The first program for containers that works; empty when none does."""
    for name in ENGINES:
        path = shutil.which(name)
        if path and subprocess.run([path, "info"], capture_output=True, stdin=subprocess.DEVNULL).returncode == 0:
            return path
    return ""


@dataclass
class Marking:
    """One call of `coursekit grade` in a container."""

    program: str
    """podman or docker."""
    args: argparse.Namespace
    mounts: dict[str, Path] = field(default_factory=dict)
    """The names of this computer's folders inside, and the folders."""

    def run(self, image: Image) -> int:
        """Mark; the exit code is the grader's own."""
        self._refuse_what_needs_a_browser()
        image.make(self.program)
        return subprocess.call(self.command(image.tag))

    def command(self, tag: str) -> list[str]:
        """The whole command line."""
        words = list(self._words())
        return [self.program, "run", "--rm", "--init", *self._walls(), *self._mounted(), tag, "grade", *words]

    def _walls(self) -> Iterator[str]:
        yield from ("--network", "none", "--cap-drop", "ALL", "--read-only", "--tmpfs", "/tmp:exec")
        yield from ("--workdir", "/tmp", "--env", "HOME=/tmp")
        due = self.args.due
        yield from ("--env", f"TZ={posix_zone(time.time() if due is None else due.timestamp())}")
        for option in (*_SECURITY, _OPEN_PROC[self.kind]):
            yield from ("--security-opt", option)

    @cached_property
    def kind(self) -> str:
        """By what name the program is known, whatever its path and ending."""
        return Path(self.program.replace("\\", "/")).stem.lower()

    def _words(self) -> Iterator[str]:
        """The words of `coursekit grade` with paths as they are inside; it is root there, without any right of one."""
        for name in _FILES:
            given = getattr(self.args, name)
            if given is not None:
                yield from ([] if name == "folder" else [f"--{name}"])
                yield self._inside(given.resolve(), name)
        out = self.args.out.resolve()
        self._mount(out.parent, "/out")
        yield from ("--out", f"/out/{out.name}", "--allow-root")
        yield from (f"--{name}" for name in _FLAGS if getattr(self.args, name))
        for name in _VALUES:
            if getattr(self.args, name) is not None:
                yield from (f"--{'for' if name == 'platform' else name}", str(getattr(self.args, name)))
        if self.args.due is not None:
            yield from ("--due", self.args.due.astimezone().isoformat())
        for name in _LISTS:
            if getattr(self.args, name) is not None:
                yield from (f"--{name}", *getattr(self.args, name))

    def _inside(self, path: Path, name: str) -> str:
        """The name of a file or folder inside; beside a list of names lies the secret of its copies."""
        if path.is_dir():
            self._mount(path, f"/in/{name}")
            return f"/in/{name}"
        self._mount(path.parent, f"/in/{name}")
        return f"/in/{name}/{path.name}"

    def _mount(self, folder: Path, target: str) -> None:
        if any(sign in str(folder) for sign in ',"\n'):
            raise NoContainer(f"'{folder}' has a comma or quote in its name, which {self.kind} cannot be given. Rename it.")
        if not folder.is_dir():
            raise NoContainer(f"There is no folder '{folder}'.")
        self.mounts[target] = folder

    def _mounted(self) -> Iterator[str]:
        for target, folder in self.mounts.items():
            readonly = "" if target == "/out" else ",readonly"
            yield from ("--mount", f"type=bind,source={folder},target={target}{readonly}")

    def _refuse_what_needs_a_browser(self) -> None:
        if self.args.review:
            raise NoContainer(
                "--review opens a page in your browser, and the container in which work is marked here has no network. "
                "Mark without it, and write points into the table."
            )


def refusal(unsafe: bool) -> str:
    """Why nothing is marked here without a container, and which ways there are; empty when that may be."""
    if unsafe and not which.WINDOWS:
        return ""
    return (
        "Submissions are programs of other people, and this computer has nothing that keeps them in: start Docker Desktop "
        "or Podman, and run this again; or mark on Linux (also WSL 2 is one), where `sudo apt install bubblewrap` is enough."
    )


def mark(args: argparse.Namespace, otherwise: str) -> int:
    """Mark in a container, where this computer has one; else SystemExit says what is said `otherwise`."""
    program = engine()
    if not program:
        raise SystemExit(otherwise)
    try:
        return Marking(program, args).run(Image.of_this_course())
    except NoContainer as error:
        raise SystemExit(str(error)) from None


__all__ = ["ENGINES", "Marking", "NoContainer", "engine", "is_needed", "mark", "refusal"]
