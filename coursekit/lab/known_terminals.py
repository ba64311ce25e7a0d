"""The terminals of this notebook by name, as found by `terminal(name)`."""

from __future__ import annotations

from typing import Any

KNOWN: dict[str, Any] = {}
"""The newest `Terminal` of each name."""


def failed() -> list[Any]:
    """Return the terminals whose programs ended with an error exit code by themselves: not by a signal, nor after Ctrl-C."""
    return [
        shown for shown in KNOWN.values() if (shown.process.exit_code or 0) > 0 and not shown.process.was_interrupted
    ]


__all__ = ["KNOWN", "failed"]
