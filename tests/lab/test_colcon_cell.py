"""`%colcon` in a cell says what colcon says in a terminal, its warnings too."""

import pytest

from coursekit.lab.magics import CourseMagics


@pytest.fixture
def built(session, monkeypatch, tmp_path, capsys):
    """built("WORDS") runs colcon as a cell does, in an empty workspace; what was said."""
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path))

    def run(words):
        CourseMagics().colcon(words)
        said = capsys.readouterr()
        return said.out + said.err

    return run


def test_a_package_that_is_not_there_is_told_by_its_name(built):
    said = built("build --packages-select nonsense")
    assert "ignoring unknown package 'nonsense'" in said and "0 packages finished" in said


def test_nothing_is_said_of_coursekit_s_own_folder(built):
    assert "local_setup" not in built("build")
