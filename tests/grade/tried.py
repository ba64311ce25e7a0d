"""Work whose trials are made up: what a judge says of what was seen."""

from coursekit.grade.checking import judge, judge_work
from coursekit.grade.exercise import find
from coursekit.grade.plan import Seen
from coursekit.grade.work import Work


class Tried(Work):
    """Built work, of which each trial sees the next of these."""

    def __init__(self, *seen: Seen) -> None:
        super().__init__({}, None)
        self._next = iter(seen)

    def built(self, package, *of):
        """It is."""

    def try_out(self, *commands, **plan):
        return next(self._next)


def verdict(name, *seen):
    """The verdict on exercise `name`, at the second try."""
    return judge_work(find(name), Tried(*seen), 2)


def told_of(name, variables, workspace):
    """The verdict on a notebook's variables and files, which is not full marks."""
    said = judge(find(name), variables, workspace)
    assert not said.passed
    return said
