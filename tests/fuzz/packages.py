"""Packages, launch files, parameters and arguments."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from .format import TEXT, XML, YAML, Faults, Format, values_only


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="surrogateescape")


def _cmake(path: Path) -> Any:
    from coursekit.packages.cmake_text import read_commands

    return read_commands(path)


def _cmake_faults() -> Faults:
    from coursekit.packages.cmake_text import CMakeError

    return (CMakeError,)


CMAKE = b"""cmake_minimum_required(VERSION 3.8)
project(demo)
find_package(ament_cmake REQUIRED)
set(FILES "a b" c;d) # a list
if(BUILD_TESTING AND NOT (WIN32 OR "${X}" MATCHES "^a.*$"))
  foreach(one IN LISTS FILES)
    message(STATUS "${one} $ENV{HOME} \\" [[x]]")
  endforeach()
endif()
install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME} PATTERN "*.pyc" EXCLUDE)
ament_package()
"""


def _dsv(path: Path) -> Any:
    from coursekit.packages.overlay import overlay_environment

    with tempfile.TemporaryDirectory() as folder:
        for place in ("share/colcon-core/packages/demo", "share/demo/package.dsv"):
            Path(folder, place).parent.mkdir(parents=True, exist_ok=True)
        Path(folder, "share/colcon-core/packages/demo").write_bytes(b"demo:other")
        Path(folder, "share/demo/package.dsv").write_bytes(path.read_bytes())
        return overlay_environment(Path(folder), {"PATH": "/bin"})


DSV = b"""source;share/demo/hook/a.dsv
prepend-non-duplicate;PATH;bin
set;NAME;value
set-if-unset;A;b
source;share/demo/x.sh
"""


def _launch(path: Path) -> Any:
    from launch import LaunchContext
    from launch.launch_description_sources import AnyLaunchDescriptionSource

    return AnyLaunchDescriptionSource(str(path)).get_launch_description(LaunchContext())


def _launch_faults() -> Faults:
    from launch.invalid_launch_file_error import InvalidLaunchFileError

    return (InvalidLaunchFileError,)


LAUNCH_XML = b"""<launch><arg name="a" default="1" description="x"/><let name="b" value="$(var a)"/>
<node pkg="demo_nodes_py" exec="talker" name="t" namespace="$(var b)" output="screen" if="$(eval 1+1)">
<param name="x" value="2"/>
<remap from="chatter" to="other"/></node><group scoped="false"><push-ros-namespace namespace="c"/><executable cmd="echo hi"/>
</group><include file="$(find-pkg-share demo_nodes_py)/none.xml"><arg name="z" value="1"/></include></launch>"""
LAUNCH_YAML = b"""launch:
- arg: {name: a, default: "1"}
- node: {pkg: demo_nodes_py, exec: talker, name: t, param: [{name: x, value: 2}], remap: [{from: chatter, to: other}]}
- group: [{push_ros_namespace: {namespace: c}}, {executable: {cmd: echo hi}}]
- include: {file: $(find-pkg-share demo_nodes_py)/none.yaml, arg: [{name: z, value: "1"}]}
"""


def _substitution(path: Path) -> Any:
    from launch.frontend.parse_substitution import parse_substitution

    return parse_substitution(_text(path))


def _substitution_faults() -> Faults:
    from lark.exceptions import LarkError
    from launch.substitutions import SubstitutionFailure

    return RuntimeError, SubstitutionFailure, ValueError, TypeError, LarkError


def _parameters(path: Path) -> Any:
    from coursekit.rcl import parameter_file

    return parameter_file.read(path)


def _parameters_faults() -> Faults:
    from coursekit.rcl.parameter_file import ParameterFileError

    return ParameterFileError, OSError


PARAMETERS = b"""/**:
  ros__parameters: {use_sim_time: true, a.b: 1.5, list: [1, 2], "text": "x"}
/ns/node:
  ros__parameters:
    nested: {deep: [a, b], empty: []}
    number: 0x1F
"""


def _struct(path: Path) -> Any:
    from coursekit.cpp.parameter_header import parameter_header
    from coursekit.cpp.parameter_library import read_parameters

    return parameter_header(read_parameters(path))


def _module(path: Path) -> Any:
    from generate_parameter_library_py.generate_python_module import python_module

    from coursekit.cpp.parameter_library import read_parameters

    return compile(python_module(read_parameters(path)), path.name, "exec")


def _struct_faults() -> Faults:
    from coursekit.cpp.parameter_library import ParameterFileError

    return ParameterFileError, OSError


STRUCT = b"""arm:
  joints: {type: string_array, default_value: [a, b], description: "Its joints", validation: {unique<>: null, size_gt<>: 0}}
  rate: {type: double, default_value: 50.0, read_only: true, validation: {bounds<>: [1.0, 1000.0]}}
  frame: {type: string_fixed_20, default_value: base, validation: {one_of<>: [[base, map]]}}
  gains: {__map_joints: {p: {type: double, default_value: 1.0}, limits: {low: {type: int_array_fixed_2}}}}
"""


def _arguments(path: Path) -> Any:
    from coursekit.rcl.arguments import parse_ros_arguments

    return parse_ros_arguments(["program", *_text(path).split(" ")])


def _arguments_faults() -> Faults:
    from coursekit.rcl.arguments import RosArgumentsError

    return (RosArgumentsError,)


ARGUMENTS = b"--ros-args -r chatter:=/other -r node:__node:=x -p a:=[1,2] -p n:b.c:=text --log-level n:=debug -e /e --"


FORMATS = (
    Format("CMakeLists.txt", ".txt", lambda: CMAKE, _cmake, _cmake_faults, TEXT),
    Format("dsv", ".dsv", lambda: DSV, _dsv, values_only, TEXT),
    Format("launch XML", ".launch.xml", lambda: LAUNCH_XML, _launch, _launch_faults, XML),
    Format("launch YAML", ".launch.yaml", lambda: LAUNCH_YAML, _launch, _launch_faults, YAML),
    Format("substitutions", ".txt", lambda: b"$(var a)/x $(env HOME 'b c') $(eval '1 + $(var b)') \\$(x)", _substitution,
           _substitution_faults, TEXT),
    Format("parameter file", ".yaml", lambda: PARAMETERS, _parameters, _parameters_faults, YAML),
    Format("generate_parameter_library", ".yaml", lambda: STRUCT, _struct, _struct_faults, YAML),
    Format("generate_parameter_module", ".yaml", lambda: STRUCT, _module, _struct_faults, YAML),
    Format("ROS arguments", ".txt", lambda: ARGUMENTS, _arguments, _arguments_faults, TEXT),
)  # fmt: skip
