"""`coursekit release` and `coursekit grade`: what teachers hand out and how they mark it."""

from __future__ import annotations

import argparse
import datetime
import os
from pathlib import Path

from coursekit.grade.variants import Variants, secret_file

_NAMES = "a copy for each of these students with numbers and names of its own; a name on each line, or a .csv"


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the teacher's commands."""
    release = commands.add_parser("release", help="write the notebooks that students get: without solutions")
    release.add_argument("chapters", nargs="*", help="which, such as 02 or 02_topics (default: all)")
    release.add_argument("--out", type=Path, default=Path("release"), help="the folder (default: release)")
    release.add_argument("--notebooks", type=Path, help="the course's notebooks with solutions, if not coursekit's own")
    release.add_argument("--language", default="en", help="of the chapters, where they are translated (default: en)")
    release.add_argument("--variants", type=Path, metavar="NAMES", help=_NAMES)
    release.set_defaults(main=run_release)
    grade = commands.add_parser("grade", help="mark a folder of submissions in sandboxes, and write a table")
    grade.add_argument("folder", type=Path, help="a folder, notebook or zip for each student in it")
    grade.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="submissions at the same time")
    grade.add_argument("--out", type=Path, default=Path("grades.csv"), help="the table (default: grades.csv)")
    grade.add_argument("--notebooks", type=Path, help="the course's notebooks with solutions, if not coursekit's own")
    grade.add_argument("--due", type=datetime.datetime.fromisoformat, help="when it was due, as 2026-11-30T23:59")
    grade.add_argument("--variants", type=Path, metavar="NAMES", help="the names that the copies were made for")
    grade.set_defaults(main=run_grade)
    verify = commands.add_parser("verify", help="find out whether a file made by hand_in() was changed, and run it again")
    verify.add_argument("file", type=Path)
    verify.add_argument("--no-run", action="store_true", help="only look for changes")
    verify.add_argument("--notebooks", type=Path, help="the course's notebooks with solutions, if not coursekit's own")
    verify.add_argument("--variants", type=Path, metavar="NAMES", help="the names that the copies were made for")
    verify.set_defaults(main=run_verify)


def run_release(args: argparse.Namespace) -> int:
    """Release, and say what was written."""
    from coursekit.grade.editions import chapters
    from coursekit.grade.release import release

    from .coursekit import notebooks_folder

    folder = args.notebooks or notebooks_folder()
    try:
        known = chapters(folder, args.language)
    except ValueError as error:
        raise SystemExit(str(error)) from None
    chosen = [one for one in known if not args.chapters or any(one.name.startswith(word) for word in args.chapters)]
    if not chosen:
        raise SystemExit(f"No chapter begins with {', '.join(args.chapters)}. There are: {', '.join(p.stem for p in known)}")
    variants = _variants(args.variants, new=True)
    out = args.out.resolve()
    for written in release(chosen, out, variants):
        print(written.relative_to(out))
    if args.variants is not None:
        print(f"Keep {secret_file(args.variants).name}, beside the names, and show it to nobody: grading needs it.")
    return 0


def _variants(names: Path | None, *, new: bool = False) -> Variants | None:
    try:
        return None if names is None else Variants.read(names, new=new)
    except (ValueError, OSError) as error:
        raise SystemExit(str(error)) from None


def run_grade(args: argparse.Namespace) -> int:
    """Grade, and say where the results are."""
    from coursekit.grade.batch import Bar, Class

    from .coursekit import notebooks_folder

    if not args.folder.is_dir():
        raise SystemExit(f"'{args.folder}' is not a folder. Give the one that holds a folder for each student.")
    due = None if args.due is None else args.due.timestamp()
    notebooks, variants = args.notebooks or notebooks_folder(), _variants(args.variants)
    group = Class(args.folder.resolve(), args.out.resolve(), notebooks, due=due, variants=variants)
    marks = group.grade(args.jobs, Bar())
    total = sum(one.total() for one in marks) / len(marks) if marks else 0
    print(f"{len(marks)} graded, {total:.2f} points on average: {args.out}")
    print(f"Open {group.kept / 'class.html'}; beside it are the reports, statistics, histogram.png and similar.csv.")
    return 0


def run_verify(args: argparse.Namespace) -> int:
    """Say what is wrong with a file that was handed in; 1 when something is."""
    from coursekit.grade.handing_in import verify

    from .coursekit import notebooks_folder

    if not args.file.is_file():
        raise SystemExit(f"There is no file '{args.file}'. Give the zip that hand_in() made.")
    folder = args.notebooks or notebooks_folder()
    faults, marked = verify(args.file, folder, run=not args.no_run, variants=_variants(args.variants))
    for fault in faults:
        print(f"✘ {fault}")
    if marked is not None:
        print(f"{marked.total():g} of {sum(one.of for one in marked.verdicts):g} points in a clean run")
    print("✔ Nothing was changed." if not faults else f"{len(faults)} fault(s)")
    return 1 if faults else 0
