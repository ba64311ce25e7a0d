"""Registers the pytest marks of new packages' tests."""

from __future__ import annotations

from typing import Any

_MARKS = ("copyright", "flake8", "linter", "mypy", "pep257", "xmllint")


def pytest_configure(config: Any) -> None:
    """Register the marks. In ROS 2 each ament linter registers its own."""
    for name in _MARKS:
        config.addinivalue_line("markers", f"{name}: marks tests that check the style of a package")
