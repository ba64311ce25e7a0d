"""Handlers that may use a separate format for each logger. In ROS 2: launch.logging.handlers.

Those of Python's `logging` and `logging.handlers` are here as well, such as `RotatingFileHandler`.
"""

from __future__ import annotations

import logging
import logging.handlers
import sys
from typing import Any


class Handler(logging.Handler):
    """A handler with a default formatter, and optional formatters for single loggers."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._formatters: dict[str, logging.Formatter] = {}

    def setFormatterFor(self, logger: logging.Logger | str, formatter: logging.Formatter) -> None:
        """Set the formatter for the messages of this logger, or the logger of this name."""
        self._formatters[_name(logger)] = formatter

    def unsetFormatterFor(self, logger: logging.Logger | str) -> None:
        """Use the default formatter for this logger's messages."""
        self._formatters.pop(_name(logger), None)

    def getFormatterFor(self, logger: logging.Logger | str) -> logging.Formatter | None:
        """Return the formatter of this logger."""
        return self._formatters.get(_name(logger), self.formatter)

    def format(self, record: logging.LogRecord) -> str:
        """Return the text of a record."""
        own = self._formatters.get(record.name)
        return super().format(record) if own is None else own.format(record)


class StreamHandler(Handler):
    """Writes to a stream, by default to the standard output of the process that logs."""

    def __init__(self, stream: Any = None) -> None:
        super().__init__()
        self.__stream = stream

    def emit(self, record: logging.LogRecord) -> None:
        """Write one record."""
        stream = sys.stdout if self.__stream is None else self.__stream
        stream.write(self.format(record) + "\n")
        stream.flush()


class FileHandler(Handler, logging.FileHandler):
    """Appends to a file, which is created with the first record."""

    def __init__(self, path: str, encoding: str | None = None) -> None:
        super().__init__(path, encoding=encoding or "utf-8", delay=True)


def _name(logger: logging.Logger | str) -> str:
    return logger if isinstance(logger, str) else logger.name


def with_per_logger_formatting(cls: type[logging.Handler]) -> type[Handler]:
    """Return a handler class of Python with a formatter for each logger."""
    return type(cls.__name__, (Handler, cls), {"__doc__": cls.__doc__})


def __getattr__(name: str) -> type[Handler]:
    """Make the handler class of this name, once."""
    found = getattr(logging.handlers, name, None) or getattr(logging, name, None)
    if not isinstance(found, type) or not issubclass(found, logging.Handler):
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    made = globals()[name] = with_per_logger_formatting(found)
    return made


__all__ = ["FileHandler", "Handler", "StreamHandler", "with_per_logger_formatting"]
