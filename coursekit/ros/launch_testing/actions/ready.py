"""An action that signals that the tests may begin."""

from __future__ import annotations

import logging
from collections.abc import Callable

from launch.action import Action
from launch.launch_context import LaunchContext

_logger = logging.getLogger(__name__)


class ReadyToTest(Action):
    """The tests begin when this action is executed."""

    def __init__(self) -> None:
        super().__init__()
        self._callbacks: list[Callable[[], object]] = []

    def _add_callback(self, callback: Callable[[], object]) -> None:
        self._callbacks.append(callback)

    def execute(self, context: LaunchContext) -> None:
        """Call all callbacks; an exception in one of them is logged and does not affect the others."""
        for callback in self._callbacks:
            try:
                callback()
            except Exception as error:
                _logger.error(error)
