"""What every C++ program needs, made once and kept: the runtime's library, the interfaces' headers, the packages' configs.

Run as `python -m coursekit.cpp.runtime FOLDER` it makes them there.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from coursekit.cpp.age import runtime_key
from coursekit.cpp.headers import write_headers
from coursekit.cpp.toolchain import Toolchain, cache_folder, find_toolchain, version_of
from coursekit.files import in_order, read_bytes
from coursekit.interfaces.find import UNDERLAY, known_interfaces

ROOM = Path(__file__).parent
PACKAGES = (
    "OpenCV", "message_filters", "laser_geometry", "cv_bridge", "image_transport",
    "rclcpp", "rclcpp_action", "rclcpp_components", "rclcpp_lifecycle",
    "rcutils", "rcl", "rcpputils", "rcppmath", "libstatistics_collector", "console_bridge", "tracetools", "class_loader", "pluginlib", "rmw",
    "tf2", "tf2_geometry_msgs", "tf2_ros", "tf2_eigen", "rosidl_runtime_cpp", "rosbag2_cpp", "rosbag2_storage",
    "ament_cmake", "ament_cmake_auto", "ament_cmake_ros", "ament_cmake_ros_core", "ament_cmake_core", "ament_cmake_python",
    "ament_cmake_gtest", "ament_cmake_gmock", "ament_cmake_pytest", "ament_cmake_test", "ament_index_cpp",
    "ament_lint_auto", "ament_lint_common", "ament_cmake_copyright", "ament_cmake_cppcheck",
    "ament_cmake_cpplint", "ament_cmake_flake8", "ament_cmake_lint_cmake", "ament_cmake_pep257",
    "ament_cmake_uncrustify", "ament_cmake_xmllint", "launch_testing_ament_cmake", "ros_testing",
    "camera_calibration_parsers", "camera_info_manager", "interactive_markers",
    "urdf", "urdf_parser_plugin", "urdfdom", "urdfdom_headers",
    "python_cmake_module", "eigen3_cmake_module", "rosidl_default_generators", "rosidl_default_runtime", "rosidl_cmake",
    "rosidl_typesupport_cpp",
)  # fmt: skip
"""What packages find here beside those that have a folder in the underlay's share."""
NOT_COMPILED = {
    "controller_interface", "gazebo_plugins", "gazebo_ros", "hardware_interface", "nav2_util", "tf2_kdl",
}  # fmt: skip
"""Packages that come with coursekit, but without the C++ that others would include."""
FORWARDED = {
    "rclcpp/rclcpp.hpp": (
        "allocator/allocator_deleter any_service_callback contexts/default_context create_client "
        "create_generic_publisher create_generic_subscription create_publisher create_service create_subscription "
        "create_timer executor_options executors/multi_threaded_executor executors/single_threaded_executor "
        "executors/static_executor_entities_collector executors/static_single_threaded_executor generic_publisher "
        "generic_subscription init_options intra_process_buffer_type intra_process_setting is_ros_compatible_type "
        "loaned_message message_info node_impl node_interfaces/get_node_base_interface "
        "node_interfaces/get_node_parameters_interface node_interfaces/get_node_timers_interface "
        "node_interfaces/get_node_topics_interface node_interfaces/node_base node_interfaces/node_clock "
        "node_interfaces/node_clock_interface node_interfaces/node_graph node_interfaces/node_graph_interface "
        "node_interfaces/node_logging node_interfaces/node_logging_interface node_interfaces/node_parameters "
        "node_interfaces/node_parameters_interface node_interfaces/node_services node_interfaces/node_services_interface "
        "node_interfaces/node_time_source node_interfaces/node_time_source_interface node_interfaces/node_timers "
        "node_interfaces/node_timers_interface node_interfaces/node_topics node_interfaces/node_topics_interface "
        "node_interfaces/node_waitables node_interfaces/node_waitables_interface parameter_service publisher_base "
        "publisher_factory qos_overriding_options serialization subscription_base subscription_content_filter_options "
        "subscription_factory subscription_options subscription_traits subscription_wait_set_mask topic_statistics_state "
        "type_support_decl wait_result wait_result_kind wait_set_policies/dynamic_storage "
        "wait_set_policies/sequential_synchronization wait_set_policies/static_storage "
        "wait_set_policies/thread_safe_synchronization wait_set_template"
    ),
    "rclcpp/exceptions.hpp": "exceptions/exceptions",
    "rclcpp/memory_strategy.hpp": "memory_strategies strategies/message_pool_memory_strategy",
    "coursekit/visibility.hpp": (
        "/ament_index_cpp/visibility_control.h /message_filters/visibility_control.h /rclcpp_action/visibility_control.hpp "
        "/rclcpp_components/visibility_control.hpp /rcpputils/visibility_control.hpp /rcutils/visibility_control.h "
        "/rcl/visibility_control.h /rmw/visibility_control.h /tf2/visibility_control.h /tf2_ros/visibility_control.h /urdf/visibility_control.hpp"
    ),
    "rclcpp_action/types.hpp": "qos",
    "rcutils/types.h": (
        "/rcl/macros.h /rmw/ret_types.h types/char_array.h types/rcutils_ret.h types/string_array.h types/uint8_array.h"
    ),
    "rcutils/format_string.h": "snprintf.h",
    "rcutils/env.h": "get_env.h",
    "rcutils/macros.h": "/rmw/macros.h",
    "rcpputils/env.hpp": "get_env",
    "rclcpp/qos_event.hpp": "/rmw/incompatible_qos_events_statuses.h /rmw/events_statuses/events_statuses.h",
    "rclcpp/topic_endpoint_info.hpp": "/rmw/topic_endpoint_info.h",
    "rosidl_typesupport_cpp/message_type_support.hpp": (
        "/rosidl_runtime_cpp/message_type_support_decl.hpp /rosidl_runtime_cpp/service_type_support_decl.hpp "
        "/rosidl_runtime_c/message_type_support_struct.h"
    ),
    "tf2/LinearMath/Quaternion.h": "LinearMath/QuadWord.h",
    "tf2/buffer_core_interface.h": "buffer_core_interface.hpp",
    "tf2/time_cache.h": "time_cache.hpp",
    "tf2_ros/buffer.h": "async_buffer_interface.h create_timer_interface.h",
    "message_filters/connection.h": "signal1.h signal9.h parameter_adapter.h",
    "ament_index_cpp/get_package_prefix.hpp": "get_search_paths",
    "libstatistics_collector/moving_average_statistics/moving_average.hpp": "moving_average_statistics/types",
    "pluginlib/class_loader.hpp": "class_desc",
}
"""Headers whose names are Humble's: by the header that has what is in them, in its package where none is named."""
SHARED = "COURSEKIT_SHARED"
_CONFIG = 'set(_coursekit_name "{name}")\ninclude("${{COURSEKIT_CMAKE}}/underlay.cmake")\n'


