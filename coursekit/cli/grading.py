"""`coursekit grade`: mark a folder of submissions."""

from __future__ import annotations

import argparse
import datetime
import os
from pathlib import Path


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the teacher's commands."""
    grade = commands.add_parser("grade", help="mark a folder of submissions in sandboxes, and write a table")
    grade.add_argument("folder", type=Path, help="a folder, notebook or zip for each student in it")
    grade.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="submissions at the same time")
    grade.add_argument("--out", type=Path, default=Path("grades.csv"), help="the table (default: grades.csv)")
    grade.add_argument("--notebooks", type=Path, help="the course's notebooks with solutions, if not coursekit's own")
    grade.add_argument("--due", type=datetime.datetime.fromisoformat, help="when it was due, as 2026-11-30T23:59")
    grade.set_defaults(main=run_grade)


def run_grade(args: argparse.Namespace) -> int:
    """Grade, and say where the results are."""
    from coursekit.grade.batch import Bar, Class

    from .coursekit import notebooks_folder

    if not args.folder.is_dir():
        raise SystemExit(f"'{args.folder}' is not a folder. Give the one that holds a folder for each student.")
    due = None if args.due is None else args.due.timestamp()
    group = Class(args.folder.resolve(), args.out.resolve(), args.notebooks or notebooks_folder(), due=due)
    marks = group.grade(args.jobs, Bar())
    total = sum(one.total() for one in marks) / len(marks) if marks else 0
    print(f"{len(marks)} graded, {total:.2f} points on average: {args.out}")
    print(f"Reports, statistics, histogram.png and similar.csv: {group.kept}")
    return 0
