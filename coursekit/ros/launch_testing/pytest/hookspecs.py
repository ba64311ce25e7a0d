"""The hook with which other plugins collect launch tests of their own kind."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest


@pytest.hookspec(firstresult=True)
def pytest_launch_collect_makemodule(module_path: Path, path: Path, parent: Any, entrypoint: Any) -> Any:
    """Return a collector for a file whose `generate_test_description` is `entrypoint`, or None."""
