"""Copies that ask for values of their own: drawn with a secret, written in, and judged by those that the teacher draws."""

import json
from pathlib import Path

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade.checking import check
from coursekit.grade.copy import Course
from coursekit.grade.exercise import find
from coursekit.grade.handing_in import make_bundle
from coursekit.grade.mark import mark
from coursekit.grade.roster import Roster
from coursekit.grade.sandbox import Limits
from coursekit.grade.submissions import Submission
from coursekit.grade.variants import Variants, declared, personal, told
from coursekit.grade.verdict import CheckFailed
from coursekit.grade.work import Work
from tests.needs import is_private

from .handed import WALLS, rows
from .kinds import solution_cells

NOTEBOOKS = Path(__file__).resolve().parents[2] / "notebooks"
SOURCES = {path.name: json.loads(path.read_text(encoding="utf-8")) for path in sorted(NOTEBOOKS.glob("*.ipynb"))}
DECLARED = {name: file for file, source in SOURCES.items() for name in declared(source)}
CLASS = Roster(["Ann Lee", "Ben Ito", *(f"Student {number}" for number in range(40))])


def part(exercise):
    """A notebook with the cells of one exercise, which need no others."""
    source, name = SOURCES[DECLARED[exercise]], exercise.replace(".", "-")
    cells = source["cells"]
    last = next(
        at for at, cell in enumerate(cells) if cell["metadata"].get("nbgrader", {}).get("grade_id") == f"{name}-check"
    )
    first = max(at for at in range(last) if "## Exercise" in "".join(cells[at]["source"]))
    return {**source, "cells": [cells[1], *cells[first : last + 1]]}


def text_of(notebook):
    return "\n".join("".join(cell["source"]) for cell in notebook["cells"])


def graded(folder, source, answers, exercise, seconds=60):
    """The mark of a notebook, judged as that of the student whose copy `source` is."""
    folder.mkdir()
    (folder / "part.ipynb").write_text(json.dumps(answers))
    return mark(Submission(folder.name, folder), {"part.ipynb": source}, {exercise: find(exercise)}, Limits(seconds=seconds))


def test_at_least_two_exercises_have_variants():
    assert len(DECLARED) >= 2


def test_the_values_are_the_secret_s_and_the_student_s():
    source = SOURCES["03_services.ipynb"]
    drawn = [Variants(CLASS, b"one").of(student, source) for student in CLASS.students]
    assert drawn == [Variants(CLASS, b"one").of(student, source) for student in CLASS.students]
    assert drawn != [Variants(CLASS, b"two").of(student, source) for student in CLASS.students]
    assert len({values["ch03.q3"]["boxes"] for values in drawn}) > 10


@pytest.mark.parametrize("exercise", DECLARED)
def test_each_value_stands_in_the_text_and_in_the_solution_and_nowhere_else(exercise):
    source = part(exercise)
    choices = declared(source)[exercise]
    own = {name: options[-1] for name, options in choices.items()}
    nb = personal(source, {exercise: own})
    assert told(nb)[exercise] == own and declared(nb) == {}
    described, solution = text_of({"cells": nb["cells"][1:2]}), text_of({"cells": list(solution_cells(nb).values())})
    for name, options in choices.items():
        before, now = (value if isinstance(value, str) else repr(value) for value in (options[0], own[name]))
        assert now in described and now in solution, name
        assert f"{before} " not in described, name


def test_other_exercises_stay_as_they_are():
    source = SOURCES["03_services.ipynb"]
    nb = personal(source, {"ch03.q3": {"boxes": 33}})
    pairs = zip(source["cells"], nb["cells"], strict=True)
    changed = [new for old, new in pairs if "".join(old["source"]) != "".join(new["source"])]
    assert len(changed) == 3 and all("33" in text_of({"cells": [cell]}) for cell in changed)
    assert 'check("ch03.q3", boxes=33)' in text_of(nb)


@pytest.mark.parametrize("exercise", ["ch01.q3", "ch05.q2"])
def test_solutions_earn_all_points_under_every_variant_and_a_classmate_s_none(tmp_path, exercise):
    source = part(exercise)
    copies = [
        Variants(CLASS, secret).copies(student, {"part": source})["part"]
        for secret, student in ((b"a", "Ann Lee"), (b"a", "Ben Ito"), (b"b", "Ann Lee"))
    ]
    assert len({text_of(nb) for nb in copies}) == 3
    for number, copy in enumerate(copies):
        marked = graded(tmp_path / f"own{number}", copy, copy, exercise)
        assert marked.verdicts[0].passed, marked.verdicts[0].text()
        assert marked.variants == {exercise: told(copy)[exercise]}
    copied = graded(tmp_path / "copied", copies[1], copies[0], exercise).verdicts[0]
    assert not copied.passed and copied.expected


@pytest.mark.slow
@pytest.mark.timeout(200)
def test_a_node_s_own_number_is_judged_too(tmp_path):
    source = SOURCES["03_services.ipynb"]
    copies = [personal(source, {"ch03.q3": {"boxes": boxes}}) for boxes in (17, 23)]
    assert graded(tmp_path / "own", copies[0], copies[0], "ch03.q3", 120).total() == 2
    copied = graded(tmp_path / "copied", copies[1], copies[0], "ch03.q3", 120).verdicts[0]
    assert copied.points < 1 and "23 more" in copied.expected


