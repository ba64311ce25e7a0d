"""Says that the tests may begin."""

from __future__ import annotations

import logging
from collections.abc import Callable

from launch.action import Action
from launch.launch_context import LaunchContext

_logger = logging.getLogger(__name__)


class ReadyToTest(Action):
    """When this action is carried out, the tests begin."""

    def __init__(self) -> None:
        super().__init__()
        self._callbacks: list[Callable[[], object]] = []

    def _add_callback(self, callback: Callable[[], object]) -> None:
        self._callbacks.append(callback)

    def execute(self, context: LaunchContext) -> None:
        """Tell everyone who waits; what one of them raises does not keep the others waiting."""
        for callback in self._callbacks:
            try:
                callback()
            except Exception as error:
                _logger.error(error)
