"""Launch arguments of the command line."""

from __future__ import annotations

from collections.abc import ItemsView, Iterable


def parse_launch_arguments(launch_arguments: Iterable[str]) -> ItemsView[str, str]:
    """Return name and value of each `name:=value`; the last value of a name wins.

    >>> list(parse_launch_arguments(["speed:=1", "speed:=2"]))
    [('speed', '2')]

    Raises:
        RuntimeError: when an argument has another form.
    """
    parsed: dict[str, str] = {}
    for argument in launch_arguments:
        name, sign, value = argument.partition(":=")
        if not (name and sign and value):
            raise RuntimeError(f"malformed launch argument '{argument}', expected format '<name>:=<value>'")
        parsed[name] = value
    return parsed.items()
