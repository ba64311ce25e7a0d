"""`make class`: grade the made-up class of 200 with two jobs, in each tier; every mark, the time, and if it is deserved.

python -m tests.grade [HOW_MANY_PERCENT [bubblewrap|limits]]
"""

import math
import os
import sys
import tempfile
import time
from pathlib import Path
from unittest import mock

from coursekit.cli.coursekit import main
from coursekit.grade import folders, sandbox

from .class_of_200 import make_class
from .kinds import Kind
from .test_class import deserved, earned, faults, only

TIERS = {"bubblewrap": [], "limits": ["--unsafe"]}


def grade_class(percent: float, tier: str) -> int:
    """Grade that part of the class in one tier; 1 when a mark is not deserved."""
    if tier == "bubblewrap" and sandbox.tier() != tier:
        print("NOT TESTED: no bubblewrap works here: apt-get install bubblewrap")
        return 1

    def share(kind: Kind) -> int:
        held = tier == "bubblewrap" or not kind.walled
        return math.ceil(kind.number * percent / 100) if held else 0

    with tempfile.TemporaryDirectory() as scratch, mock.patch.object(sandbox, "tier", lambda: tier):
        folder, out = Path(scratch, "class"), Path(scratch, "grades.csv")
        kind_by_student = make_class(folder, share)
        jobs, began = str(min(2, os.cpu_count() or 1)), time.monotonic()
        main(
            [
                "grade",
                "--allow-root",
                str(folder),
                "--jobs",
                jobs,
                "--out",
                str(out),
                *TIERS[tier],
                *only(kind_by_student.values()),
            ]
        )
        took = time.monotonic() - began
        wrong = faults(out.with_suffix(""), out, kind_by_student)
        (least, most, _), (total, statuses) = deserved(kind_by_student), earned(out)
        folders.remove(folder)  # too deep for whoever clears up after a temporary folder
    told = f"{len(kind_by_student)} submissions in {took / 60:.1f} minutes; {len(wrong)} marks that are not deserved"
    summed = f"{total:g} points together, {least:g} to {most:g} deserved; " + ", ".join(
        f"{number} {status}" for status, number in statuses.most_common()
    )
    print(f"{tier}: {told}", f"{tier}: {summed}", *wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    part = float(sys.argv[1]) if len(sys.argv) > 1 else 100.0
    sys.exit(max(grade_class(part, tier) for tier in sys.argv[2:] or TIERS))
