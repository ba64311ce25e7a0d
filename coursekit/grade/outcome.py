"""What came of a run: everybody's records, what was asked, what has to be told."""

from __future__ import annotations

from dataclasses import dataclass, field

from .collector import Collection
from .record import Record
from .statuses import counted


@dataclass
class Outcome:
    """What came of a run."""

    records: list[Record]
    collection: Collection
    told: list[str] = field(default_factory=list)
    interrupted: bool = False

    def statuses(self) -> dict[str, int]:
        """How many there are of each status; what is nobody's yet counts as a question."""
        return counted([*(one.status() for one in self.records), *("question" for _ in self.collection.whose)])

    def exit_status(self) -> int:
        """Not 0 when a teacher has to do something."""
        if self.interrupted:
            return 130
        open_ = self.collection.unanswered or any(one.status() == "not marked" for one in self.records)
        return 1 if open_ else 0