def test_a_check_of_a_copy_judges_with_its_own_values(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path))
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))
    file = tmp_path / "ros2_ws" / "src" / "s5_py_camera" / "config" / "fleet.yaml"
    file.parent.mkdir(parents=True)
    copy = personal(part("ch05.q2"), {"ch05.q2": {"gate": "dock", "width": 480}})
    lines = "".join(solution_cells(copy)["ch05-q2"]["source"]).splitlines()[1:]
    file.write_text("\n".join(line for line in lines if "###" not in line))
    check("ch05.q2", gate="dock", width=480)
    with pytest.raises(CheckFailed):
        check("ch05.q2")
    assert "camera.width 320" in capsys.readouterr().out


def test_values_keep_the_type_that_the_judge_expects():
    work = Work({}, Path())
    work.variants = {"x": 3, "name": 7}
    assert (work.variant("x", 2.5), work.variant("name", "bob"), work.variant("y", 4)) == (3.0, "bob", 4)
    assert type(work.variant("x", 2.5)) is float


@pytest.fixture
def handed_out(tmp_path, capsys):
    """A class of two with copies of one exercise."""
    (tmp_path / "notebooks").mkdir()
    (tmp_path / "notebooks" / "05_part.ipynb").write_text(json.dumps(part("ch05.q2")))
    (tmp_path / "students.txt").write_text("Ann Lee\nBen Ito\n")
    command = ["release", "05", "--notebooks", str(tmp_path / "notebooks"), "--variants", str(tmp_path / "students.txt")]
    assert main([*command, "--out", str(tmp_path / "week5")]) == 0
    files = [Path(line).name for line in capsys.readouterr().out.splitlines()[:3]]
    assert files == ["AnnLee.zip", "BenIto.zip", "copies.csv"]
    return tmp_path


def test_a_release_has_a_copy_for_each_student_and_the_secret_stays_with_the_teacher(handed_out):
    secret = handed_out / "students.secret"
    assert is_private(secret)
    texts = {name: (handed_out / "week5" / name / "05_part.ipynb").read_text() for name in ("AnnLee", "BenIto")}
    assert texts["AnnLee"] != texts["BenIto"]
    for text in texts.values():
        assert "SOLUTION" not in text and secret.read_text().strip() not in text
        assert declared(json.loads(text)) == {} and told(json.loads(text))["ch05.q2"]
    course = Course(handed_out / "week5" / "AnnLee")
    (said,) = course.update(handed_out / "notebooks")
    assert said.startswith("Here already: 05_part.ipynb.")
    assert not list((handed_out / "week5" / "AnnLee").glob("*.new.ipynb"))


@WALLS
def test_grading_draws_the_values_again_and_believes_no_copy(handed_out, capsys):
    students = handed_out / "students.txt"
    variants = Variants.read(students)
    for student, folder in (("Ann Lee", "AnnLee_05"), ("Ann Lee", "BenIto"), ("Ann Lee", "nobody")):
        nb = variants.copies(student, {"part": part("ch05.q2")})["part"]
        (handed_out / "class" / folder).mkdir(parents=True)
        (handed_out / "class" / folder / "05_part.ipynb").write_text(json.dumps(nb))
    command = ["grade", str(handed_out / "class"), "--notebooks", str(handed_out / "notebooks"), "--allow-root"]
    out = ["--out", str(handed_out / "grades.csv")]
    assert main([*command, *out, "--variants", str(students)]) == 1, "whose `nobody` is was asked"
    totals = {name: row["total"] for name, row in rows(handed_out / "grades.csv").items()}
    assert totals == {"Ann Lee": "2", "Ben Ito": "0"}
    assert "no student in the list" in (handed_out / "questions.csv").read_text(encoding="utf-8-sig")
    assert main([*command, *out]) == 0
    assert rows(handed_out / "grades.csv")["AnnLee_05"]["total"] == "0"


def test_what_was_handed_in_is_run_with_the_values_of_its_copy_and_verified_with_the_teacher_s(handed_out, capsys):
    students, ann = handed_out / "students.txt", handed_out / "ann" / "05_part.ipynb"
    ann.parent.mkdir()
    ann.write_text(json.dumps(Variants.read(students).copies("Ann Lee", {"part": part("ch05.q2")})["part"]))
    file, marked = make_bundle(ann, ann.parent, "Ann Lee", ann.parent, handed_out / "notebooks")
    assert marked.total() == 2
    command = ["verify", str(file), "--notebooks", str(handed_out / "notebooks")]
    assert main([*command, "--variants", str(students)]) == 0
    assert main(command) == 1
    assert "ch05.q2: 2 points are recorded, a clean run earns 0" in capsys.readouterr().out


@WALLS
def test_a_missing_secret_is_said(handed_out):
    (handed_out / "students.secret").unlink()
    with pytest.raises(SystemExit, match="There is no .*students.secret"):
        main(["grade", "--allow-root", str(handed_out), "--variants", str(handed_out / "students.txt")])
