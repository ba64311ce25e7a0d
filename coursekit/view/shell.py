"""The IPython shell this process runs in."""

from __future__ import annotations

import sys
from typing import Any


def running_shell() -> Any:
    """The IPython shell, None outside of one; IPython is not imported for the question."""
    ipython = sys.modules.get("IPython")
    return ipython.get_ipython() if ipython is not None else None


__all__ = ["running_shell"]
