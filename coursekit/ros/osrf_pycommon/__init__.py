"""What launch's programs take from osrf_pycommon."""

from . import process_utils, terminal_color  # programs that have imported launch find them without an import of their own

__all__ = ["process_utils", "terminal_color"]
