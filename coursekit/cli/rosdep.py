"""The command `rosdep`, as used in tutorials before `colcon build`: checks the dependencies of a folder's packages.

It installs nothing. What coursekit provides is already there; for the rest it prints what to do.
"""

from __future__ import annotations

import argparse
import importlib.metadata
import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from ament_index_python import get_packages_with_prefixes
from catkin_pkg.package import InvalidPackage, Package
from catkin_pkg.packages import find_packages

from coursekit.processes.unavailable_packages import remark
from coursekit.systems.streams import use_utf8

_FOR_CPP = re.compile(
    r"ament_\w+|(rcl|rcutils|rmw|rosidl|class_loader|pluginlib|launch_testing_ament)\w*|lib\w[\w.+-]*|eigen\w*|boost|\w+-dev|qt[\w-]*"
    r"|tf2_eigen|cmake|pkg-config|ros_environment|message_generation|\w+_vendor|backward_ros|google_benchmark_vendor|urdf"
    r"|python_cmake_module|osrf_\w+|ros_testing|rviz_(common|rendering|default_plugins)|rosbag2_(cpp|storage\w*)"
    r"|realtime_tools|control_toolbox|generate_parameter_library|parameter_traits|rsl|tl_expected|tcb_span|fmt|transmission_interface"
    r"|behaviortree_cpp_v3|nav2_behavior_tree|pcl_(ros|conversions)"
)
"""Keys needed only for compiling or checking, which is not done here."""
_COLLECTIONS = {"ros_core", "ros_base", "desktop", "desktop_full", "gazebo_ros_pkgs", "python3-colcon-common-extensions"}
"""Keys of package collections, of which coursekit has the parts that can be run."""
_DISTRIBUTIONS = {"opencv": "opencv-python-headless", "yaml": "pyyaml", "pil": "pillow", "pykdl": "PyKDL"}


def main(argv: Sequence[str] | None = None) -> int:
    """Run `rosdep init|update|check|install|keys ...`. Returns 1 if something is missing."""
    use_utf8()
    args = _parser().parse_args(argv)
    if args.verb in ("init", "update"):
        print(f"rosdep {args.verb}: nothing to do, coursekit knows what it has. Go on with: rosdep install --from-paths src")
        return 0
    try:
        needed = _needed(args)
    except (InvalidPackage, OSError, RuntimeError) as error:
        print(f"ERROR: {error}", file=sys.stderr)
        return 1
    if args.verb == "keys":
        print(*sorted(needed), sep="\n")
        return 0
    missing = {key: users for key, users in needed.items() if not is_there(key)}
    if not missing:
        print("All system dependencies have been satisfied" if args.verb == "check" else _DONE)
        return 0
    return _tell(missing)


_DONE = "#All required rosdeps installed successfully"


def is_there(key: str) -> bool:
    """Whether a dependency is met: by a package, by an installed Python library, or because nothing is compiled.

    >>> is_there("rclpy"), is_there("python3-numpy"), is_there("rclcpp"), is_there("nope_msgs")
    (True, True, True, False)
    """
    if key in get_packages_with_prefixes() or key in _COLLECTIONS or _FOR_CPP.fullmatch(key):
        return True
    name = re.sub(r"^python3?-|-pip$", "", key)
    try:
        importlib.metadata.version(_DISTRIBUTIONS.get(name, name))
    except (importlib.metadata.PackageNotFoundError, ValueError):
        return key in ("python3", "python3-dev", "python3-pytest")
    return name != key


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="rosdep", description="Checks that there is what packages need.")
    parser.add_argument("verb", choices=("init", "update", "check", "install", "keys"))
    parser.add_argument("packages", nargs="*", help="packages; none: those of --from-paths")
    parser.add_argument("-i", "--ignore-src", "--ignore-packages-from-source", action="store_true")
    parser.add_argument("--from-paths", "--from-path", nargs="+", default=[], metavar="PATH")
    parser.add_argument("--skip-keys", action="append", default=[], metavar="KEYS")
    parser.add_argument("--rosdistro", default="humble")
    for flag in ("-y --default-yes", "-r", "-q --quiet", "-v --verbose", "-s --simulate", "--include-eol-distros"):
        parser.add_argument(*flag.split(), action="store_true", help="accepted; nothing is installed")
    return parser


def _needed(args: argparse.Namespace) -> dict[str, list[str]]:
    """Return each key with the packages that need it; packages in the folders themselves count as present."""
    packages: dict[str, Package] = {}
    for path in args.from_paths:
        if not Path(path).is_dir():
            raise RuntimeError(f"given path '{path}' does not exist")
        packages |= {package.name: package for package in find_packages(path).values()}
    asked = [packages[name] for name in args.packages if name in packages] if args.packages else list(packages.values())
    skipped = {key for words in args.skip_keys for key in words.split()} | set(packages)
    needed: dict[str, list[str]] = {key: [] for key in args.packages if key not in packages}
    for package in asked:
        for key in _keys(package):
            if key not in skipped:
                needed.setdefault(key, []).append(package.name)
    return needed


def _keys(package: Package) -> set[str]:
    package.evaluate_conditions({**os.environ, "ROS_VERSION": "2", "ROS_DISTRO": "humble"})
    kinds = ("build", "buildtool", "build_export", "buildtool_export", "exec", "test")
    every = [dependency for kind in kinds for dependency in getattr(package, f"{kind}_depends")]
    return {dependency.name for dependency in every if dependency.evaluated_condition}


def _tell(missing: dict[str, list[str]]) -> int:
    print("ERROR: the following packages/stacks could not have their rosdep keys resolved\nto system dependencies:")
    for key, users in sorted(missing.items()):
        print(f"{', '.join(sorted(users)) or 'asked for'}: Cannot locate rosdep definition for [{key}]", file=sys.stderr)
        print(f"  {_cure(key)}", file=sys.stderr)
    return 1


def _cure(key: str) -> str:
    if key.startswith("python"):
        name = re.sub(r"^python3?-|-pip$", "", key)
        return f"If a node imports it, install it beside coursekit: python3 -m pip install {name}"
    return remark(key) or "A ROS package: put its source into the src folder of your workspace. Else: look at its spelling."
