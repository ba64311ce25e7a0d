"""Quality of service as text: six groups, in which rmw_zenoh's defaults are left out."""

from __future__ import annotations

from typing import NamedTuple

FOREVER = 9223372036854775807
"""An infinite duration [ns]."""
DEFAULT_DEPTH = 42
_SECOND = 1_000_000_000


class Quality(NamedTuple):
    """Policies by their numbers in rmw; durations in nanoseconds.

    >>> Quality(depth=10).text()
    '::,10:,:,:,,'
    """

    reliability: int = 1
    durability: int = 2
    history: int = 1
    depth: int = DEFAULT_DEPTH
    deadline: int = FOREVER
    lifespan: int = FOREVER
    liveliness: int = 1
    lease: int = FOREVER

    def text(self) -> str:
        """Return its form at the end of a token.

        >>> Quality(reliability=2, deadline=1_500_000_000).text()  # best effort; a deadline of 1.5 s
        '2::,:1,500000000:,:,,'
        """
        depth = _unless(self.depth, DEFAULT_DEPTH)
        return ":".join(
            (
                _unless(self.reliability, 1),
                _unless(self.durability, 2),
                f"{_unless(self.history, 1)},{depth}",
                _span_text(self.deadline),
                _span_text(self.lifespan),
                f"{_unless(self.liveliness, 1)},{_span_text(self.lease)}",
            )
        )


def read_quality(text: str) -> Quality:
    """Parse the policies in a text; ValueError for a malformed one.

    >>> read_quality("2::,5:,:,:,,").reliability
    2
    """
    groups = [group.split(",") for group in text.split(":")]
    if [len(group) for group in groups] != [1, 1, 2, 2, 2, 3]:
        raise ValueError(f"'{text[:80]}' is no quality of service")
    (reliability,), (durability,), (history, depth), deadline, lifespan, (liveliness, *lease) = groups
    return Quality(
        _number(reliability, 1, 5),
        _number(durability, 2, 5),
        _number(history, 1, 5),
        _number(depth, DEFAULT_DEPTH, 2**31 - 1),
        _span(deadline),
        _span(lifespan),
        _number(liveliness, 1, 5),
        _span(lease),
    )


def _unless(value: int, default: int) -> str:
    return "" if value == default else str(value)


def _span_text(nanoseconds: int) -> str:
    if nanoseconds >= FOREVER:
        return ","
    seconds, rest = divmod(nanoseconds, _SECOND)
    return f"{seconds},{rest}"


def _span(parts: list[str]) -> int:
    """Parse a duration; a missing part is that of the infinite duration."""
    seconds = _number(parts[0], FOREVER // _SECOND, 2**63)
    rest = _number(parts[1], FOREVER % _SECOND, 2**63)
    return min(seconds * _SECOND + rest, FOREVER)


def _number(text: str, default: int, most: int) -> int:
    if not text:
        return default
    if not (text.isascii() and text.isdecimal()) or len(text) > 20 or int(text) > most:
        raise ValueError(f"'{text[:40]}' is no number of a quality of service")
    return int(text)
