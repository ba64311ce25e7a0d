"""Errors of bags."""

from __future__ import annotations


class BagError(RuntimeError):
    """A bag that cannot be read or written; the message gives the reason and the remedy."""
