"""Tests of launched systems: a launch description as in a launch file, with tests during the launch and after it.

Every run of pytest imports this package to find its plugin. Modules that need `launch` are therefore imported on use.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from .decorator import post_shutdown_test
from .parametrize import parametrize

if TYPE_CHECKING:
    from . import actions, asserts, event_handlers, legacy, markers, tools, util
    from .io_handler import ActiveIoHandler, IoHandler
    from .proc_info_handler import ActiveProcInfoHandler, ProcInfoHandler
    from .ready_aggregator import ReadyAggregator

_MODULES = ("actions", "asserts", "event_handlers", "legacy", "markers", "tools", "util")
_CLASSES = {
    "ActiveIoHandler": "io_handler",
    "ActiveProcInfoHandler": "proc_info_handler",
    "IoHandler": "io_handler",
    "ProcInfoHandler": "proc_info_handler",
    "ReadyAggregator": "ready_aggregator",
}


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return importlib.import_module(f"{__name__}.{name}")
    if name in _CLASSES:
        return getattr(importlib.import_module(f"{__name__}.{_CLASSES[name]}"), name)
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")


__all__ = [
    "ActiveIoHandler",
    "ActiveProcInfoHandler",
    "IoHandler",
    "ProcInfoHandler",
    "ReadyAggregator",
    "actions",
    "asserts",
    "event_handlers",
    "legacy",
    "markers",
    "parametrize",
    "post_shutdown_test",
    "tools",
    "util",
]
