"""The command `coursekit`: lab, doctor, cpp, progress, course, slam, slam-error, network, gateway, release and grade."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence

from coursekit.cli import cpp, grading, hub, lab, networking, slam
from coursekit.cli.doctor import run_doctor
from coursekit.systems.streams import reader_has_gone, use_utf8


def main(argv: Sequence[str] | None = None) -> int:
    """Run the shell command."""
    use_utf8()
    parser = argparse.ArgumentParser(prog="coursekit", description="A ROS 2 course that needs no ROS install.")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    lab.add_commands(commands)
    doctor = commands.add_parser("doctor", help="check the set-up and say what cures each fault")
    doctor.set_defaults(main=run_doctor)
    progress = commands.add_parser("progress", help="show your points")
    progress.add_argument("--folder", default="course")
    progress.set_defaults(main=show_progress)
    cpp.add_commands(commands)
    slam.add_commands(commands)
    grading.add_commands(commands)
    networking.add_commands(commands)
    hub.add_commands(commands)
    args = parser.parse_args(argv)
    try:
        status = int(args.main(args) or 0)
        sys.stdout.flush()
    except OSError as error:
        if not reader_has_gone(error):
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    return status


def show_progress(args: argparse.Namespace) -> int:
    """Print the points."""
    os.environ["COURSEKIT_COURSE"] = str(lab.folder_of(args))
    from coursekit.grade.progress import progress

    print(progress())
    return 0


if __name__ == "__main__":
    sys.exit(main())
