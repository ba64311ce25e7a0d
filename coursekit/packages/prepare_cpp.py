"""Makes the tools for C++ ready, once: the first build that needs them waits for the runtime and says so."""

from __future__ import annotations

import asyncio
import os
import sys
import time

from coursekit.cpp.runtime import runtime_folder
from coursekit.cpp.toolchain import NoToolchain, Toolchain, find_toolchain

_preparing: dict[asyncio.AbstractEventLoop, asyncio.Lock] = {}


async def prepared_toolchain() -> Toolchain | None:
    """The tools with their runtime made; None where there are none, or where they cannot make it."""
    try:
        tools = find_toolchain()
    except NoToolchain:
        return None
    lock = _preparing.setdefault(asyncio.get_running_loop(), asyncio.Lock())
    async with lock:
        if not runtime_folder(tools).is_dir() and not await _prepare(tools):
            return None
    return tools


async def _prepare(tools: Toolchain) -> bool:
    print("Preparing C++, once, in less than a minute ...", flush=True)
    began = time.monotonic()
    env = {name: value for name, value in os.environ.items() if name != "AMENT_PREFIX_PATH"}
    command = [sys.executable, "-m", "coursekit.cpp.runtime", str(runtime_folder(tools))]
    child = await asyncio.create_subprocess_exec(*command, env=env, stderr=asyncio.subprocess.PIPE)
    _, errors = await child.communicate()
    if child.returncode:
        print(f"C++ cannot be prepared:\n{errors.decode(errors='replace')}", file=sys.stderr, flush=True)
        return False
    print(f"C++ is ready ({time.monotonic() - began:.0f} s).", flush=True)
    return True
