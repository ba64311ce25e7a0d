"""Set-up cells make room without deleting what a student made."""

import pytest

from coursekit.lab.backup_folders import set_aside
from coursekit.lab.errors import NotThere
from coursekit.lab.magics import edit


@pytest.fixture
def course(tmp_path, monkeypatch):
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path))
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def package(course, text, name="ros2_ws/src/mine"):
    (course / name / "inner").mkdir(parents=True)
    (course / name / "inner" / "node.py").write_text(text)


def kept(course):
    return {path.parent.parent.name: path.read_text() for path in sorted((course / "kept").rglob("node.py"))}


def test_a_package_that_is_in_the_way_is_kept_and_it_is_said_where(course, capsys):
    package(course, "one")
    set_aside("src/mine")
    assert capsys.readouterr().out == "src/mine was there already. It is kept: kept/mine-1\n"
    assert not (course / "ros2_ws/src/mine").exists() and kept(course) == {"mine-1": "one"}
    assert (course / "kept" / "COLCON_IGNORE").exists()


def test_the_first_time_nothing_is_said(course, capsys):
    set_aside("src/mine", "src/other")
    assert capsys.readouterr().out == "" and not (course / "kept").exists()


def test_what_changed_is_kept_too_and_what_is_the_same_only_once(course, capsys):
    for text in ("one", "two", "two"):
        package(course, text)
        set_aside("src/mine")
    assert kept(course) == {"mine-1": "one", "mine-2": "two"}
    assert capsys.readouterr().out.count("kept/mine-2") == 2


def test_what_cells_wrote_into_it_is_forgotten_so_that_an_edit_of_the_new_one_is_not_taken_for_made(course):
    package(course, "scripts: [")
    edit("src/mine/inner/node.py", "[", "[ first,")
    edit("src/mine/inner/node.py", "first,", "first, second,")
    set_aside("src/mine")
    package(course, "scripts: [")
    with pytest.raises(NotThere):
        edit("src/mine/inner/node.py", "first,", "first, second,")
    edit("src/mine/inner/node.py", "[", "[ first,")
    assert (course / "ros2_ws/src/mine/inner/node.py").read_text() == "scripts: [ first,"


def test_a_folder_beside_the_notebook_is_found_and_like_names_are_not_mixed(course):
    package(course, "bag", "said")
    package(course, "other", "said-2")
    set_aside("said-2", "said")
    assert kept(course) == {"said-1": "bag", "said-2-1": "other"}
