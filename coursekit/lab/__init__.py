"""The lab: what notebooks use. `from coursekit.lab import *` starts the session of the kernel."""

from .kernel import reset, start
from .magics import terminal, terminals, wait

__all__ = ["reset", "terminal", "terminals", "wait"]

start()
