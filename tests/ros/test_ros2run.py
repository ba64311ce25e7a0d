"""ros2run.api and ros2pkg.api: what launch files of the demos import."""

import sys
from argparse import Namespace

import pytest
from ros2pkg.api import get_executable_paths, get_package_names, get_prefix_path
from ros2run.api import ExecutableNameCompleter, PackageNotFound, get_executable_path, run_executable

from tests.needs import posix


def test_an_executable_is_found_by_name():
    path = get_executable_path(package_name="demo_nodes_py", executable_name="talker")
    assert path in get_executable_paths(package_name="demo_nodes_py")
    assert path.startswith(get_prefix_path("demo_nodes_py"))


def test_an_executable_that_is_not_there_is_none():
    assert get_executable_path(package_name="demo_nodes_py", executable_name="nobody") is None


def test_a_package_that_is_not_there_is_named():
    assert get_prefix_path("no_such_package") is None and "demo_nodes_py" in get_package_names()
    with pytest.raises(PackageNotFound) as raised:
        get_executable_path(package_name="no_such_package", executable_name="x")
    assert raised.value.package_name == "no_such_package"


@pytest.mark.parametrize(("package", "offered"), [("demo_nodes_py", True), ("no_such_package", False)])
def test_completion_offers_nothing_for_a_package_that_is_not_there(package, offered):
    complete = ExecutableNameCompleter(package_name_key="package_name")
    assert ("talker" in complete("", Namespace(package_name=package))) is offered


@pytest.mark.parametrize(
    ("code", "said"),
    [("sys.exit(len(sys.argv) - 3)", ""), ("sys.exit(7)", "[ros2run]: Process exited with failure 7\n")],
)
def test_an_executable_runs_with_its_arguments_and_tells_a_failure(capfd, code, said):
    returned = run_executable(path=sys.executable, argv=["-c", f"import sys; {code}", "a", "b"])
    assert (returned, capfd.readouterr().out) == (7 if said else 0, said)


@posix("nothing there ends a program by a signal, and it has no env")
def test_a_prefix_stands_before_it_and_a_signal_that_ended_it_is_named(capfd):
    code = "import os, signal; os.kill(os.getpid(), signal.SIGTERM)"
    assert run_executable(path=sys.executable, argv=["-c", code], prefix=["env", "A=1"]) == -15
    assert capfd.readouterr().out == "[ros2run]: Terminated\n"
