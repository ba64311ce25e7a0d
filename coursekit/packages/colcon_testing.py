"""colcon's test step for Python packages that name pytest as ROS 2's packages do.

They say `tests_require=['pytest']` in setup.py, which setuptools has forgotten since its version 72: without this their
tests would be passed over in silence.
"""

from __future__ import annotations

import ast
from pathlib import Path
from typing import Any

from colcon_core.task.python.test.pytest import PytestPythonTestingStep


class TestsRequireStep(PytestPythonTestingStep):  # type: ignore[misc]
    """Runs pytest for these packages."""

    PRIORITY = 190  # after colcon's own, before unittest

    def add_arguments(self, *, parser: Any) -> None:
        """Add none: colcon's own step has added them."""

    def match(self, context: Any, env: Any, setup_py_data: Any) -> bool:
        """Return whether the package names pytest in `tests_require`."""
        setup = Path(context.args.path) / "setup.py"
        return setup.is_file() and requires_pytest(setup.read_text(encoding="utf-8"))


def requires_pytest(setup_py: str) -> bool:
    """Whether a setup.py calls `setup` with pytest among `tests_require`.

    >>> requires_pytest("setup(name='a', tests_require=['pytest'])"), requires_pytest("setup(name='a')")
    (True, False)
    """
    try:
        tree = ast.parse(setup_py)
    except SyntaxError:
        return False  # the build says so
    wanted = [word.value for word in ast.walk(tree) if isinstance(word, ast.keyword) and word.arg == "tests_require"]
    texts = [node.value for value in wanted for node in ast.walk(value) if isinstance(node, ast.Constant)]
    return any(str(text).startswith("pytest") for text in texts)
