"""The result of one check of `coursekit doctor`."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Check:
    """The outcome of one check; an empty fault means success.

    >>> Check("python", "3.11.2").fault
    ''
    """

    name: str
    finding: str
    fault: str = ""
    cure: str = ""
    only_warning: bool = False
