"""Groups of analyzers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from diagnostic_msgs.msg import DiagnosticStatus, KeyValue

from coursekit.suggestions import did_you_mean

from .analyzers import DiscardAnalyzer, GenericAnalyzer, IgnoreAnalyzer, Settings, Unfit, joined, together
from .status import ERROR, Item, status_of

_KINDS: dict[str, Callable[..., Any]] = {
    "GenericAnalyzer": GenericAnalyzer, "DiscardAnalyzer": DiscardAnalyzer, "IgnoreAnalyzer": IgnoreAnalyzer,
}  # fmt: skip


class AnalyzerGroup:
    """Analyzers that report below the path of their group; `given` holds the settings of each by its name.

    What is wrong with one of them is a status of the group.
    """

    def __init__(self, path: str, name: str, given: Settings, now_ns: int, log: Any) -> None:
        self.path, self.name, self._log, self._now_ns = path, name, log, now_ns
        self._problems: list[Item] = []
        self._analyzers = [analyzer for key in sorted(given) if (analyzer := self._made(key, given[key])) is not None]
        if not self._analyzers:
            log.error(f"No analyzers initialized in AnalyzerGroup '{name}'")

    def _made(self, key: str, given: Any) -> Any:
        if not isinstance(given, dict) or "type" not in given:
            return None
        kind = str(given["type"]).removeprefix("diagnostic_aggregator/")
        try:
            if kind == "AnalyzerGroup":
                name = str(given.get("path", key))
                return AnalyzerGroup(joined(self.path, name), name, given.get("analyzers", {}), self._now_ns, self._log)
            if kind in _KINDS:
                return _KINDS[kind](self.path, given, self._now_ns, self._log.error)
            known = ["AnalyzerGroup", *_KINDS]
            advice = did_you_mean(kind, known, f"There are: {', '.join(known)}.")
            self._log.error(f"Failed to load analyzer {key}, type {given['type']}: there is no such class. {advice}")
            self._problems.append(Item(key, self._now_ns, message="Pluginlib exception loading analyzer"))
        except Unfit as fault:
            self._log.error(f"Unable to initialize analyzer {key}, type: {given['type']}: {fault}")
            self._problems.append(Item(key, self._now_ns, message="Analyzer init failed"))
        return None

    def take(self, item: Item) -> bool:
        """Hand a status to all its analyzers; return whether one of them matches it."""
        taken = [analyzer.take(item) for analyzer in self._analyzers]
        return any(taken)

    def report(self, now_ns: int) -> list[DiagnosticStatus]:
        """Return the statuses of all analyzers, then its own, unless it has no path."""
        if not self._analyzers:
            return [status_of(self.path if self.path != "/" else "/AnalyzerGroup", ERROR, "No analyzers")]
        reports = [(analyzer, analyzer.report(now_ns)) for analyzer in self._analyzers]
        heads = [
            (analyzer.name, status) for analyzer, report in reports for status in report if status.name == analyzer.path
        ]
        statuses = [status for _, report in reports for status in report]
        if self.path != "/" and heads:
            own = status_of(self.path, together([status.level[0] for _, status in heads]))
            own.values = [KeyValue(key=name, value=status.message) for name, status in heads]
            statuses.append(own)
        return statuses + [item.to_status(self.path, stale=True) for item in self._problems]


__all__ = ["AnalyzerGroup"]
