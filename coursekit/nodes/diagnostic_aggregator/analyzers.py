"""The analyzers: each takes the statuses whose names it matches, and reports them below its path."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from diagnostic_msgs.msg import DiagnosticStatus, KeyValue

from .status import ERROR, OK, STALE, WORDS, Item, output_name, status_of, without_prefix

OTHER_SECONDS = 5.0
"""Timeout of statuses that no analyzer matches [s]."""
Settings = Mapping[str, Any]
"""The parameters of an analyzer, by their names below its own."""


class Unfit(ValueError):
    """An analyzer whose parameters do not suffice."""


class Analyzer:
    """Keeps the last status of each name; `path` is where it reports, `name` its last part."""

    def __init__(self, path: str, name: str, *, timeout: float = -1.0, num_items: int = -1, discard_stale: bool = False):
        self.path, self.name = path, name
        self.items: dict[str, Item] = {}
        self._timeout, self._count, self._discards = timeout, num_items, discard_stale and timeout > 0

    def matches(self, name: str) -> bool:
        """Whether it takes statuses of this name."""
        return True

    def take(self, item: Item) -> bool:
        """Replace the last status of its name, if it matches; return whether it does."""
        if not self.matches(item.name):
            return False
        self.items[item.name] = item
        return True

    def report(self, now_ns: int) -> list[DiagnosticStatus]:
        """Return its own status, then those of the items."""
        stale = {name for name, item in self.items.items() if 0 < self._timeout < (now_ns - item.heard_ns) * 1e-9}
        if self._discards:
            self.items = {name: item for name, item in self.items.items() if name not in stale}
        items = [self.items[name] for name in sorted(self.items)]
        levels = [STALE if item.name in stale else item.level for item in items]
        head = status_of(self.path, together(levels))
        head.values = [KeyValue(key=item.name, value=item.message) for item in items]
        self._count_items(head)
        return [head, *(item.to_status(self.path, stale=item.name in stale) for item in items)]

    def _count_items(self, head: DiagnosticStatus) -> None:
        count = len(self.items)
        if self._count == count == 0:
            head.level, head.message = bytes([OK]), WORDS[OK]
        elif self._count > 0 and count != self._count:
            head.level = max(head.level, bytes([ERROR]))
            head.message = f"Expected {self._count}, found {count}" if count else f"No items found, expected {self._count}"


class GenericAnalyzer(Analyzer):
    """Matches names by their beginnings, parts, whole names, or regular expressions."""

    def __init__(self, base: str, given: Settings, now_ns: int, complain: Callable[[str], Any]) -> None:
        if "path" not in given:
            raise Unfit("it has no path")
        name = str(given["path"])
        super().__init__(
            joined(base, name), name, timeout=float(given.get("timeout", OTHER_SECONDS)),
            num_items=int(given.get("num_items", -1)), discard_stale=bool(given.get("discard_stale", False)),
        )  # fmt: skip
        self._begin = [*_texts(given, "find_and_remove_prefix"), *_texts(given, "startswith")]
        prefixes = [*_texts(given, "find_and_remove_prefix"), *_texts(given, "remove_prefix")]
        self._prefixes = [output_name(prefix) for prefix in prefixes]
        self._whole, self._contain, self._expected = (_texts(given, key) for key in ("name", "contains", "expected"))
        self._patterns = list(_patterns(_texts(given, "regex"), complain))
        if not (self._begin or self._whole or self._contain or self._expected or self._patterns):
            raise Unfit(f"GenericAnalyzer '{name}' was not initialized with any way of checking diagnostics.")
        for pattern in self._expected:
            self.take(Item(pattern, now_ns))

    def matches(self, name: str) -> bool:
        """Whether it takes statuses of this name."""
        return (
            name in self._expected or name in self._whole
            or name.startswith(tuple(self._begin))
            or any(part in name for part in self._contain)
            or any(pattern.fullmatch(name) for pattern in self._patterns)
        )  # fmt: skip

    def report(self, now_ns: int) -> list[DiagnosticStatus]:
        """Return its own status, then those of the items, and of those that are expected and not there."""
        head, *rest = super().report(now_ns)
        missing = [name for name in self._expected if name not in self.items]
        if missing:
            all_stale = all(status.level == bytes([STALE]) for status in (head, *rest))
            head.level = bytes([STALE if all_stale else ERROR])
            head.message = "All Stale" if all_stale else WORDS[ERROR]
            head.values = [*head.values, *(KeyValue(key=name, value="Missing") for name in missing)]
        rest += [Item(name, now_ns).to_status(self.path, stale=True) for name in missing]
        for status in rest:
            for prefix in self._prefixes:
                status.name = without_prefix(status.name, prefix)
        return [head, *rest]


class DiscardAnalyzer(GenericAnalyzer):
    """Matches as GenericAnalyzer, and reports nothing."""

    def report(self, now_ns: int) -> list[DiagnosticStatus]:
        """Return nothing."""
        return []


class IgnoreAnalyzer(Analyzer):
    """Matches nothing: its parameters are switched off."""

    def __init__(self, base: str, given: Settings, now_ns: int, complain: Callable[[str], Any]) -> None:
        name = str(given.get("path", ""))
        super().__init__(joined(base, name), name)

    def matches(self, name: str) -> bool:
        """Return False."""
        return False

    def report(self, now_ns: int) -> list[DiagnosticStatus]:
        """Return nothing."""
        return []


class OtherAnalyzer(Analyzer):
    """Takes what no other analyzer matches, for five seconds."""

    def __init__(self, base: str, *, as_errors: bool) -> None:
        super().__init__(joined(base, "Other"), "Other", timeout=OTHER_SECONDS, discard_stale=True)
        self._as_errors = as_errors

    def report(self, now_ns: int) -> list[DiagnosticStatus]:
        """Return its own status, then those of the items; nothing without items."""
        head, *rest = super().report(now_ns)
        if rest and self._as_errors:
            head.level, head.message = bytes([ERROR]), 'Unanalyzed items found in "Other"'
        return [head, *rest] if rest else []


def together(levels: list[int]) -> int:
    """Return the level of a group: stale when all are, an error when some are.

    >>> together([0, 1]), together([0, 3]), together([3, 3])
    (1, 2, 3)
    """
    if all(level == STALE for level in levels):
        return STALE
    return min(max(levels), ERROR)


def joined(base: str, name: str) -> str:
    """Return a path below another one.

    >>> joined("", "Arms"), joined("/Robot", "Arms")
    ('/Arms', '/Robot/Arms')
    """
    return "/" + f"{base.strip('/')}/{name}".strip("/")


def _texts(given: Settings, key: str) -> list[str]:
    """Return a parameter that is a text or several."""
    value = given.get(key, [])
    return [value] if isinstance(value, str) else [str(item) for item in value]


def _patterns(texts: list[str], complain: Callable[[str], Any]) -> list[re.Pattern[str]]:
    patterns = []
    for text in texts:
        try:
            patterns.append(re.compile(text))
        except re.error as fault:
            complain(f"Attempted to make regex from {text}. Caught exception, ignoring value. Exception: {fault}")
    return patterns
