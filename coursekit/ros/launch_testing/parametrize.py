"""The decorator that launches a test description once for each of several values."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator
from typing import Any

Description = Callable[..., Any]


def parametrize(
    argnames: str, argvalues: Iterable[Any]
) -> Callable[[Description], Callable[[], Iterator[tuple[Description, dict[str, Any]]]]]:
    """Launch a test description with each of `argvalues`. Several names are separated by commas; their values are a tuple.

    >>> @parametrize("speed, robot", [(1, "a"), (2, "b")])
    ... def generate_test_description(speed, robot):
    ...     return f"{robot} at {speed}"
    >>> [(describe(), values) for describe, values in generate_test_description()]
    [('a at 1', {'speed': 1, 'robot': 'a'}), ('b at 2', {'speed': 2, 'robot': 'b'})]
    """
    names = [name.strip() for name in argnames.split(",") if name.strip()]
    rows = [value if isinstance(value, tuple) else (value,) for value in argvalues]

    def decorate(describe: Description) -> Callable[[], Iterator[tuple[Description, dict[str, Any]]]]:
        @functools.wraps(describe)
        def descriptions() -> Iterator[tuple[Description, dict[str, Any]]]:
            for row in rows:
                values = dict(zip(names, row))  # noqa: B905
                with_values = functools.partial(describe, **values)
                functools.update_wrapper(with_values, describe)
                yield with_values, values

        descriptions.__parametrized__ = True  # type: ignore[attr-defined]
        return descriptions

    return decorate
