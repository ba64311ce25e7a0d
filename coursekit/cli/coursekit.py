"""The command `coursekit`: lab, doctor, cpp, progress, course, slam, slam-error, network, gateway, release and grade."""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from urllib.parse import quote

from coursekit.cli import compile_ahead, cpp, grading, networking, slam
from coursekit.cli.terminal_settings import terminal_settings
from coursekit.packages.folder_name import refusal
from coursekit.systems import rights
from coursekit.systems.children import with_utf8
from coursekit.systems.streams import reader_has_gone, use_utf8


def main(argv: Sequence[str] | None = None) -> int:
    """Entry point of the shell command."""
    use_utf8()
    parser = argparse.ArgumentParser(prog="coursekit", description="A ROS 2 course that needs no ROS install.")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    lab = commands.add_parser("lab", help="open the course in JupyterLab")
    lab.add_argument("--folder", default="course", help="your copy of the course (default: course)")
    lab.add_argument("--language", default="en", help="of the chapters, where they are translated (default: en)")
    lab.add_argument("--no-browser", action="store_true", help="print the address instead of opening a browser")
    lab.add_argument("jupyter", nargs=argparse.REMAINDER, help="further options for jupyter lab, after --")
    lab.set_defaults(main=open_lab)
    copy = commands.add_parser("course", help="make or update your copy of the course, without opening it")
    copy.add_argument("--folder", default="course")
    copy.add_argument("--language", default="en")
    copy.set_defaults(main=update_course)
    doctor = commands.add_parser("doctor", help="check the set-up and say what cures each fault")
    doctor.set_defaults(main=run_doctor)
    progress = commands.add_parser("progress", help="show your points")
    progress.add_argument("--folder", default="course")
    progress.set_defaults(main=show_progress)
    cpp.add_commands(commands)
    slam.add_commands(commands)
    grading.add_commands(commands)
    networking.add_commands(commands)
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


def _folder_of(args: argparse.Namespace) -> Path:
    """The student's copy of the course; `~` is home also where no shell says so, as on Windows."""
    return Path(args.folder).expanduser().resolve()


def _not_written(folder: Path, error: OSError) -> SystemExit:
    """What to say where a copy of the course cannot be written."""
    name = f" ('{error.filename}')" if error.filename else ""
    return SystemExit(
        f"The course cannot be written to '{folder}': {error.strerror}{name}. "
        "Make room there, or choose another folder: coursekit lab --folder ~/course"
    )


def update_course(args: argparse.Namespace) -> int:
    """Make or update the student's copy."""
    from coursekit.grade.copy import Course
    from coursekit.grade.editions import notebooks_folder

    folder = _folder_of(args)
    if why := refusal(folder):
        raise SystemExit(f"{why} Or choose another: coursekit lab --folder ~/course")
    try:
        said = Course(folder).update(notebooks_folder(), args.language)
    except ValueError as error:
        raise SystemExit(str(error)) from None
    except OSError as error:
        raise _not_written(folder, error) from None
    for sentence in said:
        print(f"  {sentence}")
    print(f"Your folder: {folder}")
    return 0


def lab_environment(folder: Path) -> dict[str, str]:
    """The environment of kernels and terminals: the underlay sourced, the course's folders named."""
    from coursekit.jupyter.kernel import write_kernelspec
    from coursekit.packages.environment import source_underlay

    env = with_utf8(os.environ)
    source_underlay(env)
    env["COURSEKIT_COURSE"] = str(folder)
    env["COURSEKIT_WORKSPACE"] = str(folder / "ros2_ws")
    env["JUPYTER_PATH"] = os.pathsep.join(filter(None, [str(write_kernelspec(folder)), env.get("JUPYTER_PATH", "")]))
    return env


def open_lab(args: argparse.Namespace) -> int:
    """Open JupyterLab on the student's copy."""
    from coursekit.grade.copy import Course

    update_course(args)
    folder = _folder_of(args)
    try:
        env, settings = lab_environment(folder), [f"--LabServerApp.app_settings_dir={_settings_folder(folder)}"]
        settings += terminal_settings(folder)
    except OSError as error:
        raise _not_written(folder, error) from None
    command = [
        sys.executable, "-m", "jupyter", "lab",
        f"--ServerApp.root_dir={folder}",
        "--ServerApp.ip=127.0.0.1",
        f"--LabApp.default_url=/lab/tree/{quote(Course(folder).first())}",
        *settings,
    ]  # fmt: skip
    if rights.is_root():
        command.append("--allow-root")
    if args.no_browser or not _has_browser():
        command.append("--no-browser")
        print("Open the address that begins with http://127.0.0.1 below in a browser.")
    command += [word for word in args.jupyter if word != "--"]
    print("SLAM is compiled in the background: the first time this takes a minute or two, and you can begin at once.")
    compile_ahead.start_in_background(env)
    cpp.offer(env)
    return _become(command, env)


def _become(command: list[str], env: dict[str, str]) -> int:
    """Go on as another program, which so gets every signal: who ends us ends it."""
    sys.stdout.flush()
    if sys.platform != "win32":
        os.execve(command[0], command, env)
    try:
        return subprocess.call(command, env=env)  # Windows would give the console back at once
    except KeyboardInterrupt:
        return 0


def _settings_folder(folder: Path) -> Path:
    """Settings of JupyterLab for the course: no news pop-up."""
    settings = folder / ".coursekit" / "lab"
    settings.mkdir(parents=True, exist_ok=True)
    (settings / "overrides.json").write_text(
        '{"@jupyterlab/apputils-extension:notification": {"fetchNews": "false", "checkForUpdates": false}}',
        encoding="utf-8",
    )
    return settings


def _has_browser() -> bool:
    import webbrowser

    if sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        return False
    try:
        webbrowser.get()
    except webbrowser.Error:
        return False
    return True


def run_doctor(args: argparse.Namespace) -> int:
    """Print every check, and the cure for each fault."""
    from coursekit.grade.harmless import counted

    from .checks import run_all

    faults = 0
    for check in run_all():
        mark = "✔" if not check.fault else "!" if check.only_warning else "✘"
        print(f"{mark} {check.name:<11} {check.fault or check.finding}")
        if check.fault:
            print(f"  → {check.cure}")
            faults += not check.only_warning
    cure = "follow the lines with arrows, then run this again."
    print(f"{counted(faults, 'fault')}: {cure}" if faults else "All is well.")
    return 1 if faults else 0


def show_progress(args: argparse.Namespace) -> int:
    """Print the points."""
    os.environ["COURSEKIT_COURSE"] = str(_folder_of(args))
    from coursekit.grade.progress import progress

    print(progress())
    return 0


if __name__ == "__main__":
    sys.exit(main())