def runtime_folder(tools: Toolchain) -> Path:
    """Where the runtime for these tools is, or will be: one for each compiler and each version of what it is made of.

    On a server it may stand ready for all students in the folder that COURSEKIT_SHARED names.
    """
    seen = hashlib.sha256(version_of(tools.cxx).encode())
    for path in in_order([*_files(ROOM), *UNDERLAY.glob("interfaces/cpp_*.py"), *UNDERLAY.glob("share/*/*/*")]):
        if path.suffix in (".hpp", ".h", ".cpp", ".txt", ".msg", ".srv", ".action", ".py"):
            seen.update(path.relative_to(UNDERLAY).as_posix().encode() + b"\0" + read_bytes(path))
    name = Path("cpp", seen.hexdigest()[:16])
    shared = Path(os.environ.get(SHARED) or cache_folder())
    return shared / name if (shared / name).is_dir() else cache_folder() / name


def _files(folder: Path) -> list[Path]:
    return [path for path in folder.rglob("*") if path.is_file()]


def make_runtime(folder: Path, tools: Toolchain) -> None:
    """Make the runtime in a folder that appears when it is whole; subprocess.CalledProcessError where a tool fails."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=".making-") as name:
        made = Path(name) / "runtime"
        write_headers(made / "include", known_interfaces())
        _write_configs(made)
        _write_forwarded(made / "include")
        _build_library(made, Path(name) / "build", tools)
        try:
            made.rename(folder)
        except OSError:  # another build was quicker
            if not folder.is_dir():
                raise


def _write_configs(folder: Path) -> None:
    for name in {*PACKAGES, *(path.parent.name for path in UNDERLAY.glob("share/*/package.xml"))} - NOT_COMPILED:
        path = folder / "share" / name / "cmake" / f"{name}Config.cmake"
        path.parent.mkdir(parents=True)
        path.write_text(_CONFIG.format(name=name), encoding="utf-8")


def _write_forwarded(folder: Path) -> None:
    for target, names in FORWARDED.items():
        package = target.partition("/")[0]
        for name in names.split():
            file = name if "." in name else f"{name}.hpp"
            path = folder / file[1:] if file.startswith("/") else folder / package / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f'#pragma once\n#include "{target}"\n', encoding="utf-8")


def _build_library(folder: Path, build: Path, tools: Toolchain) -> None:
    include, prefix = (one.as_posix() for one in (folder / "include", folder))
    told = {"INTERFACES": include, "KEY": runtime_key(), "CMAKE_INSTALL_PREFIX": prefix}
    defines = {**tools.defines(), **told}
    words = [f"-D{name}={value}" for name, value in defines.items()]
    _run(tools.cmake, "-G", tools.generator, "-S", str(ROOM), "-B", str(build), *words)
    _run(tools.cmake, "--build", str(build), "--parallel", str(os.cpu_count() or 1))
    _run(tools.cmake, "--install", str(build))
    for path in build.glob("CMakeFiles/*/CMake*Compiler.cmake"):
        kept = folder / "compiler" / path.parent.name
        kept.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, kept)


def _run(*command: str) -> None:
    subprocess.run(command, stdout=sys.stderr, check=True)


def main(words: list[str]) -> int:
    """Carry out a command line; its exit code."""
    try:
        make_runtime(Path(words[0]), find_toolchain())
    except subprocess.CalledProcessError as error:
        return error.returncode
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
