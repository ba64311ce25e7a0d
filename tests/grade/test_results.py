"""Kept results count as long as all that they depend on is the same, and only if this account wrote them."""

import json

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import batch, marking_progress, results, teacher_secrets
from coursekit.grade.sandbox import Limits
from coursekit.grade.verdict import Verdict
from tests.needs import is_private

from .handed import SERVICES, TOPICS, cheap_mark, grade, rows, text, write


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A class of two; `folder.marked` is who was marked."""
    (tmp_path / "class").mkdir()
    marked = []

    def marks(submission, *more):
        marked.append(submission.student)
        return cheap_mark(submission, *more)

    monkeypatch.setattr(batch, "mark", marks)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    write(tmp_path / "class" / "Ann" / TOPICS, text("q1"))
    write(tmp_path / "class" / "Ben" / TOPICS, text("q1", "q2"))
    return tmp_path / "class", marked


def again(folder, *words):
    """Grade; who was marked, the reference aside."""
    place, marked = folder
    marked.clear()
    grade(place, *words)
    return sorted(student for student in marked if "reference" not in student)


def test_a_second_run_marks_nobody_and_gives_the_same(folder):
    place, marked = folder
    assert again(folder) == ["Ann", "Ben"]
    before = (place.parent / "grades.csv").read_bytes()
    assert again(folder) == [] and not marked and (place.parent / "grades.csv").read_bytes() == before


def test_what_a_mark_depends_on_makes_it_anew(folder, monkeypatch):
    place, _ = folder
    again(folder)
    write(place / "Ann" / TOPICS, text("q1", "q2"))
    assert again(folder) == ["Ann"]
    for name, value in (("judges_digest", lambda: "other"), ("coursekit_version", lambda: "9")):
        monkeypatch.setattr(results, name, value)
        assert again(folder) == ["Ann", "Ben"] and again(folder) == []
    with monkeypatch.context() as lesser:
        lesser.setattr("coursekit.grade.sandbox.tier", lambda: "limits")
        assert again(folder, "--unsafe") == ["Ann", "Ben"]
    again(folder)
    notebooks = place.parent / "notebooks"
    source = json.loads(text("q1", "q2", "q3", "q4"))
    write(notebooks / TOPICS, json.dumps(source))
    assert again(folder, "--notebooks", notebooks) == ["Ann", "Ben"]
    assert again(folder, "--notebooks", notebooks) == []
    source["cells"].append({"cell_type": "code", "metadata": {}, "source": "1", "outputs": []})
    write(notebooks / TOPICS, json.dumps(source))
    assert again(folder, "--notebooks", notebooks) == ["Ann", "Ben"]


def test_why_marks_are_made_anew_is_told(folder, monkeypatch, capsys):
    place, _ = folder
    again(folder)
    assert "made anew" not in capsys.readouterr().out
    monkeypatch.setattr(results, "judges_digest", lambda: "other")
    again(folder)
    assert "! 02_topics: 2 kept marks were made anew, since the code that marks has changed." in capsys.readouterr().out
    write(place / "Ann" / TOPICS, text("q1", "q2"))
    again(folder)
    assert "02_topics: 1 kept mark was made anew, since other work was handed in." in capsys.readouterr().out


def test_again_marks_those_who_are_named_or_everybody(folder):
    again(folder)
    assert again(folder, "--again", "Ben") == ["Ben"]
    assert again(folder, "--again") == ["Ann", "Ben"]
    with pytest.raises(SystemExit, match=r"no student 'Zoe'. There are: Ann, Ben"):
        again(folder, "--again", "Zoe")


def test_chapters_are_marked_one_by_one(folder):
    place, _ = folder
    write(place / "Ann" / SERVICES, text("q1", chapter=SERVICES))
    assert again(folder, "--chapters", "02") == ["Ann", "Ben"]
    assert again(folder, "--chapters", "02", "03") == ["Ann"]
    assert [name for name in rows(place.parent / "grades.csv")["Ben"] if name.startswith("ch03")]
    assert again(folder, "--chapters", "03") == []
    assert not [name for name in rows(place.parent / "grades.csv")["Ben"] if name.startswith("ch02")]
    book = rows(place.parent / "grades" / "gradebook.csv")
    assert (book["Ann"]["02_topics"], book["Ann"]["03_services"], book["Ben"]["02_topics"]) == ("1", "1", "3")
    assert book["Ben"]["03_services"] == ""


def changed(file, change):
    result = json.loads(file.read_text())
    change(result)
    file.write_text(json.dumps(result))


FORGERIES = {
    "points": lambda one: one["payload"]["chapters"][TOPICS]["marked"]["verdicts"][0].update(points=1.0),
    "its seal": lambda one: one.update(hmac="0" * 64),
    "no seal": lambda one: one.pop("hmac"),
    "nonsense": lambda one: one.update(payload=[1]),
    "what it depends on": lambda one: one["payload"]["chapters"][TOPICS]["depends"].update(tier="x"),
}


@pytest.mark.parametrize("what", FORGERIES)
def test_a_result_that_somebody_changed_is_told_and_marked_again(folder, what, capsys):
    place, _ = folder
    again(folder)
    (file,) = (place.parent / "grades" / "results").glob("ben-*/result.json")
    before = rows(place.parent / "grades.csv")
    changed(file, FORGERIES[what])
    capsys.readouterr()
    assert again(folder) == ["Ben"] and "was changed, or is not of this account" in capsys.readouterr().out
    assert rows(place.parent / "grades.csv") == before


def test_another_s_result_under_one_s_own_name_is_none(folder):
    place, _ = folder
    again(folder)
    kept = place.parent / "grades" / "results"
    ((ann,), (ben,)) = (list(kept.glob(f"{name}-*/result.json")) for name in ("ann", "ben"))
    ann.write_bytes(ben.read_bytes())
    assert again(folder) == ["Ann"] and rows(place.parent / "grades.csv")["Ann"]["total"] == "1"


def test_the_secret_is_the_account_s_alone(folder):
    again(folder)
    file = teacher_secrets.config_folder() / "marks.key"
    assert is_private(file)
    file.chmod(0o644)
    assert again(folder) == [] and is_private(file)
    file.unlink()
    assert again(folder) == ["Ann", "Ben"]


def test_a_result_is_an_honest_seal_over_its_payload(folder):
    place, _ = folder
    again(folder)
    (file,) = (place.parent / "grades" / "results").glob("ann-*/result.json")
    result = json.loads(file.read_text())
    assert result["hmac"] == teacher_secrets.mac(teacher_secrets.own_key(), result["payload"]) and is_private(file)


def test_a_grader_that_is_broken_marks_nobody(folder, monkeypatch, capsys):
    place, marked = folder

    def broken(submission, sources, exercises, *more):
        marked.append(submission.student)
        marks = cheap_mark(submission, sources, exercises, *more)
        marks.verdicts = [
            Verdict(exercise.name, exercise.title, 0, exercise.points, "a node", "none") for exercise in exercises.values()
        ]
        return marks

    monkeypatch.setattr(batch, "mark", broken)
    assert main(["grade", "--allow-root", str(place), "--out", str(place.parent / "grades.csv")]) == 2
    said = capsys.readouterr().out
    assert "The grader is broken: the reference solution of 02_topics.ipynb gets 0 of 7 points" in said
    assert marked == ["the reference solution"] and not (place.parent / "grades.csv").exists()
    monkeypatch.setattr(batch, "mark", cheap_mark)
    assert grade(place)[0] == 0


def test_the_reference_is_marked_once_and_only_for_the_chapters_that_are_marked(folder):
    place, marked = folder
    grade(place, "--chapters", "02")
    assert marked.count("the reference solution") == 1
    grade(place, "--chapters", "02")
    assert marked.count("the reference solution") == 1


def test_the_class_s_secret_makes_the_chance_of_the_judges(folder, monkeypatch):
    place, _ = folder
    seen = []

    def marks(submission, sources, exercises, limits, secret=b""):
        assert isinstance(limits, Limits)
        seen.append(secret)
        return cheap_mark(submission, sources, exercises, limits)

    monkeypatch.setattr(batch, "mark", marks)
    grade(place)
    grade(place, "--again")
    assert len(set(seen)) == 1 and len(seen[0]) == 32


def test_ctrl_c_keeps_what_was_marked_and_writes_the_table(folder, monkeypatch):
    place, _ = folder

    def stop(number, of, student):
        raise KeyboardInterrupt

    monkeypatch.setattr(marking_progress.Bar, "__call__", lambda self, *facts: stop(*facts))
    out = place.parent / "grades.csv"
    assert main(["grade", "--allow-root", str(place), "--jobs", "1", "--out", str(out)]) == 130
    rows_by_name = rows(out)
    assert set(rows_by_name) == {"Ann", "Ben"} and "graded" in {row["status"] for row in rows_by_name.values()}
    unmarked = [row for row in rows_by_name.values() if row["status"] == "not marked"]
    assert all(row["total"] == "" for row in unmarked)
    monkeypatch.undo()
    monkeypatch.setattr(batch, "mark", cheap_mark)


def test_an_error_of_ours_is_no_mark(folder, monkeypatch):
    place, _ = folder

    def marks(submission, *more):
        if submission.student == "Ben":
            raise RuntimeError("oh")
        return cheap_mark(submission, *more)

    monkeypatch.setattr(batch, "mark", marks)
    status, rows_by_name = grade(place)
    assert status == 1 and (rows_by_name["Ben"]["status"], rows_by_name["Ben"]["total"]) == ("not marked", "")
    assert rows_by_name["Ann"]["total"] == "1"
