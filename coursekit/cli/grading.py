"""`coursekit grade` and `coursekit verify`: marking of submissions by teachers."""

from __future__ import annotations

import argparse
import contextlib
import datetime
import os
from pathlib import Path
from typing import TYPE_CHECKING

from coursekit.grade.tables import FORMS
from coursekit.grade.variants import Variants, secret_file

from .course_arguments import MORE, ROSTER, chapters_of, notebooks_of, variants_of
from .releasing import add_release

if TYPE_CHECKING:
    from coursekit.grade.batch import Class
    from coursekit.grade.lateness import Policy
    from coursekit.grade.outcome import Outcome
    from coursekit.grade.roster import Roster
    from coursekit.grade.workers import Workers

SEAL = "A seal shows what was changed after it was made. It does not prove who made it, or when."


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the teacher's commands."""
    add_release(commands)
    _add_grade(commands.add_parser("grade", help="mark what a class handed in, in sandboxes, and write a table"))
    teachers = commands.add_parser("teachers", help="the page for teachers: hand out, collect, mark, give back")
    teachers.set_defaults(main=show_teachers)
    verify = commands.add_parser("verify", help="find out whether files made by hand_in() were changed, and run them again")
    verify.add_argument("file", type=Path, nargs="+")
    verify.add_argument("--no-run", action="store_true", help="only look for changes")
    verify.add_argument("--notebooks", type=Path, help="the course's notebooks with solutions, if not coursekit's own")
    verify.add_argument("--variants", type=Path, metavar="NAMES", help="the names that the copies were made for")
    verify.set_defaults(main=run_verify)


def _add_grade(grade: argparse.ArgumentParser) -> None:
    add = grade.add_argument
    add("folder", type=Path, help="a folder with a folder, notebook or zip for each student, or the platform's zip of it")
    add("--jobs", type=int, default=os.cpu_count() or 1, help="submissions at the same time")
    add("--scheduler", metavar="ADDRESS", help="mark on other computers: where dask's scheduler is (docs/teachers.md)")
    add("--out", type=Path, default=Path("grades.csv"), help="the table (default: grades.csv)")
    add("--allow-root", action="store_true", help="mark as root: only where there is no other user, as in a container")
    add("--unsafe", action="store_true", help="mark without walls: only work that you trust as your own")
    add("--notebooks", type=Path, help="the course's notebooks with solutions, if not coursekit's own")
    add("--chapters", nargs="+", metavar="CHAPTER", help="which are marked, such as 02 (default: what most handed in)")
    add("--roster", type=Path, metavar="FILE", help=ROSTER)
    add("--variants", type=Path, metavar="NAMES", help="the roster that copies with numbers of their own were made for")
    add("--again", nargs="*", metavar="STUDENT", help="mark these again, or all, even where a result is kept")
    add("--due", type=_due, help="when it was due, as 2026-11-30T23:59 (goes before that of --policy)")
    add("--count", choices=("newest", "in-time"), help="which version counts: the newest, or the last before the deadline")
    add("--policy", type=Path, metavar="FILE", help="grace, percent per day and extensions (docs/teachers.md)")
    add("--csv", choices=tuple(FORMS), help="tables as your spreadsheet opens them: 1.5,2 or 1,5;2 (default: as the list)")
    add("--for", dest="platform", choices=("moodle", "canvas", "blackboard"), help="write that platform's own columns, too")
    add("--review", action="store_true", help="then mark by hand and write comments, in the browser")
    add("--anonymous", action="store_true", help="codes in place of names; the key is in a file of its own")
    grade.set_defaults(main=run_grade)


def teachers_page() -> Path | None:
    """Return the path of the page for teachers."""
    package = Path(__file__).resolve().parents[1]
    files = [file for file in (package.parent / "docs" / "teachers.md", package / "teachers.md") if file.is_file()]
    return files[0] if files else None


def show_teachers(args: argparse.Namespace) -> int:
    """Print the page for teachers."""
    page = teachers_page()
    if page is None:
        raise SystemExit("The page for teachers is not here. Reinstall with: pip install --force-reinstall coursekit")
    print(page.read_text(encoding="utf-8"))
    return 0


def run_grade(args: argparse.Namespace) -> int:
    """Grade, and print where the results are. Returns 1 when a question is open, 2 when the grader itself is broken."""
    from coursekit.grade import container
    from coursekit.grade.archives import BadArchive
    from coursekit.grade.marking_progress import Bar
    from coursekit.grade.reference import GraderBroken
    from coursekit.grade.sandbox import refusal

    if not args.scheduler and container.is_needed() and (why := container.refusal(args.unsafe)):
        return container.mark(args, otherwise=why)
    if not args.scheduler and (why := refusal(allow_root=args.allow_root, unsafe=args.unsafe)):
        raise SystemExit(why)
    if not args.folder.is_dir() and not (args.folder.suffix.casefold() == ".zip" and args.folder.is_file()):
        raise SystemExit(f"'{args.folder}' is not a folder, nor a zip of one. Give the one with what students handed in.")
    if args.out.suffix.casefold() != ".csv":
        raise SystemExit(f"--out {args.out}: give the table a name that ends in .csv; a folder of that name lies beside it.")
    if args.out.with_suffix("").resolve() == args.folder.resolve():
        said = f"--out {args.out}: its pages would go into the folder '{args.folder}' of what was handed in."
        raise SystemExit(f"{said} Choose another name: --out grades.csv")
    if args.platform and args.anonymous:
        raise SystemExit("--for needs the names that --anonymous hides. Mark with --anonymous; hand back without it.")
    try:
        bar, workers = Bar(), _workers(args)
        group = _class(args, workers)
        jobs = workers.jobs if workers else args.jobs
        with workers or contextlib.nullcontext(), group.graded(jobs, bar, args.again, bar.say) as outcome:
            if args.review and not outcome.interrupted:
                _review(group, outcome)
            _tell(group, outcome, args)
    except GraderBroken as error:
        print(f"The grader is broken: {error}\nNobody was marked. {error.cure}")
        return 2
    except BadArchive as error:
        raise SystemExit(f"'{args.folder}' cannot be opened: {error}. Or unpack it, and give the folder.") from None
    except (ValueError, OSError) as error:
        raise SystemExit(str(error)) from None
    return outcome.exit_status()


