"""The outcome of a task."""

from enum import Enum


class TaskResult(Enum):
    """The result of `BasicNavigator.getResult`."""

    UNKNOWN = 0
    SUCCEEDED = 1
    CANCELED = 2
    FAILED = 3
