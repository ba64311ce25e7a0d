"""A launch's output and its log files."""

from . import handlers
from .config import LaunchConfig, get_logging_directory, launch_config, log_launch_config, reset
from .config import make_unique_log_dir as _make_unique_log_dir
from .loggers import LaunchLogger, get_logger, get_output_loggers

__all__ = [
    "LaunchConfig",
    "LaunchLogger",
    "_make_unique_log_dir",
    "get_logger",
    "get_logging_directory",
    "get_output_loggers",
    "handlers",
    "launch_config",
    "log_launch_config",
    "reset",
]
