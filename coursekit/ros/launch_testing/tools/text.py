"""Comparison of text and of lines with an expected output."""

from ..matching import build_line_match, build_text_match, normalize_lineseps

__all__ = ["build_line_match", "build_text_match", "normalize_lineseps"]
