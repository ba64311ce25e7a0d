"""The error of a substitution that has no value."""

from __future__ import annotations


class SubstitutionFailure(RuntimeError):
    """Raised if a substitution cannot be performed."""
