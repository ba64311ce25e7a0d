"""`coursekit hub-lab`, `hub-prepare` and `hub-check`: the course on a JupyterHub (docs/hub.md)."""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

from coursekit.cpp.runtime import SHARED
from coursekit.cpp.toolchain import NoToolchain, cache_folder, find_toolchain

from . import compile_ahead, hub_check
from .lab import become, first_page, prepare_lab

FOLDER = "~/course"
"""A student's copy of the course, in the student's home."""
NUMBA = "numba"
"""The subfolder for Numba's compiled code, in the shared folder and in the student's cache."""


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command that the hub starts, and those of its administrator."""
    lab = commands.add_parser("hub-lab", help="the course for one student of a JupyterHub, which starts it (docs/hub.md)")
    lab.add_argument("--folder", default=FOLDER, help=f"the student's copy (default: {FOLDER})")
    lab.add_argument("--language", default="", help="of the course, such as es (default: that of the copy)")
    lab.add_argument("words", nargs="*", help="after --: another program, or options of the hub's")
    lab.set_defaults(main=run_lab)
    prepare = commands.add_parser("hub-prepare", help="compile once, for all students of a server, what each would compile")
    prepare.add_argument("folder", type=Path, help="where students can read, such as /srv/coursekit")
    prepare.set_defaults(main=run_prepare)
    check = commands.add_parser("hub-check", help="is this server ready for a class, and how many students does it carry?")
    check.add_argument("--students", type=int, default=0, help="how many will work at the same time")
    check.set_defaults(main=hub_check.run)


def run_lab(args: argparse.Namespace) -> int:
    """Update the student's copy, and continue as the server that the hub expects."""
    if args.words[:1] == ["coursekit"]:  # both an image's entry point and a hub's command may contain it
        return become([sys.executable, "-m", "coursekit.cli.coursekit", *args.words[1:]], dict(os.environ))
    folder, env, options = prepare_lab(args)
    for sentence in fetch_releases(folder):
        print(f"  {sentence}")
    env.setdefault("JUPYTERHUB_DEFAULT_URL", first_page(folder))
    take_compiled(env)
    words = list(args.words)
    if words and not words[0].startswith("-"):  # Binder specifies the server
        return become([shutil.which(words[0]) or words[0], *words[1:], *options], env)
    return become([sys.executable, "-m", "jupyterhub.singleuser", *options, *words], env)


def fetch_releases(folder: Path) -> list[str]:
    """Copy the releases in the server's exchange into the student's copy. Returns a list of the actions taken."""
    from coursekit.grade.copy import Course
    from coursekit.grade.exchange import VARIABLE, releases

    exchange = os.environ.get(VARIABLE)
    said = []
    for released in releases(Path(exchange)) if exchange else []:
        try:
            said += Course(folder).take(released)
        except OSError as error:
            said.append(f"{released.name} could not be fetched ({error.strerror}: '{error.filename}')")
    return said


def take_compiled(env: dict[str, str]) -> None:
    """Give the student a copy of the shared Numba cache: Numba uses only writable caches."""
    shared = Path(env.get(SHARED) or "", NUMBA)
    if not env.get(SHARED) or not shared.is_dir():
        return
    own = cache_folder() / NUMBA
    shutil.copytree(shared, own, dirs_exist_ok=True)
    env["NUMBA_CACHE_DIR"] = str(own)


def run_prepare(args: argparse.Namespace) -> int:
    """Compile SLAM and the simulator, and the C++ runtime if there is a compiler."""
    folder = args.folder.resolve()
    try:
        (folder / NUMBA).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise SystemExit(f"'{folder}' cannot be written ({error.strerror}): name another folder, or use sudo.") from None
    env = {**os.environ, "NUMBA_CACHE_DIR": str(folder / NUMBA), "COURSEKIT_CACHE": str(folder)}
    print("Compiling SLAM and the simulator: a minute or two.", flush=True)
    status = subprocess.call([sys.executable, "-m", compile_ahead.__name__], env=env)
    try:
        find_toolchain()
    except NoToolchain:
        print("There is no C++ compiler here. If students are to write C++: coursekit cpp, then this command again.")
    else:
        status = status or subprocess.call([sys.executable, "-m", "coursekit.cli.coursekit", "cpp"], env=env)
    if not status:
        print(f"Ready. The hub's configuration gives students this variable: {SHARED}={folder}")
    return status
