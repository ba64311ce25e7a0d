"""What interrupts the judging of work that is in a sandbox."""


class Gone(Exception):
    """The sandbox ended; the text says why."""


class NeedsWorkspace(Exception):
    """The judge looks at files: those are looked at when all cells have run and all is built."""