def _review(group: Class, outcome: Outcome) -> None:
    """Mark by hand, until Ctrl-C."""
    import webbrowser

    from coursekit.grade.review.marks import Marks
    from coursekit.grade.review.server import serve

    def ready(address: str) -> None:
        print(f"Mark by hand at {address}\nWhat you write is saved at once. End with Ctrl-C.", flush=True)
        webbrowser.open(address)

    serve(Marks(group, outcome), ready)


def _workers(args: argparse.Namespace) -> Workers | None:
    if not args.scheduler:
        return None
    from coursekit.grade.workers import Workers

    return Workers(args.scheduler, allow_root=args.allow_root, unsafe=args.unsafe)


def _class(args: argparse.Namespace, workers: Workers | None) -> Class:
    from coursekit.grade.batch import Class
    from coursekit.grade.roster import Roster

    notebooks = notebooks_of(args)
    names = args.variants or args.roster
    roster = Roster.read(names) if names is not None else None
    known = args.variants is not None or (names is not None and secret_file(names).is_file())
    files = sorted(notebooks.glob("*.ipynb"))
    chapters = [file.name for file in chapters_of(files, args.chapters)] if args.chapters else []
    return Class(
        args.folder.resolve(),
        args.out.resolve(),
        notebooks,
        policy=_policy(args, roster),
        roster=roster,
        variants=Variants.read(names) if known and names is not None else None,
        personal=args.variants is not None,
        chapters=chapters,
        anonymous=args.anonymous,
        form=FORMS[args.csv] if args.csv else None,
        workers=workers,
    )


def _due(text: str) -> datetime.datetime:
    from coursekit.grade.lateness import due_time

    try:
        return due_time(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _policy(args: argparse.Namespace, roster: Roster | None) -> Policy:
    from coursekit.grade.lateness import Policy, read_policy

    policy = read_policy(args.policy, roster) if args.policy else Policy()
    return policy.instead(None if args.due is None else args.due.timestamp(), args.count, args.policy)


def _tell(group: Class, outcome: Outcome, args: argparse.Namespace) -> None:
    from coursekit.grade.handing_back import hand_back, left_out, unlike_the_platform_s
    from coursekit.grade.sanitizing import shown
    from coursekit.grade.statistics import average
    from coursekit.words.counting import counted

    for line in outcome.told:
        print(f"! {shown(line, 400)}")
    for question in outcome.collection.unanswered:
        print(f"? {shown(question.text)} {shown(question.about, 300)}")
    if outcome.collection.unanswered:
        where = group.out.with_name("questions.csv")
        asked = counted(len(outcome.collection.unanswered), "question is", "questions are")
        print(f"{asked} open: fill in the column 'answer' of {where}, and run this again.")
        print("A student with an open question has no mark until then.")
    tiers = ", ".join(sorted({record.marked().tier for record in outcome.records} - {""})) or "none"
    print(f"{outcome.line()}; {average(outcome.records)}; run in the sandbox {tiers}: {args.out}")
    if args.platform:
        for file in hand_back(args.platform, outcome.records, group.roster, group.out, group.form):
            print(f"To hand back: {file}")
        missing = left_out(outcome.records, group.roster) if args.platform == "moodle" else ""
        for said in filter(None, (unlike_the_platform_s(outcome.records, group.roster), missing)):
            print(f"! {said}")
    if group.anonymity is not None:
        print(f"The key to the names: {group.anonymity.names}")
    print(f"Open {group.kept / 'class.html'}; beside it are the pages, gradebook.csv, statistics and similar.csv.")
    print(MORE)
    if outcome.interrupted:
        print("It was stopped: what was marked is kept, and the next run goes on from there.")


def run_verify(args: argparse.Namespace) -> int:
    """Report the faults of submitted files. Returns 1 if there are any."""
    from coursekit.grade.handing_in import same_in, verify
    from coursekit.grade.sanitizing import shown
    from coursekit.words.counting import counted

    folder, variants, count = notebooks_of(args), variants_of(args.variants), 0
    for file in args.file:
        if not file.is_file():
            raise SystemExit(f"There is no file '{file}'. Give the zip that hand_in() made.")
    for file in args.file:
        if len(args.file) > 1:
            print(f"{shown(file.name)}:")
        faults, marked = verify(file, folder, run=not args.no_run, variants=variants)
        for fault in faults:
            print(f"✘ {shown(fault, 400)}")
        if marked is not None:
            print(f"{marked.total():g} of {sum(verdict.of for verdict in marked.verdicts):g} points in a clean run")
        print("✔ Nothing was changed." if not faults else counted(len(faults), "fault"))
        count += len(faults)
    for said in same_in({file.name: file for file in args.file}) if len(args.file) > 1 else ():
        print(f"✘ {shown(said, 400)}")
        count += 1
    print(SEAL)
    return 1 if count else 0
