"""Which names are whole, and which one a course keeps."""

import pytest

from coursekit.grade.student_name import keep_name, keep_own_name, kept_name, whole_name


@pytest.mark.parametrize("name", ["Vera de la Course", "Gerard 't Hooft", "J.-P. O'Neill", "山田太郎", "김민준", "สมชาย"])
def test_names_of_all_scripts_are_whole(name):
    assert whole_name(name) == name


@pytest.mark.parametrize("name", ["Suharto -", "- Suharto", "Suharto —"])
def test_a_dash_stands_for_a_name_that_a_person_does_not_have(name):
    assert whole_name(name) == "Suharto"


@pytest.mark.parametrize("name", ["", " ", "Vera", "-", "- -", "Vera 7", "7", "木", "123456", "Иван", "..."])
def test_others_are_not(name):
    assert whole_name(name) == ""


def test_a_name_given_in_brackets_is_kept_before_the_exercise_s(tmp_path):
    assert kept_name(tmp_path / "course") == ""
    for name in ("Vera Curse", "Vera Course"):
        keep_own_name(tmp_path / "course", name)
        assert kept_name(tmp_path / "course") == name
    keep_name(tmp_path / "course", "Ann Lee")
    keep_own_name(tmp_path / "course", "Vera Course")
    assert kept_name(tmp_path / "course") == "Ann Lee"
