"""The outcome of a run: all records, the questions, the messages."""

from __future__ import annotations

from dataclasses import dataclass, field

from coursekit.words.counting import counted

from .collector import Collection
from .record import Record
from .statuses import by_status, told


@dataclass
class Outcome:
    """The outcome of a run."""

    records: list[Record]
    collection: Collection
    told: list[str] = field(default_factory=list)
    interrupted: bool = False

    def statuses(self) -> dict[str, int]:
        """Return the number of students with each status; every student counts once."""
        return by_status(record.status() for record in self.records)

    def line(self) -> str:
        """Return the state of the class in one line, the same wherever it is printed."""
        nobody_s = len(self.collection.whose)
        asked = f"; {counted(nobody_s, 'hand-in is', 'hand-ins are')} nobody's yet" if nobody_s else ""
        return f"{counted(len(self.records), 'student')}: {told(self.statuses()) or 'nothing was handed in'}{asked}"

    def exit_status(self) -> int:
        """Return the exit status, which is not 0 when a teacher must act."""
        if self.interrupted:
            return 130
        open_ = self.collection.unanswered or any(record.status() == "not marked" for record in self.records)
        return 1 if open_ else 0
