"""`coursekit release` and `coursekit new`: handing out notebooks, and starting new chapters."""

from __future__ import annotations

import argparse
from pathlib import Path

from coursekit.grade.variants import Variants, secret_file

from .course_arguments import MORE, ROSTER, chapters_of, notebooks_of, variants_of

_NAMES = "a copy for each of these students with numbers and names of its own; a roster, or a name on each line"


def add_release(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the commands for handing out notebooks."""
    release = commands.add_parser("release", help="write the notebooks that students get: without solutions")
    release.add_argument("chapters", nargs="*", help="which, such as 02 or 02_topics (default: all)")
    release.add_argument("--out", type=Path, default=Path("release"), help="the folder (default: release)")
    release.add_argument("--notebooks", type=Path, help="the course's notebooks with solutions, if not coursekit's own")
    release.add_argument("--language", default="en", help="of the chapters, where they are translated (default: en)")
    release.add_argument("--roster", type=Path, metavar="FILE", help=f"a marked copy for each student. {ROSTER}")
    release.add_argument("--wheel", metavar="ADDRESS", help="what students install: where the wheel is (docs/teachers.md)")
    release.add_argument("--variants", type=Path, metavar="NAMES", help=_NAMES)
    how = "put the copies into a zip that Moodle gives to each student (docs/teachers.md)"
    release.add_argument("--for", dest="platform", choices=("moodle",), help=how)
    through = "a folder that a server's students can read: put the chapters there (docs/hub.md)"
    release.add_argument("--exchange", type=Path, metavar="FOLDER", help=through)
    release.set_defaults(main=run_release)
    new = commands.add_parser("new", help="begin a chapter of your own: a notebook with an exercise, and its check")
    new.add_argument("name", help="the name of its exercises, such as gripper")
    new.add_argument("--folder", type=Path, default=Path("my_course"), help="where (default: my_course)")
    new.set_defaults(main=run_new)


def run_release(args: argparse.Namespace) -> int:
    """Release, and print the written files."""
    from coursekit.grade.editions import chapters
    from coursekit.grade.release import WHEEL, release

    folder = notebooks_of(args)
    try:
        known = chapters(folder, args.language)
    except ValueError as error:
        raise SystemExit(str(error)) from None
    chosen = chapters_of(known, args.chapters)
    names = args.variants or args.roster
    if args.exchange and names:
        raise SystemExit("Through an exchange everybody gets the same: leave --roster and --variants out, or --exchange.")
    variants = variants_of(names, new=True)
    out, moodle = args.out.resolve(), args.platform is not None
    if moodle:
        _expect_numbers(variants)
    personal, wheel = args.variants is not None, args.wheel or WHEEL
    for written in release(chosen, out, variants, personal=personal, wheel=wheel, moodle=moodle, language=args.language):
        print((args.out / written.relative_to(out)).as_posix())
    if args.exchange:
        print(_hand_out(args.exchange, out))
    elif args.wheel is None:
        print("page.html has a gap where students find what to install: say it with --wheel ADDRESS (docs/teachers.md).")
    if variants is not None and names is not None:
        print(variants.roster.told())
        print(f"Keep {secret_file(names).name}, next to the names, and keep it secret: grading needs it.")
        print("How each student gets their zip: docs/teachers.md, 'A zip for each student'; copies.csv lists the owners.")
    print(MORE)
    return 0


def _hand_out(exchange: Path, out: Path) -> str:
    """Put the release into the exchange. Returns a sentence with its location."""
    from coursekit.grade.exchange import hand_out

    files = [path for path in out.rglob("*") if path.is_file() and path.suffix in (".ipynb", ".py")]
    try:
        place = hand_out(exchange, out.name, files, out)
    except OSError as error:
        raise SystemExit(f"'{exchange}' cannot be written ({error.strerror}: '{error.filename}').") from None
    return f"{place}: students have it when their server starts next."


def _expect_numbers(variants: Variants | None) -> None:
    from coursekit.grade.handing_out import expect_numbers

    if variants is None:
        raise SystemExit("--for moodle hands out a copy for each student: give the class as --roster, too.")
    try:
        expect_numbers(variants.roster)
    except ValueError as error:
        raise SystemExit(str(error)) from None


def run_new(args: argparse.Namespace) -> int:
    """Write the files, and print how to use them."""
    from coursekit.grade.template import write_template

    try:
        written = write_template(args.folder, args.name)
    except (ValueError, OSError) as error:
        raise SystemExit(str(error)) from None
    print("\n".join(f"new: {file}" for file in written))
    print(f"Work on it:  coursekit lab --folder {args.folder}")
    print(f"Hand it out: coursekit release {args.name} --notebooks {args.folder}")
    print(f"Mark it:     coursekit grade HANDED_IN --chapters {args.name} --notebooks {args.folder}")
    print("How it is made up: docs/own_exercises.md, beside the course's README")
    return 0
