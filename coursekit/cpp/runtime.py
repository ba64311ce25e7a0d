"""The files that every C++ program needs, generated once and cached: the runtime, interface headers, package configs.

`python -m coursekit.cpp.runtime FOLDER` generates them there.
"""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
import tempfile
import time
from functools import cache
from pathlib import Path

from coursekit.cpp.age import age_source, runtime_key
from coursekit.cpp.compiler_facts import keep_facts
from coursekit.cpp.exported import exported_by, version_of_package
from coursekit.cpp.forwarded import write_forwarded
from coursekit.cpp.headers import write_headers
from coursekit.cpp.standard_library import write_visible
from coursekit.cpp.toolchain import Toolchain, cache_folder, find_toolchain, version_of
from coursekit.cpp.unused_runtimes import MAKING, remove_unused
from coursekit.files import in_order, read_bytes
from coursekit.interfaces.find import UNDERLAY, known_interfaces
from coursekit.systems.locks import alone

ROOM = Path(__file__).parent
PACKAGES = (
    "OpenCV", "message_filters", "laser_geometry", "cv_bridge", "image_transport",
    "rclcpp", "rclcpp_action", "rclcpp_components", "rclcpp_lifecycle",
    "rcutils", "rcl", "rcpputils", "rcppmath", "libstatistics_collector", "console_bridge", "tracetools",
    "class_loader", "pluginlib", "rmw",
    "tf2", "tf2_geometry_msgs", "tf2_ros", "tf2_eigen", "rosidl_runtime_cpp",
    "rosbag2_compression", "rosbag2_cpp", "rosbag2_storage",
    "ament_cmake", "ament_cmake_auto", "ament_cmake_ros", "ament_cmake_ros_core", "ament_cmake_core", "ament_cmake_python",
    "ament_cmake_gtest", "ament_cmake_gmock", "ament_cmake_pytest", "ament_cmake_test", "ament_index_cpp",
    "ament_lint_auto", "ament_lint_common", "ament_cmake_copyright", "ament_cmake_cppcheck",
    "ament_cmake_cpplint", "ament_cmake_flake8", "ament_cmake_lint_cmake", "ament_cmake_pep257",
    "ament_cmake_uncrustify", "ament_cmake_xmllint", "launch_testing_ament_cmake", "ros_testing",
    "camera_calibration_parsers", "camera_info_manager", "interactive_markers",
    "control_toolbox", "kdl_parser", "orocos_kdl", "orocos_kdl_vendor", "realtime_tools", "tf2_kdl",
    "urdf", "urdf_parser_plugin", "urdfdom", "urdfdom_headers",
    "pcl_conversions", "pcl_ros",
    "python_cmake_module", "eigen3_cmake_module", "rosidl_default_generators", "rosidl_default_runtime", "rosidl_cmake",
    "rosidl_generator_cpp", "rosidl_typesupport_c", "rosidl_typesupport_cpp", "rosidl_typesupport_interface",
    "rosidl_runtime_c", "rmw_implementation", "rmw_fastrtps_cpp", "rmw_implementation_cmake",
    "rcl_action", "rcl_lifecycle", "rcl_yaml_param_parser", "rttest", "tlsf_cpp",
    "ament_cmake_export_dependencies", "ament_cmake_export_include_directories", "ament_cmake_export_libraries",
    "ament_cmake_export_targets", "ament_cmake_export_definitions", "ament_cmake_export_interfaces",
    "ament_cmake_export_link_flags", "ament_cmake_include_directories", "ament_cmake_libraries",
    "ament_cmake_target_dependencies", "ament_cmake_gen_version_h", "ament_cmake_version", "ament_cmake_nose",
    "ament_cmake_google_benchmark", "ament_cmake_clang_format", "ament_cmake_clang_tidy", "ament_cmake_mypy",
    "ament_cmake_pycodestyle", "ament_cmake_pyflakes",
    "backward_ros", "console_bridge_vendor", "libyaml_vendor", "pybind11_vendor", "spdlog_vendor", "tinyxml2_vendor",
    "tinyxml_vendor", "yaml-cpp", "yaml_cpp_vendor",
    "rosidl_generator_c", "rosidl_generator_py", "rosidl_typesupport_introspection_c",
    "rosidl_typesupport_introspection_cpp",
    "rosidl_typesupport_fastrtps_c", "rosidl_typesupport_fastrtps_cpp", "rcl_logging_interface", "rcl_logging_spdlog",
    "rmw_coursekit", "rmw_cyclonedds_cpp",
    "generate_parameter_library", "parameter_traits", "rsl", "tcb_span", "tl_expected",
    "transmission_interface", "behaviortree_cpp_v3", "nav2_behavior_tree",
)  # fmt: skip
"""The packages found here in addition to those with a folder in the underlay's share."""
_MADE_OF = (".hpp", ".h", ".cpp", ".txt", ".msg", ".srv", ".action", ".py")
SHARED = "COURSEKIT_SHARED"
COMPILER = "compiler"
_CONFIG = """set(_coursekit_name "{name}")
set({name}_VERSION "{version}")
include("${{COURSEKIT_CMAKE}}/underlay.cmake")
foreach(_coursekit_exported {exported})
  if(NOT ${{_coursekit_exported}}_FOUND)
    find_package(${{_coursekit_exported}} QUIET)
  endif()
endforeach()
"""
_VERSION = """set(PACKAGE_VERSION "{version}")
set(PACKAGE_VERSION_COMPATIBLE TRUE)
if(PACKAGE_VERSION AND PACKAGE_VERSION VERSION_LESS PACKAGE_FIND_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE FALSE)
endif()
"""


