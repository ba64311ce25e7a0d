"""Prepares the C++ tools, once: the first build that needs them waits for the runtime and prints a message."""

from __future__ import annotations

import asyncio
import os
import sys
import time
from pathlib import Path

from coursekit.cpp.runtime import runtime_folder
from coursekit.cpp.toolchain import NoToolchain, Toolchain, find_toolchain
from coursekit.cpp.unused_runtimes import mark_used

_locks: dict[asyncio.AbstractEventLoop, asyncio.Lock] = {}
_failed: set[Path] = set()
_FAILED = "C++ could not be prepared, for the reason above"


async def prepared_toolchain() -> Toolchain:
    """Return the tools with their runtime built; NoToolchain if there are none, or if the runtime cannot be built."""
    if "COURSEKIT_GRADING" in os.environ:  # no points are given for C++, and it would take a minute of a copy's time
        raise NoToolchain("C++ is not compiled while a copy is marked")
    tools = find_toolchain()
    async with _locks.setdefault(asyncio.get_running_loop(), asyncio.Lock()):
        if runtime_folder(tools) in _failed:  # another package has reported it
            raise NoToolchain(_FAILED)
        if not runtime_folder(tools).is_dir():
            await _prepare(tools)
        mark_used(runtime_folder(tools))
    return tools


async def _prepare(tools: Toolchain) -> None:
    print("Preparing C++, once: about a minute with the system's compiler, three with coursekit[cpp]'s ...", flush=True)
    began = time.monotonic()
    env = {name: value for name, value in os.environ.items() if name != "AMENT_PREFIX_PATH"}
    command = [sys.executable, "-m", "coursekit.cpp.runtime", str(runtime_folder(tools))]
    child = await asyncio.create_subprocess_exec(*command, env=env, stderr=asyncio.subprocess.PIPE)
    _, errors = await child.communicate()
    if child.returncode:
        print(errors.decode(errors="replace"), file=sys.stderr, flush=True)
        _failed.add(runtime_folder(tools))
        raise NoToolchain(_FAILED)
    print(f"C++ is ready ({time.monotonic() - began:.0f} s).", flush=True)
