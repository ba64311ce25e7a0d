"""The terminals of this notebook by their names: what `terminal(name)` finds."""

from __future__ import annotations

from typing import Any

KNOWN: dict[str, Any] = {}
"""The newest `Terminal` of each name."""


def failed() -> list[Any]:
    """Those whose programs ended with an error of their own, not by a signal."""
    return [shown for shown in KNOWN.values() if (shown.process.exit_code or 0) > 0]


__all__ = ["KNOWN", "failed"]
