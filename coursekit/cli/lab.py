"""`coursekit lab` and `coursekit course`: a student's copy of the course, and JupyterLab on it."""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
from pathlib import Path
from urllib.parse import quote

from coursekit.packages.folder_name import refusal
from coursekit.systems import rights
from coursekit.systems.children import with_utf8
from coursekit.words.gettext import LANGUAGE

from . import compile_ahead, cpp
from .kernel_sockets import kernel_options
from .terminal_settings import terminal_settings

QUIET = ("--ServerApp.log_level=ERROR", "--LabApp.log_level=ERROR")
"""Reduces the server's output to its address; `coursekit lab -- --log-level=INFO` shows everything."""
_SAYS_MORE = re.compile(r"--(debug$|([\w.]+[.])?log[-_]level\b)").match
"""Matches a Jupyter option for the log level, which must not be given twice."""


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the two commands."""
    lab = commands.add_parser("lab", help="open the course in JupyterLab")
    lab.add_argument("--folder", default="course", help="your copy of the course (default: course)")
    lab.add_argument("--language", default="", help="of the course, such as es (default: that of your copy)")
    lab.add_argument("--no-browser", action="store_true", help="print the address instead of opening a browser")
    lab.add_argument("jupyter", nargs=argparse.REMAINDER, help="further options for jupyter lab, after --")
    lab.set_defaults(main=open_lab)
    copy = commands.add_parser("course", help="make or update your copy of the course, without opening it")
    copy.add_argument("--folder", default="course")
    copy.add_argument("--language", default="")
    copy.set_defaults(main=update_course)


def folder_of(args: argparse.Namespace) -> Path:
    """Return the student's copy of the course; expands `~` also where no shell does, as on Windows."""
    return Path(args.folder).expanduser().resolve()


def _not_written(folder: Path, error: OSError) -> SystemExit:
    """Return the error for a copy of the course that cannot be written."""
    name = f" ('{error.filename}')" if error.filename else ""
    return SystemExit(
        f"The course cannot be written to '{folder}': {error.strerror}{name}. "
        "Make room there, or choose another folder: coursekit lab --folder ~/course"
    )


def update_course(args: argparse.Namespace) -> int:
    """Make or update the student's copy."""
    from coursekit.grade.copy import Course
    from coursekit.grade.editions import notebooks_folder

    folder = folder_of(args)
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
    """Return the environment of kernels and terminals, with the underlay, and the course's folders and language."""
    from coursekit.grade.copy import Course
    from coursekit.jupyter.kernel import write_kernelspec
    from coursekit.packages.environment import source_underlay

    env = with_utf8(os.environ)
    source_underlay(env)
    env["COURSEKIT_COURSE"] = str(folder)
    env[LANGUAGE] = Course(folder).language()
    env["COURSEKIT_WORKSPACE"] = str(folder / "ros2_ws")
    env["JUPYTER_PATH"] = os.pathsep.join(filter(None, [str(write_kernelspec(folder)), env.get("JUPYTER_PATH", "")]))
    return env


def lab_options(folder: Path) -> list[str]:
    """Return the options of a Jupyter server on that copy, regardless of who starts it."""
    from jupyter_core.paths import jupyter_runtime_dir

    options = [
        f"--ServerApp.root_dir={folder}",
        f"--LabServerApp.app_settings_dir={_settings_folder(folder)}",
        *terminal_settings(folder),
        *kernel_options(Path(jupyter_runtime_dir())),
    ]
    return [*options, "--allow-root"] if rights.is_root() else options


def first_page(folder: Path) -> str:
    """Return the page with which the course opens."""
    from coursekit.grade.copy import Course

    return f"/lab/tree/{quote(Course(folder).first())}"


def prepare_lab(args: argparse.Namespace) -> tuple[Path, dict[str, str], list[str]]:
    """Update the student's copy. Returns its folder, and a server's environment and options; SystemExit if it cannot."""
    update_course(args)
    folder = folder_of(args)
    try:
        return folder, lab_environment(folder), lab_options(folder)
    except OSError as error:
        raise _not_written(folder, error) from None


def open_lab(args: argparse.Namespace) -> int:
    """Open JupyterLab on the student's copy."""
    folder, env, options = prepare_lab(args)
    command = [sys.executable, "-m", "jupyter", "lab", "--ServerApp.ip=127.0.0.1"]
    command += [f"--LabApp.default_url={first_page(folder)}", *options]
    if args.no_browser or not _has_browser():
        command.append("--no-browser")
        print("Open the address that begins with http://127.0.0.1 below in a browser.")
    own = [word for word in args.jupyter if word != "--"]
    command += [*([] if any(map(_SAYS_MORE, own)) else QUIET), *own]
    print("SLAM is compiled in the background: the first time this takes a minute or two, and you can begin at once.")
    compile_ahead.start_in_background(env)
    cpp.offer(env)
    return become(command, env)


def become(command: list[str], env: dict[str, str]) -> int:
    """Continue as another program, which then receives all signals directly."""
    sys.stdout.flush()
    if sys.platform != "win32":
        os.execve(command[0], command, env)
    try:
        return subprocess.call(command, env=env)  # on Windows, exec would return control to the console at once
    except KeyboardInterrupt:
        return 0


def _settings_folder(folder: Path) -> Path:
    """Write JupyterLab's settings for the course: no news pop-up."""
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
