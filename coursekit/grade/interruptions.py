"""Exceptions that interrupt the judging of work that is in a sandbox."""


class Gone(Exception):
    """The sandbox ended; the text says why."""

    def __init__(self, why: str, *, timed_out: bool = False) -> None:
        super().__init__(why)
        self.timed_out = timed_out


class TimeOver(Exception):
    """A call of a student's function took longer than it may."""


class NeedsWorkspace(Exception):
    """The judge looks at files: those are looked at when all cells have run and all is built."""
