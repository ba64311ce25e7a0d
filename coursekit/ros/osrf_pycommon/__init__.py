"""The parts of osrf_pycommon that launch's programs use."""

from . import process_utils, terminal_color  # programs that import launch use them without importing them

__all__ = ["process_utils", "terminal_color"]
