"""Handlers that may use a separate format for each logger. In ROS 2: launch.logging.handlers."""

from __future__ import annotations

import logging
import sys
from typing import Any


class Handler(logging.Handler):
    """A handler with a default formatter, and optional formatters for single loggers."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._formatters: dict[str, logging.Formatter] = {}

    def setFormatterFor(self, logger: logging.Logger, formatter: logging.Formatter) -> None:
        """Set the formatter for this logger's messages."""
        self._formatters[logger.name] = formatter

    def unsetFormatterFor(self, logger: logging.Logger) -> None:
        """Use the default formatter for this logger's messages."""
        self._formatters.pop(logger.name, None)

    def getFormatterFor(self, logger: logging.Logger) -> logging.Formatter | None:
        """Return the formatter of this logger."""
        return self._formatters.get(logger.name, self.formatter)

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


__all__ = ["FileHandler", "Handler", "StreamHandler"]
