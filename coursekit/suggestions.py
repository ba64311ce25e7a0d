"""Suggestions for unknown names in error messages: the known name that was probably meant."""

from __future__ import annotations

from collections.abc import Iterable


def similar(name: str, known: Iterable[str], count: int = 1, cutoff: float = 0.6) -> list[str]:
    """Return the known names most similar to `name`, at most `count`; `cutoff` is the minimum similarity, 0 to 1.

    >>> similar("cmd_val", ["cmd_vel", "scan"])
    ['cmd_vel']
    """
    import difflib

    return difflib.get_close_matches(name, list(known), count, cutoff)


def did_you_mean(name: str, known: Iterable[str], otherwise: str = "", quotes: str = "", cutoff: float = 0.6) -> str:
    """Return a sentence with the name that was probably meant, else `otherwise`.

    >>> did_you_mean("cmd_val", ["cmd_vel"]), did_you_mean("x", ["cmd_vel"], "Topics are: cmd_vel.")
    ('Did you mean cmd_vel?', 'Topics are: cmd_vel.')
    """
    near = similar(name, known, 1, cutoff)
    return f"Did you mean {quotes}{near[0]}{quotes}?" if near else otherwise


def hint(name: str, known: Iterable[str], count: int = 1, quotes: str = "", cutoff: float = 0.6) -> str:
    """Return the end of a sentence with the names that were probably meant; empty if there are none.

    >>> hint("talkr", ["talker", "listener"], 3), hint("x", ["talker"])
    ('; did you mean talker?', '')
    """
    near = similar(name, known, count, cutoff)
    return f"; did you mean {' or '.join(f'{quotes}{name}{quotes}' for name in near)}?" if near else ""