def runtime_folder(tools: Toolchain) -> Path:
    """Return the runtime folder for these tools, existing or not: one per compiler and version of its sources.

    On a server, the folder named by COURSEKIT_SHARED may contain one for all students.
    """
    name = Path("cpp", _key(tools))
    shared = Path(os.environ.get(SHARED) or cache_folder())
    return shared / name if (shared / name).is_dir() else cache_folder() / name


@cache
def _key(tools: Toolchain) -> str:
    """Hash the compiler's version and all sources: that reads a thousand files, and a build asks several times."""
    seen = hashlib.sha256(version_of(tools.cxx).encode())
    globs = ("interfaces/cpp_*.py", "interfaces/c_*.py", "share/*/*/*", "share/*/package.xml")
    for path in in_order([*_files(ROOM), *(path for glob in globs for path in UNDERLAY.glob(glob))]):
        if path.suffix in _MADE_OF or path.name == "package.xml":
            seen.update(path.relative_to(UNDERLAY).as_posix().encode() + b"\0" + read_bytes(path))
    return seen.hexdigest()[:16]


def _files(folder: Path) -> list[Path]:
    return [path for path in folder.rglob("*") if path.is_file()]


def make_runtime(folder: Path, tools: Toolchain) -> None:
    """Build the runtime in a folder that appears only when complete; subprocess.CalledProcessError if a tool fails.

    Whoever asks meanwhile waits for it: each notebook server that starts would build one, and take all processors.
    """
    folder.parent.mkdir(parents=True, exist_ok=True)
    with alone(folder.parent / "making.lock"):
        if not folder.is_dir():
            remove_unused(folder.parent, time.time())
            _make(folder, tools)


def _make(folder: Path, tools: Toolchain) -> None:
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=MAKING) as name:
        staging = Path(name) / "runtime"
        write_headers(staging / "include", known_interfaces())
        _write_configs(staging)
        write_forwarded(staging / "include")
        (staging / "age.cpp").write_text(age_source(), encoding="utf-8")
        _build_library(staging, Path(name) / "build", tools)
        staging.rename(folder)


def _write_configs(folder: Path) -> None:
    for name in {*PACKAGES, *(path.parent.name for path in UNDERLAY.glob("share/*/package.xml"))}:
        place = folder / "share" / name / "cmake"
        place.mkdir(parents=True)
        exported, version = exported_by(name, UNDERLAY / "share"), version_of_package(name, UNDERLAY / "share")
        config = _CONFIG.format(name=name, version=version, exported=" ".join(exported))
        (place / f"{name}Config.cmake").write_text(config, encoding="utf-8")
        (place / f"{name}ConfigVersion.cmake").write_text(_VERSION.format(version=version), encoding="utf-8")


def _build_library(folder: Path, build: Path, tools: Toolchain) -> None:
    include, prefix = (path.as_posix() for path in (folder / "include", folder))
    told = {"INTERFACES": include, "KEY": runtime_key(), "CMAKE_INSTALL_PREFIX": prefix}
    defines = {**tools.defines(), **told}
    words = [f"-D{name}={value}" for name, value in defines.items()]
    _run(tools.cmake, "-G", tools.generator, "-S", str(ROOM), "-B", str(build), *words)
    _run(tools.cmake, "--build", str(build), "--parallel", str(os.cpu_count() or 1))
    _run(tools.cmake, "--install", str(build))
    if tools.lends_library:
        _lend_library(folder / "lib", tools)
    keep_facts(build, folder / COMPILER)


def _lend_library(folder: Path, tools: Toolchain) -> None:
    try:
        write_visible(folder, tools)
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"C++ programs will load no libraries while they run: {error}", file=sys.stderr)


def _run(*command: str) -> None:
    subprocess.run(command, stdout=sys.stderr, check=True)


def main(words: list[str]) -> int:
    """Run a command line; return the exit code."""
    try:
        make_runtime(Path(words[0]), find_toolchain())
    except subprocess.CalledProcessError as error:
        return error.returncode
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
