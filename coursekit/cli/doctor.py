"""`coursekit doctor`: faults of the set-up, and their remedies."""

from __future__ import annotations

import argparse
from collections.abc import Iterable

from .check import Check


def run_doctor(args: argparse.Namespace) -> int:
    """Print every check, and the remedy for each fault."""
    from .checks import run_all

    return tell(run_all())


def tell(checks: Iterable[Check]) -> int:
    """Print checks with the remedy for each fault. Returns 1 if there is a fault that is more than a warning."""
    from coursekit.words.counting import counted

    faults = 0
    for check in checks:
        mark = "✔" if not check.fault else "!" if check.only_warning else "✘"
        print(f"{mark} {check.name:<11} {check.fault or check.finding}")
        if check.fault:
            print(f"  → {check.cure}")
            faults += not check.only_warning
    cure = "follow the lines with arrows, then run this again."
    print(f"{counted(faults, 'fault')}: {cure}" if faults else "All is well.")
    return 1 if faults else 0
