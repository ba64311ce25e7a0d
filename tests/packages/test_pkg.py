"""`ros2 pkg`: packages are made, listed and shown."""

import argparse
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import pytest
from catkin_pkg.package import parse_package

from coursekit.cli.verbs import pkg
from coursekit.processes.executables import executables_of, packages
from tests.needs import slashed


@pytest.fixture
def ros2_pkg(tmp_path, monkeypatch, capsys):
    """Run `ros2 pkg ...` in an empty folder; return exit code, stdout and stderr."""
    monkeypatch.chdir(tmp_path)
    parser = argparse.ArgumentParser()
    pkg.register(parser.add_subparsers())

    def run(*words):
        args = parser.parse_args(["pkg", *words])
        code = args.main(args)
        captured = capsys.readouterr()
        return code, slashed(captured.out), slashed(captured.err)

    return run


PEOPLE = ("--maintainer-name", "Nobody", "--maintainer-email", "nobody@nowhere.com")


def test_a_python_package_is_made_step_by_step(ros2_pkg, tmp_path):
    code, out, _ = ros2_pkg(
        "create", "p", "--build-type", "ament_python", "--node-name", "n", "--license", "Apache-2.0",
        "--dependencies", "rclpy", "std_msgs", "--description", "about", *PEOPLE,
    )  # fmt: skip
    assert code == 0
    assert out.splitlines() == [
        "going to create a new package",
        "package name: p",
        f"destination directory: {slashed(tmp_path)}",
        "package format: 3",
        "version: 0.0.0",
        "description: about",
        "maintainer: ['Nobody <nobody@nowhere.com>']",
        "licenses: ['Apache-2.0']",
        "build type: ament_python",
        "dependencies: ['rclpy', 'std_msgs']",
        "node_name: n",
        "creating folder ./p",
        "creating ./p/package.xml",
        "creating source folder",
        "creating folder ./p/p",
        "creating ./p/setup.py",
        "creating ./p/setup.cfg",
        "creating folder ./p/resource",
        "creating ./p/resource/p",
        "creating ./p/p/__init__.py",
        "creating folder ./p/test",
        "creating ./p/test/test_copyright.py",
        "creating ./p/test/test_flake8.py",
        "creating ./p/test/test_pep257.py",
        "creating ./p/p/n.py",
    ]
    assert (tmp_path / "p" / "LICENSE").read_text().strip().startswith("Apache License")


def test_a_cmake_package_is_made_step_by_step(ros2_pkg):
    code, out, _ = ros2_pkg(
        "create", "c", "--node-name", "n", "--library-name", "l", "--license", "MIT", *PEOPLE
    )
    assert code == 0
    assert out.splitlines()[-8:] == [
        "creating source and include folder",
        "creating folder ./c/src",
        "creating folder ./c/include/c",
        "creating ./c/CMakeLists.txt",
        "creating ./c/src/n.cpp",
        "creating ./c/include/c/l.hpp",
        "creating ./c/src/l.cpp",
        "creating ./c/include/c/visibility_control.h",
    ]


@pytest.mark.parametrize("build_type", ["ament_python", "ament_cmake", "cmake"])
def test_the_manifest_is_valid(ros2_pkg, tmp_path, build_type):
    ros2_pkg(
        "create",
        "p",
        "--build-type",
        build_type,
        "--description",
        "a < b & c",
        "--dependencies",
        "rclpy",
        *PEOPLE,
    )
    package = parse_package(str(tmp_path / "p"))
    assert (package.name, package.get_build_type()) == ("p", build_type)
    assert ElementTree.parse(tmp_path / "p" / "package.xml").findtext("description") == "a < b & c"
    assert [d.name for d in package.exec_depends] == ["rclpy"]


