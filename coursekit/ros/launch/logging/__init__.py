"""What a launch prints and writes to its log files."""

from .config import LaunchConfig, launch_config, reset
from .loggers import LaunchLogger, get_logger, get_output_loggers

__all__ = ["LaunchConfig", "LaunchLogger", "get_logger", "get_output_loggers", "launch_config", "reset"]
