"""Collecting for pytest: tests with the mark `rostest`."""

from __future__ import annotations

from typing import Any

from launch_testing.pytest.hooks import LaunchTestItem, LaunchTestModule


class LaunchROSTestItem(LaunchTestItem):
    """The launches and tests of one file."""

    @classmethod
    def from_parent(cls, parent: Any, **kwargs: Any) -> Any:
        """Create an item with the runner for nodes."""
        from ..test_runner import LaunchTestRunner

        return super().from_parent(parent, runner_cls=LaunchTestRunner, **kwargs)


class LaunchROSTestModule(LaunchTestModule):
    """A file with launch tests of nodes."""

    def makeitem(self, *args: Any, **kwargs: Any) -> Any:
        """Return the file's test."""
        return LaunchROSTestItem.from_parent(*args, **kwargs)