def test_made_python_is_valid_python(ros2_pkg, tmp_path):
    ros2_pkg(
        "create", "p", "--build-type", "ament_python", "--node-name", "n", "--library-name", "lib",
        "--description", "it's \"quoted\" \\", "--maintainer-name", "O'Hara", "--maintainer-email", "a@b.cd",
    )  # fmt: skip
    for path in (tmp_path / "p").rglob("*.py"):
        compile(path.read_text(), str(path), "exec")
    shown = subprocess.run(
        [sys.executable, "setup.py", "--maintainer"],
        cwd=tmp_path / "p",
        capture_output=True,
        encoding="utf-8",
        check=True,
    )
    assert shown.stdout.splitlines()[-1] == "O'Hara"


def test_an_unknown_license_is_said(ros2_pkg):
    _, out, _ = ros2_pkg("create", "p", "--license", "Mine", *PEOPLE)
    assert (
        "[WARNING]: Unknown license 'Mine'.  This has been set in the package.xml, but no LICENSE file" in out
    )
    assert out.endswith("MIT\nMIT-0\n")
    assert ros2_pkg("create", "q", "--license", "?")[1].startswith("Supported licenses:\nApache-2.0\n")


def test_refusals(ros2_pkg):
    assert ros2_pkg("create", "p", *PEOPLE)[0] == 0
    code, out, error = ros2_pkg("create", "p", *PEOPLE)
    assert (code, out) == (1, "") and error.startswith("\nAborted!\nThe directory already exists: ./p\n")
    code, _, error = ros2_pkg("create", "test", "--build-type", "ament_python")
    assert code == 1 and error.startswith("Aborted since 'ament_python' packages can't be named 'test'.")
    assert ros2_pkg("create", "1 x")[0] == 1


def test_a_node_named_as_the_library_is_renamed(ros2_pkg):
    _, out, error = ros2_pkg("create", "p", "--node-name", "a", "--library-name", "a", *PEOPLE)
    assert "node_name: a_node\n" in out and "renaming node to a_node" in error


def test_packages_are_listed_and_shown(ros2_pkg):
    code, out, _ = ros2_pkg("list")
    names = out.splitlines()
    assert code == 0 and names == sorted(names) and "std_msgs" in names
    prefix = ros2_pkg("prefix", "std_msgs")[1].strip()
    assert ros2_pkg("prefix", "--share", "std_msgs")[1].strip() == f"{prefix}/share/std_msgs"
    assert ros2_pkg("xml", "std_msgs", "-t", "name")[1] == "std_msgs\n"
    assert "<name>std_msgs</name>" in ros2_pkg("xml", "std_msgs")[1]


def test_executables_are_listed(ros2_pkg, tmp_path, monkeypatch):
    for name in ("share/ament_index/resource_index/packages/mine", "lib/mine/b_exe", "lib/mine/a_exe"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("")
        (tmp_path / name).chmod(0o755)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    assert ros2_pkg("executables", "mine")[1] == "mine a_exe\nmine b_exe\n"
    assert ros2_pkg("executables", "mine", "--full-path")[1].splitlines()[0] == slashed(
        str(tmp_path / "lib/mine/a_exe")
    )


def test_all_that_can_be_run_is_listed_also_where_an_install_has_dropped_the_right_to_execute(ros2_pkg):
    assert "parameter_blackboard" in ros2_pkg("executables", "demo_nodes_cpp")[1]
    listed = [tuple(line.split()) for line in ros2_pkg("executables")[1].splitlines()]
    assert listed == [(name, path.name) for name in packages() for path in executables_of(name)]


def test_unknown_packages_and_tags_fail(ros2_pkg):
    assert ros2_pkg("prefix", "std_msg") == (1, "", "Package not found; did you mean 'std_msgs'?\n")
    assert ros2_pkg("xml", "nope")[0] == 1
    assert ros2_pkg("xml", "std_msgs", "--tag", "nope") == (1, "", "XML tag not found\n")
    assert ros2_pkg("executables", "nope")[2].startswith("Package 'nope' not found")


def test_setup_py_asks_for_pytest_as_humble_s_template_does(ros2_pkg, tmp_path):
    ros2_pkg("create", "p", "--build-type", "ament_python", *PEOPLE)
    text = (tmp_path / "p" / "setup.py").read_text(encoding="utf-8")
    assert "    license='TODO: License declaration',\n    tests_require=['pytest'],\n    entry_points={\n" in text
