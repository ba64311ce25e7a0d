"""A check can tell a build that failed or is older than its sources."""

import os
import shutil

import pytest

from coursekit.packages.build_state import build_fault, package_folder
from coursekit.systems import link_copies

from .test_colcon import WORKSPACE, colcon

PACKAGE = "s2_py_pubsub"


@pytest.fixture(scope="module", params=["", "--symlink-install"])
def built_once(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("ws")
    shutil.copytree(WORKSPACE / "src" / PACKAGE, folder / "src" / "group" / PACKAGE)
    assert build(folder, *filter(None, [request.param])).returncode == 0
    return folder


def build(folder, *options):
    return colcon(folder, "build", "--packages-select", PACKAGE, *options)


@pytest.fixture
def workspace(built_once, tmp_path):
    """The package, built; its sources are as they were afterwards."""
    source = built_once / "src" / "group" / PACKAGE
    kept = tmp_path / "kept"
    shutil.copytree(source, kept)
    yield built_once
    shutil.rmtree(source)
    shutil.copytree(kept, source)
    os.utime(built_once / "build" / PACKAGE / "colcon_build.rc")
    (built_once / "build" / PACKAGE / "colcon_build.rc").write_text("0\n")


def change(workspace, path, text="\n"):
    file = workspace / "src" / "group" / PACKAGE / path
    file.parent.mkdir(exist_ok=True)
    with file.open("a") as opened:
        opened.write(text)
    later = (workspace / "build" / PACKAGE / "colcon_build.rc").stat().st_mtime_ns + 10**9
    os.utime(file, ns=(later, later))


def reads_modules_from_source(workspace):
    """As after a build with --symlink-install, by a link or by a note where links are refused."""
    source = workspace / "src" / "group" / PACKAGE / PACKAGE
    noted = link_copies.fresh_sources(workspace / "install" / PACKAGE, PACKAGE)
    return (workspace / "build" / PACKAGE / PACKAGE).is_symlink() or source.resolve() in noted


def test_a_fresh_build_has_no_fault(workspace):
    assert build_fault(workspace, PACKAGE) == ""


@pytest.mark.parametrize("path", ["README.md", "test/test_more.py", ".hidden", f"{PACKAGE}/__pycache__/a.pyc"])
def test_what_no_build_reads_may_change(workspace, path):
    change(workspace, path)
    assert build_fault(workspace, PACKAGE) == ""


def test_rules_of_the_build_may_not_change(workspace):
    change(workspace, "setup.py")
    assert build_fault(workspace, PACKAGE) == f"setup.py of {PACKAGE} was changed after the last build"


def test_a_module_may_change_only_where_it_is_linked(workspace):
    module = next((workspace / "src" / "group" / PACKAGE / PACKAGE).glob("[a-z]*.py")).name
    linked = reads_modules_from_source(workspace)
    change(workspace, f"{PACKAGE}/{module}", "")
    assert build_fault(workspace, PACKAGE) == ""  # touched only
    change(workspace, f"{PACKAGE}/{module}", "# new\n")
    wanted = "" if linked else f"{PACKAGE}/{module} of {PACKAGE} was changed after the last build"
    assert build_fault(workspace, PACKAGE) == wanted


def test_a_build_that_failed_is_told_though_the_old_one_is_installed(workspace):
    change(workspace, "setup.py", "oops(\n")
    assert build(workspace).returncode != 0
    assert build_fault(workspace, PACKAGE).startswith(f"the last build of {PACKAGE} failed")


def test_without_a_build_or_sources_nothing_is_claimed(tmp_path, workspace):
    assert build_fault(tmp_path, PACKAGE) == "" and package_folder(tmp_path, PACKAGE) is None
    assert build_fault(workspace, "other") == ""


def test_what_is_at_work_for_another_exercise_does_not_matter(workspace):
    linked = reads_modules_from_source(workspace)  # then its modules may change without a build
    change(workspace, f"{PACKAGE}/py_other_node.py")
    for of, matters in ((), True), (["py_publisher_node"], False), (["py_other_node"], True):
        assert ("py_other_node.py" in build_fault(workspace, PACKAGE, of)) == (matters and not linked)
    change(workspace, "setup.py")
    assert "setup.py" in build_fault(workspace, PACKAGE, ["py_publisher_node"])
