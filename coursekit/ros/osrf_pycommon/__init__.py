"""The parts of osrf_pycommon that launch's programs use."""

from . import process_utils, terminal_color  # programs that have imported launch find them without an import of their own

__all__ = ["process_utils", "terminal_color"]
