"""Kernels of two notebooks, as two students' or one student's with two chapters open."""

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from jupyter_client.manager import start_new_kernel

Kernel = tuple[Any, Any]
"""A kernel's manager and client."""


def surround(monkeypatch: pytest.MonkeyPatch, folder: Path, domain: int) -> None:
    """Have kernels that start from here on know nothing of this run's course and sessions."""
    for name in [variable for variable in os.environ if variable.startswith("COURSEKIT_")]:
        monkeypatch.delenv(name)
    monkeypatch.setenv("COURSEKIT_RUNTIME_DIR", str(folder))
    monkeypatch.setenv("COURSEKIT_COURSE", str(folder))
    monkeypatch.setenv("ROS_DOMAIN_ID", str(domain))


@contextmanager
def two_kernels(prepare: Callable[[str], None], start: str) -> Iterator[list[Kernel]]:
    """One and two: `prepare(name)` comes before each, and each runs `start` with its `{name}`."""
    opened: list[Kernel] = []
    try:
        for name in ("one", "two"):
            prepare(name)
            opened.append(start_new_kernel(kernel_name="python3", startup_timeout=60))
            run(opened[-1][1], start.format(name=name))
        yield opened
    finally:
        for manager, client in opened:
            client.stop_channels()
            manager.shutdown_kernel(now=True)


def run(client: Any, code: str, timeout: float = 60) -> str:
    """Run code, which has to succeed; what it prints."""
    said: list[str] = []

    def keep(message: dict[str, Any]) -> None:
        if message["msg_type"] == "stream":
            said.append(message["content"]["text"])

    reply = client.execute_interactive(code, output_hook=keep, timeout=timeout)
    assert reply["content"]["status"] == "ok", reply["content"]
    return "".join(said)
