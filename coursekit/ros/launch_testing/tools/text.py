"""Compares text, and lines of text, with what is expected."""

from ..matching import build_line_match, build_text_match, normalize_lineseps

__all__ = ["build_line_match", "build_text_match", "normalize_lineseps"]
