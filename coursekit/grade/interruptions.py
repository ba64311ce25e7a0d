"""Exceptions that interrupt the judging of work in a sandbox."""


class Gone(Exception):
    """The sandbox ended; the message gives the reason."""

    def __init__(self, why: str, *, timed_out: bool = False) -> None:
        super().__init__(why)
        self.timed_out = timed_out


class TimeOver(Exception):
    """A call of a student's function exceeded its time."""


class NeedsWorkspace(Exception):
    """The judge needs files, which are available after all cells have run and everything is built."""
