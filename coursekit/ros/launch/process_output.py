"""Converts a process's output to whole lines of the launch's output."""

from __future__ import annotations

import io
import logging
from typing import Any

from .logging import get_output_loggers


class ProcessOutput:
    """Joins the pieces of a process's output into lines, and logs them with the process's name."""

    def __init__(self, action: Any, name: str, output: Any, output_format: str, cached: bool) -> None:
        self.__action = action
        self.__format = output_format
        self.__loggers = dict(zip(("stdout", "stderr"), get_output_loggers(name, output), strict=True))
        self.__rest = {"stdout": "", "stderr": ""}
        self.__cache = {"stdout": io.StringIO(), "stderr": io.StringIO()} if cached else {}

    def write(self, stream: str, text: str) -> None:
        """Log the complete lines; keep the rest."""
        if self.__cache:
            self.__cache[stream].write(text)
        *lines, self.__rest[stream] = (self.__rest[stream] + text).split("\n")
        if lines:
            self.__log(stream, lines)

    def flush(self) -> None:
        """Log the remaining text without a line end."""
        for stream, rest in self.__rest.items():
            if rest:
                self.__log(stream, [rest])
                self.__rest[stream] = ""

    def cached(self, stream: str) -> str:
        """Return everything that was written to a stream."""
        return self.__cache[stream].getvalue()

    def __log(self, stream: str, lines: list[str]) -> None:
        """Log lines that arrived together as one record: a record costs more than a line."""
        logger = self.__loggers[stream]
        if logger.isEnabledFor(logging.INFO):
            logger.log_output("\n".join(self.__shown(lines)))

    def __shown(self, lines: list[str]) -> list[str]:
        """The lines in the process's output format."""
        head = self.__format.removesuffix("{line}")  # the usual format is filled in once for all lines
        if head == self.__format or "{line" in head:
            return [self.__format.format(line=line, this=self.__action) for line in lines]
        head = head.format(this=self.__action)
        return [head + line for line in lines]
