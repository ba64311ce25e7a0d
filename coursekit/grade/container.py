"""Marking on Windows and macOS: it runs in a Linux container, with each submission in a sandbox inside.

As on Linux, bubblewrap confines a student's program. The container provides the required system. It has no network,
and sees of this computer only the submissions, the teacher's lists and the folder of the results.
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

from coursekit.systems import operating_system

from .container_image import Image
from .time_zone import posix_zone

ENGINES = ("podman", "docker")
"""Container programs, in order of preference."""
_OPEN_PROC = {"podman": "unmask=ALL", "docker": "systempaths=unconfined"}
"""bubblewrap gives each sandbox its own /proc, which is only allowed if the outer one hides nothing."""
_SECURITY = ("seccomp=unconfined", "apparmor=unconfined", "label=disable")
"""Permit the system calls of bubblewrap, and access to this computer's files regardless of SELinux labels."""
_FILES = ("folder", "notebooks", "roster", "variants", "policy")
"""Arguments of `coursekit grade` that name input files."""
_FLAGS = ("anonymous",)
_VALUES = ("jobs", "count", "csv", "platform")
_LISTS = ("chapters", "again")


class NoContainer(Exception):
    """Why nothing was marked, as a message for the teacher."""


def is_needed() -> bool:
    """Whether this system lacks its own means to confine a program."""
    return operating_system.WINDOWS or operating_system.MAC


def engine() -> str:
    """Return the first working container program; empty when none works."""
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
    """This computer's folders by their names inside the container."""

    def run(self, image: Image) -> int:
        """Run the marking. Returns the grader's exit code."""
        self._refuse_what_needs_a_browser()
        image.make(self.program)
        return subprocess.call(self.command(image.tag))

    def command(self, tag: str) -> list[str]:
        """Return the whole command line."""
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
        """Return the program's name without path and suffix."""
        return Path(self.program.replace("\\", "/")).stem.lower()

    def _words(self) -> Iterator[str]:
        """Yield the arguments of `coursekit grade` with inside paths; it is root there, without any capability."""
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
        """Return the inside name of a file or folder; a roster is mounted with its folder, which has its copies' secret."""
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
    """Return why nothing is marked here without a container, and the alternatives; empty if marking is allowed."""
    if unsafe and not operating_system.WINDOWS:
        return ""
    return (
        "Submissions are programs of other people, and this computer has nothing that keeps them in: start Docker Desktop "
        "or Podman, and run this again; or mark on Linux (also WSL 2 is one), where `sudo apt install bubblewrap` is enough."
    )


def mark(args: argparse.Namespace, otherwise: str) -> int:
    """Mark in a container if this computer can run one; otherwise raise SystemExit with the message `otherwise`."""
    program = engine()
    if not program:
        raise SystemExit(otherwise)
    try:
        return Marking(program, args).run(Image.of_this_course())
    except NoContainer as error:
        raise SystemExit(str(error)) from None


__all__ = ["ENGINES", "Marking", "NoContainer", "engine", "is_needed", "mark", "refusal"]
