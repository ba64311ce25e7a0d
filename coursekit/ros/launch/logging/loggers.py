"""Loggers of a launch: to the screen, to launch.log, to files of a process's own."""

from __future__ import annotations

import logging
import sys
from collections.abc import Callable, Mapping
from typing import Any, TextIO

from coursekit.core import session

from .config import LaunchConfig, current_config

Writer = Callable[[int, str], None]
OUTPUT_CONFIGURATIONS: dict[str, dict[str, tuple[str, ...]]] = {
    "screen": {"both": ("screen",)},
    "log": {"both": ("log",), "stderr": ("screen",)},
    "both": {"both": ("log", "screen")},
    "own_log": {"both": ("own_log",), "stdout": ("own_log",), "stderr": ("own_log",)},
    "full": {"both": ("screen", "log", "own_log"), "stdout": ("own_log",), "stderr": ("own_log",)},
}


class LaunchLogger(logging.Logger):
    """A logger of one process's launch; it is not shared with other processes."""

    def __init__(self, name: str, config: LaunchConfig) -> None:
        super().__init__(name)
        self.__config = config
        self.propagate = False

    def getEffectiveLevel(self) -> int:
        """Return this logger's own level, else the launch's."""
        return self.level or self.__config.level

    def isEnabledFor(self, level: int) -> bool:
        """Return whether a message of this level is logged."""
        return not self.disabled and level >= self.getEffectiveLevel()


class ScreenHandler(logging.Handler):
    """Writes to the standard output of the process that logs."""

    def emit(self, record: logging.LogRecord) -> None:
        """Write one line."""
        sys.stdout.write(self.format(record) + "\n")
        sys.stdout.flush()


class StampedFormatter(logging.Formatter):
    """Adds the session's time, so that logs on the virtual clock repeat."""

    def format(self, record: logging.LogRecord) -> str:
        """Return the line, or each line of a process's output, with the time in seconds before it."""
        stamp, text = f"{session.current().clock.now() / 1e9:.7f} ", super().format(record)
        return stamp + (text.replace("\n", "\n" + stamp) if self._fmt == PLAIN else text)


NAMED = "[%(levelname)s] [%(name)s]: %(message)s"
PLAIN = "%(message)s"


def get_logger(name: str | None = None) -> LaunchLogger:
    """Return the logger of that name (default 'launch'): to the screen and to launch.log."""
    config = current_config()
    name = name or "launch"
    if name not in config.loggers:
        logger = LaunchLogger(name, config)
        screen = ScreenHandler()
        screen.setFormatter(logging.Formatter(NAMED))
        logger.addHandler(screen)
        logger.addHandler(_file(config, "launch.log", NAMED))
        config.loggers[name] = logger
    found: LaunchLogger = config.loggers[name]
    return found


def get_output_loggers(
    process_name: str, output_config: str | Mapping[str, Any]
) -> tuple[LaunchLogger, LaunchLogger]:
    """Return the loggers of a process's stdout and stderr lines.

    `output_config` is 'screen', 'log', 'both', 'own_log' or 'full', or a mapping of 'stdout', 'stderr'
    and 'both' to sets of 'screen', 'log' and 'own_log'.

    Raises:
        ValueError: for another configuration.
    """
    targets = _targets(output_config)
    return (_output_logger(process_name, "stdout", targets), _output_logger(process_name, "stderr", targets))


def _targets(output_config: str | Mapping[str, Any]) -> Mapping[str, Any]:
    if isinstance(output_config, str):
        if output_config not in OUTPUT_CONFIGURATIONS:
            raise ValueError(
                f"'{output_config}' is not a valid standard output config, expected one of "
                f"{list(OUTPUT_CONFIGURATIONS)}"
            )
        return OUTPUT_CONFIGURATIONS[output_config]
    unknown = [key for key in output_config if key not in ("stdout", "stderr", "both")]
    if unknown:
        raise ValueError(f"{unknown} are not valid output sources, expected 'stdout', 'stderr' or 'both'")
    return {key: (value,) if isinstance(value, str) else tuple(value) for key, value in output_config.items()}


def _output_logger(process_name: str, stream: str, targets: Mapping[str, Any]) -> LaunchLogger:
    """Return the logger of one stream, made anew so that another configuration can be chosen."""
    config = current_config()
    logger = LaunchLogger(f"{process_name}-{stream}", config)
    wanted = {*targets.get("both", ()), *targets.get(stream, ())}
    if "screen" in wanted:
        screen = ScreenHandler()
        screen.setFormatter(logging.Formatter(PLAIN))
        logger.addHandler(screen)
    if "log" in wanted:
        logger.addHandler(_file(config, "launch.log", PLAIN))
    if "own_log" in targets.get("both", ()):
        logger.addHandler(_file(config, f"{process_name}.log", PLAIN))
    if "own_log" in targets.get(stream, ()):
        logger.addHandler(_file(config, f"{process_name}-{stream}.log", PLAIN))
    config.loggers[logger.name] = logger
    return logger


def _file(config: LaunchConfig, file_name: str, form: str) -> logging.Handler:
    """Return the handler of a log file in one of its forms; one file is opened only once."""
    key = file_name + form
    if key not in config.files:
        config.files[key] = _LogFile(config.get_log_file_path(file_name))
        config.files[key].setFormatter(StampedFormatter(form))
    return config.files[key]


class _LogFile(logging.Handler):
    """Appends lines to a file, which is made with the first line."""

    def __init__(self, path: str) -> None:
        super().__init__()
        self.__path = path
        self.__file: TextIO | None = None

    def emit(self, record: logging.LogRecord) -> None:
        """Append one line."""
        if self.__file is None:
            self.__file = open(self.__path, "a", encoding="utf-8", buffering=1)  # noqa: SIM115
        self.__file.write(self.format(record) + "\n")

    def close(self) -> None:
        """Close the file."""
        if self.__file is not None:
            self.__file.close()
            self.__file = None
        super().close()
