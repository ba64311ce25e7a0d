"""Tests of launched systems as functions of pytest.

`@launch_pytest.fixture` makes a fixture that launches the description that its function returns; a test with the mark
`@pytest.mark.launch(fixture=that_fixture)` runs during the launch, or with `shutdown=True` after its end.

Every run of pytest imports this package to find its plugin. Modules that need `launch` are therefore imported on use.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from .fixture import fixture

if TYPE_CHECKING:
    from . import actions, tools


def __getattr__(name: str) -> Any:
    if name in ("actions", "tools"):
        return importlib.import_module(f"{__name__}.{name}")
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")


__all__ = ["actions", "fixture", "tools"]
