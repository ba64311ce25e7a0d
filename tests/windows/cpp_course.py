"""A package in C++ for another computer than this one: zig compiles it, CMake installs it as `colcon build` has it done."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from coursekit.cpp.compiler_facts import reuse_facts
from coursekit.cpp.runtime import COMPILER, make_runtime, runtime_folder
from coursekit.cpp.toolchain import NoToolchain, Toolchain, cross_toolchain
from coursekit.packages.cmake_build import completed, initial_cache

CMAKE = """
cmake_minimum_required(VERSION 3.16)
project(far)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)
foreach(program {programs})
  add_executable(${{program}} ${{program}}.cpp)
  ament_target_dependencies(${{program}} rclcpp std_msgs)
endforeach()
install(TARGETS {programs} DESTINATION lib/${{PROJECT_NAME}})
ament_package()
"""
PACKAGE = """<package format="3"><name>far</name><version>0.1.0</version><description>Far</description>
<maintainer email="a@b.cd">A</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<depend>rclcpp</depend><depend>std_msgs</depend><export><build_type>ament_cmake</build_type></export></package>"""


def tools_for(target: str) -> Toolchain:
    """zig's tools with their runtime made, which takes minutes the first time; a test without them is skipped."""
    try:
        tools = cross_toolchain(target)
    except NoToolchain as error:
        pytest.skip(str(error))
    if not runtime_folder(tools).is_dir():
        make_runtime(runtime_folder(tools), tools)
    return tools


def install(folder: Path, tools: Toolchain, programs: dict[str, str]) -> Path:
    """Build the programs, texts by name, as a package `far`; the prefix that it is installed in."""
    source, build, prefix = folder / "src", folder / "build", folder / "install"
    write(source, programs)
    known = reuse_facts(runtime_folder(tools) / COMPILER, build)
    cache = initial_cache(build, prefix, tools)
    _run(tools, "-G", tools.generator, "-C", cache, *known, f"-DCMAKE_INSTALL_PREFIX={prefix}", "-S", source, "-B", build)
    _run(tools, "--build", build)
    _run(tools, "--install", build)
    return prefix


def write(source: Path, programs: dict[str, str]) -> None:
    """Write the package's files."""
    source.mkdir(parents=True)
    for name, text in programs.items():
        (source / f"{name}.cpp").write_text(text, encoding="utf-8")
    (source / "CMakeLists.txt").write_text(CMAKE.format(programs=" ".join(programs)), encoding="utf-8")
    (source / "package.xml").write_text(PACKAGE, encoding="utf-8")


def _run(tools: Toolchain, *words: str | Path) -> None:
    env = completed(dict(os.environ), tools)
    done = subprocess.run([tools.cmake, *map(str, words)], env=env, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def why_no_wine() -> str:
    """Why programs of Windows cannot be run here; empty where they can."""
    from tests.windows import wine

    if not shutil.which("wine"):
        return "there is no Wine (Debian: apt-get install wine64)"
    return "" if wine.PYTHON.is_file() else "Wine has no Python yet: python -m tests.windows setup"
