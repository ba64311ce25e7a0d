"""`coursekit cpp`: get a C++ compiler if the system has none, and prepare the runtime for C++ nodes."""

from __future__ import annotations

import argparse
import contextlib
import importlib
import os
import subprocess
import sys
import time
from collections.abc import Mapping
from importlib.metadata import requires
from typing import Any

from coursekit.cpp.runtime import runtime_folder
from coursekit.cpp.toolchain import NoToolchain, Toolchain, find_toolchain
from coursekit.cpp.unused_runtimes import mark_used
from coursekit.systems.children import apart

OFFER = (
    "Nodes in C++ can be compiled too: type `coursekit cpp` in a terminal (130 MB to download, 500 MB on disk, "
    "four minutes, once). The course can be taken without."
)
_GETTING = "There is no C++ compiler here: getting one from PyPI (130 MB to download, 500 MB on disk)."
_NOT_GOT = "It could not be got, for the reason above: are you online, and is there room on the disk?"
_FAILED = "C++ could not be prepared, for the reason above."
_STEP_S = 0.5


def add_commands(commands: Any) -> None:
    """Add the command to `coursekit`."""
    parser = commands.add_parser("cpp", help="prepare what compiles nodes in C++")
    parser.set_defaults(main=run)


def run(_args: argparse.Namespace) -> int:
    """Prepare C++; returns 1 if that is impossible here."""
    try:
        tools = find_toolchain()
    except NoToolchain:
        print(_GETTING, flush=True)
        if subprocess.call([sys.executable, "-m", "pip", "install", "--disable-pip-version-check", "-q", *wheels()]):
            print(_NOT_GOT, file=sys.stderr)
            return 1
        importlib.invalidate_caches()
        find_toolchain.cache_clear()
        tools = find_toolchain()
    return make_ready(tools)


def wheels() -> list[str]:
    """Return the packages that `pip install "coursekit[cpp]"` would install in addition to coursekit."""
    words = [line.partition(";") for line in requires("coursekit") or []]
    return [name.strip() for name, _, marker in words if "extra ==" in marker and "cpp" in marker]


def make_ready(tools: Toolchain) -> int:
    """Build the runtime for these tools if it is missing, with a progress line."""
    folder = runtime_folder(tools)
    began = time.monotonic()
    if not folder.is_dir():
        command = [sys.executable, "-m", "coursekit.cpp.runtime", str(folder)]
        child = subprocess.Popen(command, env=_alone(os.environ), stderr=subprocess.PIPE)
        errors = _watch(child, began)
        if child.returncode:
            print(f"{errors.decode(errors='replace')}\n{_FAILED}", file=sys.stderr)
            return 1
    print(f"C++ is ready ({time.monotonic() - began:.0f} s): {' '.join(tools.cxx)}, {tools.cmake}, {tools.generator}")
    return 0


def _watch(child: subprocess.Popen[bytes], began: float) -> bytes:
    """Wait for the child. Returns its standard error."""
    while True:
        try:
            return child.communicate(timeout=_STEP_S)[1]
        except subprocess.TimeoutExpired:
            if sys.stdout.isatty():
                print(
                    f"\rPreparing C++, once: {time.monotonic() - began:.0f} s of up to three minutes ...",
                    end="\r",
                    flush=True,
                )


def _alone(env: Mapping[str, str]) -> dict[str, str]:
    return {name: value for name, value in env.items() if name != "AMENT_PREFIX_PATH"}


def offer(env: Mapping[str, str]) -> None:
    """At the start of the lab, prepare C++ in the background if there is a compiler, else print how to get one."""
    try:
        folder = runtime_folder(find_toolchain())
    except NoToolchain:
        print(OFFER)
        return
    mark_used(folder)
    if not folder.is_dir():
        nothing = subprocess.DEVNULL
        command = [sys.executable, "-m", "coursekit.cpp.runtime", str(folder)]
        with contextlib.suppress(OSError):
            subprocess.Popen(command, env=_alone(env), stdin=nothing, stdout=nothing, stderr=nothing, **apart())
