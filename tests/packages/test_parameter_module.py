"""generate_parameter_module(): colcon builds the Python module of a YAML file of parameters into a package."""

from __future__ import annotations

import pytest

from tests.needs import ON_WINDOWS, compiler_or_skip
from tests.packages.test_cpp_workspace import colcon, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
MANIFEST = """<?xml version="1.0"?>
<package format="3"><name>k_arm</name><version>0.1.0</version><description>An arm.</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license>
<depend>generate_parameter_library{python}</depend><export><build_type>ament_{kind}</build_type></export></package>
"""
SETUP = """import sys
from setuptools import setup

if len(sys.argv) >= 2 and sys.argv[1] != "clean":
    from generate_parameter_library_py.setup_helper import generate_parameter_module
    generate_parameter_module("arm_parameters", "k_arm/arm.yaml", validation_module="k_arm.checks")
setup(name="k_arm", version="0.1.0", packages=["k_arm"],
      data_files=[("share/ament_index/resource_index/packages", ["resource/k_arm"]), ("share/k_arm", ["package.xml"])],
      entry_points={"console_scripts": ["arm = k_arm.arm:main"]})
"""
CMAKE = """
cmake_minimum_required(VERSION 3.16)
project(k_arm)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_python REQUIRED)
find_package(generate_parameter_library REQUIRED)
generate_parameter_module(arm_parameters k_arm/arm.yaml k_arm.checks)
ament_python_install_package(${PROJECT_NAME})
install(PROGRAMS k_arm/arm.py DESTINATION lib/${PROJECT_NAME} RENAME arm)
ament_package()
"""
ARM = """#!/usr/bin/env python3
import rclpy
from k_arm.arm_parameters import arm


def main():
    rclpy.init()
    params = arm.ParamListener(rclpy.create_node("arm")).get_params()
    print(params.joints, params.pid.get_entry("hip").p)


if __name__ == "__main__":
    main()
"""
FILES = {
    "setup.cfg": "[develop]\nscript_dir=$base/lib/k_arm\n[install]\ninstall_scripts=$base/lib/k_arm\n",
    "resource/k_arm": "",
    "k_arm/__init__.py": "",
    "k_arm/arm.py": ARM,
    "k_arm/checks.py": "def short(param):\n    return 'too long' if len(param.value) > 2 else ''\n",
    "k_arm/arm.yaml": """arm:
  joints: {type: string_array, default_value: [hip, knee], validation: {"custom_validators::short": null}}
  pid: {__map_joints: {p: {type: double, default_value: 2.5}}}
""",
}


def workspace(folder, more):
    for name, text in (FILES | more).items():
        file = folder / "src" / "k_arm" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def built_and_run(folder, *words):
    built = colcon(folder, "build", *words)
    assert built.returncode == 0, built.stdout + built.stderr
    made = [path for top in ("install", "build") for path in (folder / top).rglob("k_arm/arm_parameters.py")]
    assert made, "beside the package's own modules"
    if ON_WINDOWS:
        pytest.skip("Windows: bash sources the workspace")
    return sourced(folder, "ros2 run k_arm arm && ros2 run k_arm arm --ros-args -p joints:='[a, b, c]'")


def assert_told(result):
    assert result.stdout.splitlines() == ["['hip', 'knee'] 2.5", "[ros2run]: Process exited with failure 1"], result.stderr
    assert "Invalid value set during initialization for parameter joints: too long" in result.stderr


@pytest.mark.parametrize("words", [[], ["--symlink-install"], ["--merge-install"]], ids=["copied", "linked", "merged"])
def test_setup_py_makes_it(words, tmp_path):
    workspace(tmp_path, {"setup.py": SETUP, "package.xml": MANIFEST.format(python="_py", kind="python")})
    assert_told(built_and_run(tmp_path, *words))


@pytest.mark.parametrize("more", ["", "string(TOUPPER a B)\n"], ids=["read", "CMake itself"])
def test_a_cmake_package_has_it(more, tmp_path):
    if more:
        compiler_or_skip()
    workspace(tmp_path, {"CMakeLists.txt": CMAKE + more, "package.xml": MANIFEST.format(python="", kind="cmake")})
    assert_told(built_and_run(tmp_path))


def test_a_wrong_file_is_told_with_its_line(tmp_path):
    wrong = {"k_arm/arm.yaml": "arm: {rate: {type: float}}", "package.xml": MANIFEST.format(python="", kind="cmake")}
    workspace(tmp_path, {"CMakeLists.txt": CMAKE, **wrong})
    built = colcon(tmp_path, "build")
    assert built.returncode == 1 and "CMakeLists.txt:7" in built.stderr and "Invalid parameter type `float`" in built.stderr
