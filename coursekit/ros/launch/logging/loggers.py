"""Loggers of a launch: to the screen, to launch.log, and to separate files of a process."""

from __future__ import annotations

import logging
from collections.abc import Mapping
from typing import Any

from coursekit.processes import session

from .config import LaunchConfig, current_config

OUTPUT_CONFIGURATIONS: dict[str, dict[str, tuple[str, ...]]] = {
    "screen": {"both": ("screen",)},
    "log": {"both": ("log",), "stderr": ("screen",)},
    "both": {"both": ("log", "screen")},
    "own_log": {"both": ("own_log",), "stdout": ("own_log",), "stderr": ("own_log",)},
    "full": {"both": ("screen", "log", "own_log"), "stdout": ("own_log",), "stderr": ("own_log",)},
}
_SOURCES, _SINKS = ("stdout", "stderr", "both"), ("screen", "log", "own_log")


class LaunchLogger(logging.Logger):
    """A logger of one process's launch; it is not shared with other processes."""

    def __init__(self, name: str, config: LaunchConfig) -> None:
        super().__init__(name)
        self.__config = config
        self.__output: logging.LogRecord | None = None
        self.propagate = False

    def getEffectiveLevel(self) -> int:
        """Return this logger's own level, else the launch's level."""
        return self.level or self.__config.level

    def isEnabledFor(self, level: int) -> bool:
        """Return whether a message of this level is logged."""
        return not self.disabled and level >= self.getEffectiveLevel()

    def makeRecord(self, *args: Any, **kwargs: Any) -> logging.LogRecord:
        """Return the record with the session's time: logs on the virtual clock are reproducible."""
        record = super().makeRecord(*args, **kwargs)
        record.__dict__.update(_now())
        return record

    def log_output(self, text: str) -> None:
        """Log a process's output at any level. Such records differ only in text and time: one record is copied."""
        if self.__output is None:
            self.__output = self.makeRecord(self.name, logging.INFO, "", 0, "", (), None)
        record = object.__new__(type(self.__output))
        record.__dict__.update(self.__output.__dict__, msg=text, **_now())
        self.handle(record)


def _now() -> dict[str, float]:
    """The session's time in the form of log records."""
    nanoseconds = session.current().clock.now()
    return {"created": nanoseconds / 1e9, "msecs": nanoseconds // 1_000_000 % 1000}


class LineByLine(logging.Formatter):
    """Formats each line of a record separately: one record contains several lines of a process."""

    def format(self, record: logging.LogRecord) -> str:
        """Return the lines."""
        form = self._fmt or ""
        return "\n".join(form.format(created=record.created, message=line) for line in record.getMessage().split("\n"))


PLAIN, STAMPED = logging.Formatter("{message}", style="{"), LineByLine("{created:.7f} {message}", style="{")


def get_logger(name: str | None = None) -> LaunchLogger:
    """Return the logger of that name (default 'launch'), which writes to the screen and to launch.log."""
    config = current_config()
    name = name or "launch"
    if name not in config.loggers:
        config.loggers[name] = LaunchLogger(name, config)
    logger: LaunchLogger = config.loggers[name]
    logger.addHandler(config.get_screen_handler())
    logger.addHandler(config.get_log_file_handler())
    return logger


def get_output_loggers(
    process_name: str, output_config: str | Mapping[str, Any], main_log_file_name: str = "launch.log"
) -> tuple[LaunchLogger, LaunchLogger]:
    """Return the loggers of a process's stdout and stderr lines.

    `output_config` is 'screen', 'log', 'both', 'own_log' or 'full', or a mapping of 'stdout', 'stderr'
    and 'both' to sets of 'screen', 'log' and 'own_log'.

    Raises:
        ValueError: for another configuration.
    """
    targets = _targets(output_config)
    loggers = [_output_logger(process_name, stream, targets, main_log_file_name) for stream in ("stdout", "stderr")]
    return loggers[0], loggers[1]


def _targets(output_config: str | Mapping[str, Any]) -> Mapping[str, Any]:
    if isinstance(output_config, str):
        if output_config not in OUTPUT_CONFIGURATIONS:
            raise ValueError(
                f"'{output_config}' is not a valid standard output config, expected one of {list(OUTPUT_CONFIGURATIONS)}"
            )
        return OUTPUT_CONFIGURATIONS[output_config]
    unknown = [key for key in output_config if key not in _SOURCES]
    if unknown:
        raise ValueError(f"{unknown} are not valid output sources, expected 'stdout', 'stderr' or 'both'")
    targets = {key: (value,) if isinstance(value, str) else tuple(value) for key, value in output_config.items()}
    wrong = sorted({sink for sinks in targets.values() for sink in sinks} - set(_SINKS))
    if wrong:
        raise ValueError(f"{wrong} are not valid output sinks, expected 'screen', 'log' or 'own_log'")
    return targets


def _output_logger(process_name: str, stream: str, targets: Mapping[str, Any], main_file: str) -> LaunchLogger:
    """Return a new logger of one stream; its configuration may differ from that of an earlier logger."""
    config = current_config()
    logger = LaunchLogger(f"{process_name}-{stream}", config)
    both, own = targets.get("both", ()), targets.get(stream, ())
    wanted: list[tuple[bool, Any, logging.Formatter]] = [
        ("screen" in (*both, *own), config.get_screen_handler, PLAIN),
        ("log" in (*both, *own), lambda: config.get_log_file_handler(main_file), STAMPED),
        ("own_log" in both, lambda: config.get_log_file_handler(f"{process_name}.log"), PLAIN),
        ("own_log" in own, lambda: config.get_log_file_handler(f"{process_name}-{stream}.log"), PLAIN),
    ]
    for wants, handler_of, formatter in wanted:
        if wants:
            handler = handler_of()
            handler.setFormatterFor(logger, formatter)
            logger.addHandler(handler)
    config.loggers[logger.name] = logger
    return logger
