"""The checks of `coursekit doctor` and `ros2 doctor`: each reports the fault and the command that fixes it."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import os
import platform
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from socket import if_nameindex

from coursekit.cpp.toolchain import NoToolchain, find_toolchain
from coursekit.interfaces.find import UNDERLAY
from coursekit.systems import shell_spelling

from .check import Check
from .system_checks import run_system_checks

Lines = list[tuple[str, str | int]]
"""Names and values in a section of the report."""


def python_version() -> Check:
    """Report the Python version; versions older than 3.10 (Humble's own) are refused at installation."""
    version = platform.python_version()
    return Check("python", version)


def which_rclpy() -> Check:
    """Whether rclpy is coursekit's or a real ROS 2's."""
    spec = importlib.util.find_spec("rclpy")
    if spec is None or spec.origin is None:
        return Check("rclpy", "missing", "rclpy cannot be imported", "Run: pip install --force-reinstall coursekit")
    ours = Path(spec.origin).is_relative_to(UNDERLAY)
    if ours:
        return Check("rclpy", "coursekit's")
    return Check(
        "rclpy",
        f"a real ROS 2 ({spec.origin})",
        "a real ROS 2 is sourced or installed, so that one is used here",
        "That is fine on a robot. For the course, open a terminal in which no setup.bash was sourced.",
        only_warning=True,
    )


def kernel_version() -> Check:
    """Check ipykernel: version 7.4 stalls widgets while a cell runs."""
    return _version("ipykernel", (7, 0), (7, 4), shell_spelling.install("ipykernel>=7.0,<7.4"))


def setuptools_version() -> Check:
    """Check setuptools: version 80 breaks `colcon build --symlink-install`."""
    return _version("setuptools", (30,), (80,), shell_spelling.install("setuptools<80"))


def widgets() -> Check:
    """Check the packages used by terminals, pads and views."""
    missing = [name for name in ("ipywidgets", "anywidget", "jupyterlab") if importlib.util.find_spec(name) is None]
    if not missing:
        return Check("widgets", "installed")
    return Check("widgets", "incomplete", f"not installed: {', '.join(missing)}", f"Run: pip install {' '.join(missing)}")


def colcon() -> Check:
    """Check the build tool."""
    if importlib.util.find_spec("colcon_core") is not None:
        return Check("colcon", _installed("colcon-core") or "installed")
    return Check("colcon", "missing", "colcon is not installed", "Run: pip install colcon-core colcon-ros")


def cpp_tools() -> Check:
    """Check the compiler for C++ packages."""
    try:
        tools = find_toolchain()
    except NoToolchain as error:
        return Check("C++", f"{error}; `coursekit cpp` gets them, and the course needs none")
    return Check("C++", f"{' '.join(tools.cxx)}, {tools.cmake}, {tools.generator}")


def socket_folder() -> Check:
    """Check the folder in which terminals find the session."""
    from coursekit.systems.runtime_folder import choose

    try:
        folder, faults = choose()
    except OSError as error:
        return Check("terminals", "unsafe", str(error), "Follow the line above, then start again.")
    finding = f"sessions are found in {folder}"
    if not faults:
        return Check("terminals", finding)
    cure = f"Nothing: {folder} is used instead, by notebooks and terminals alike."
    return Check("terminals", finding, "; ".join(faults), cure, only_warning=True)


def session_of_domain() -> Check:
    """Check whether a session answers."""
    from .session_client import domain_id, who_answers

    try:
        name, count = who_answers()
    except OSError:
        return Check("session", f"none runs for ROS_DOMAIN_ID={domain_id()}; `ros2` starts one when it needs it")
    others = f", the one of {count} in which a cell was run last" if count > 1 else ""
    return Check("session", f"one runs for ROS_DOMAIN_ID={domain_id()}: {name or 'without a notebook'}{others}")


def disk_space() -> Check:
    """Check the disk space for builds and maps."""
    free = shutil.disk_usage(os.getcwd()).free / 1e9
    if free > 0.2:
        return Check("disk", f"{free:.1f} GB free")
    return Check("disk", f"{free:.2f} GB free", "the disk is nearly full", "Delete build/ and log/ of old workspaces.")


CHECKS: tuple[Callable[[], Check], ...] = (
    python_version,
    which_rclpy,
    kernel_version,
    widgets,
    colcon,
    cpp_tools,
    setuptools_version,
    socket_folder,
    session_of_domain,
    disk_space,
)


def run_all() -> list[Check]:
    """Run all checks, in order."""
    return [*(check() for check in CHECKS), *run_system_checks()]


def report() -> Iterator[tuple[str, Lines]]:
    """Yield sections of (name, value) lines for `ros2 doctor --report`."""
    yield "NETWORK CONFIGURATION", [("device", f"{name} (messages stay on this computer)") for _, name in if_nameindex()]
    yield (
        "PLATFORM INFORMATION",
        [
            ("system", platform.system()),
            ("platform info", platform.platform()),
            ("release", platform.release()),
            ("processor", platform.processor() or platform.machine()),
        ],
    )
    yield "RMW MIDDLEWARE", [("middleware name", "rmw_coursekit")]
    yield (
        "ROS 2 INFORMATION",
        [
            ("distribution name", os.environ.get("ROS_DISTRO", "humble")),
            ("distribution type", "ros2"),
            ("distribution status", "active"),
            ("release platforms", "{'debian': ['bullseye'], 'rhel': ['8'], 'ubuntu': ['jammy']}"),
            ("domain id", os.environ.get("ROS_DOMAIN_ID", "0")),
        ],
    )
    yield "COURSEKIT", [(check.name, check.finding) for check in run_all()]


def _installed(distribution: str) -> str | None:
    try:
        return importlib.metadata.version(distribution)
    except importlib.metadata.PackageNotFoundError:
        return None


def _version(name: str, least: tuple[int, ...], below: tuple[int, ...], cure: str) -> Check:
    version = _installed(name)
    if version is None:
        return Check(name, "missing", f"{name} is not installed", f"Run: {cure}")
    numbers = tuple(int(part) for part in version.split(".")[:2] if part.isdecimal())
    if least <= numbers < below:
        return Check(name, version)
    wanted = f"{'.'.join(map(str, least))} or newer, and older than {'.'.join(map(str, below))}"
    return Check(name, version, f"version {version} is installed, {wanted} is needed", f"Run: {cure}")
