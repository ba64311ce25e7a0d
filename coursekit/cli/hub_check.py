"""`coursekit hub-check`: is this server ready for a class, and how many students can it serve?"""

from __future__ import annotations

import argparse
import importlib.metadata
import importlib.util
import os
import shutil
import stat
from collections.abc import Callable
from pathlib import Path

from coursekit.cpp.runtime import SHARED, runtime_folder
from coursekit.cpp.toolchain import NoToolchain, find_toolchain

from .check import Check

KEPT_FREE = 0.2
"""The share of the memory needed by the system and the hub itself."""
HOME_MB = 300
"""The size of a student's home in the course [MB]: builds, bags, maps."""


def hub_package() -> Check:
    """Check for JupyterHub's single-user server, which must be in the same environment as the course."""
    if importlib.util.find_spec("jupyterhub") is None:
        cure = 'Run, with the same Python: pip install "coursekit[hub]"'
        return Check("jupyterhub", "missing", "jupyterhub is not installed beside coursekit", cure)
    version = importlib.metadata.version("jupyterhub")
    return Check("jupyterhub", f"{version} (the hub itself has to have the same first number)")


def compiled_ahead() -> Check:
    """Check the files of `coursekit hub-prepare`."""
    folder = os.environ.get(SHARED)
    if not folder:
        fault = "nothing is compiled ahead: each student's first map and first C++ build take a minute of one core more"
        cure = f"Run: sudo coursekit hub-prepare /srv/coursekit; then {SHARED}=/srv/coursekit coursekit hub-check"
        return Check("compiled", "nothing", fault, cure, only_warning=True)
    missing = [name for name, there in _parts(Path(folder)).items() if not there]
    if not missing:
        return Check("compiled", f"SLAM, the simulator and C++, in {folder}")
    cure = f"Run again: sudo coursekit hub-prepare {folder}"
    return Check("compiled", folder, f"not compiled for this version: {', '.join(missing)}", cure, only_warning=True)


def _parts(folder: Path) -> dict[str, bool]:
    there = {"SLAM": any((folder / "numba").glob("*/*.nbi"))}
    try:
        there["C++"] = runtime_folder(find_toolchain()).is_relative_to(folder)
    except NoToolchain:
        pass  # then C++ is not used here
    return there


def exchange_folder() -> Check:
    """Check the folder through which teachers and students exchange files."""
    from coursekit.grade.exchange import INBOUND, OUTBOUND, VARIABLE

    told = os.environ.get(VARIABLE)
    if not told:
        return Check("exchange", "none: students download what they hand in (docs/hub.md says how to have one)")
    folder = Path(told)
    wrong = [name for name in (OUTBOUND, INBOUND) if not (folder / name).is_dir()]
    if wrong:
        cure = f"Hand something out: coursekit release 00 --exchange {told}"
        return Check("exchange", told, f"it has no folder {' and no '.join(wrong)}", cure, only_warning=True)
    mode = (folder / INBOUND).stat().st_mode
    if mode & stat.S_IROTH or not mode & stat.S_IWOTH:
        what = "see what others handed in" if mode & stat.S_IROTH else "hand nothing in"
        return Check("exchange", told, f"students can {what}", f"Run: chmod 2733 {folder / INBOUND}")
    return Check("exchange", told)


def homes() -> Check:
    """Report the disk space for students' homes, measured at this user's home."""
    free = shutil.disk_usage(Path.home()).free / 1e6
    return Check("homes", f"{free / 1000:.0f} GB free: {free / HOME_MB:.0f} students of {HOME_MB} MB each")


CHECKS: tuple[Callable[[], Check], ...] = (hub_package, compiled_ahead, exchange_folder, homes)


def load(students: int) -> list[Check]:
    """Measure the cost of one student; with a number of students, check whether they fit."""
    import psutil

    from .hub_load import MB, NotMeasured, measure

    try:
        cost = measure()
    except NotMeasured as error:
        return [Check("load", "not measured", str(error), "Run: coursekit doctor")]
    memory = psutil.virtual_memory().total / MB
    fit = int(memory * (1 - KEPT_FREE) / cost.student_mb())
    parts = f"{cost.server_mb:.0f} server, {cost.kernel_mb:.0f} to {cost.busy_mb:.0f} kernel"
    told = f"{cost.student_mb():.0f} MB a student with a simulation ({parts}): {fit} fit into {memory / 1024:.0f} GB"
    need = cost.student_mb() * students / (1 - KEPT_FREE) / 1024
    fault = f"{students} students need {need:.0f} GB" if students > fit else ""
    carried = (os.cpu_count() or 1) / max(cost.cores, 0.01)
    cores = f"{cost.cores:.2f} of a core a student with a simulation: {os.cpu_count()} carry {carried:.0f} at full speed"
    return [
        Check("start", f"server {cost.server_s:.1f} s, kernel {cost.kernel_s:.1f} s"),
        Check("memory", told, fault, "Take a larger server, or let students come in two groups."),
        Check("processor", f"{cores}; with more, simulated time passes more slowly, and all is as right"),
    ]


def run(args: argparse.Namespace) -> int:
    """Print each check, and the remedy for each fault. Returns 1 if there are faults."""
    from .doctor import tell

    return tell([*(check() for check in CHECKS), *load(args.students)])
