"""`make class`: grade the made-up class of 200 with two jobs; every mark, how long it took, and whether all are deserved.

python -m tests.grade [HOW_MANY_PERCENT]
"""

import math
import os
import sys
import tempfile
import time
from pathlib import Path

from coursekit.cli.coursekit import main

from .class_of_200 import make_class
from .test_class import faults


def grade_class(percent: float) -> int:
    """Grade that part of the class; 1 when a mark is not deserved."""
    with tempfile.TemporaryDirectory() as scratch:
        folder, out = Path(scratch, "class"), Path(scratch, "grades.csv")
        made = make_class(folder, lambda kind: math.ceil(kind.number * percent / 100))
        began = time.monotonic()
        main(["grade", "--allow-root", str(folder), "--jobs", str(min(2, os.cpu_count() or 1)), "--out", str(out)])
        took = time.monotonic() - began
        wrong = faults(out.with_suffix(""), out, made)
    print(f"{len(made)} submissions in {took / 60:.1f} minutes; {len(wrong)} marks that are not deserved", *wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(grade_class(float(sys.argv[1]) if len(sys.argv) > 1 else 100.0))
