"""For each person and chapter the right file counts, whatever lies beside it, and why is told."""

import shutil

import pytest

from coursekit.grade.roster import Roster
from tests.needs import ON_WINDOWS

from .handed import (  # fmt: skip
    NOON,
    SERVICES,
    TOPICS,
    answer,
    by_name,
    cheap_mark,
    collected,
    grade,
    notebook,
    points_of,
    text,
    write,
    zipped,
)

HOUR = 3600


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A class's folder; marks are cheap."""
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    (tmp_path / "class").mkdir()
    return tmp_path / "class"


def only(folder):
    """The one person of a class, and the file that counts."""
    (handed,) = collected(folder, folder.parent / "scratch").handed
    return handed, handed.chosen[TOPICS].where if TOPICS in handed.chosen else None


BESIDE = {
    "a new edition that the course put there": (f"{TOPICS[:-6]}.new.ipynb", text()),
    "a backup of the empty copy": ("02_topics (backup of empty).ipynb", text()),
    "a checkpoint": (f".ipynb_checkpoints/{TOPICS[:-6]}-checkpoint.ipynb", text("q1")),
    "a Mac's twin": (f"__MACOSX/._{TOPICS}", "\0\5\26\7"),
    "a copy that is empty": ("02_topics (1).ipynb", text()),
    "a copy that cannot be read": ("02_topics (1).ipynb", "<html>Please log in</html>"),
    "a copy in which a cell was added": ("02_topics-Copy1.ipynb", text().replace('"cells": [', '"cells": [\n{"cell_type":'
        ' "code", "metadata": {}, "source": "ls", "outputs": [], "execution_count": null},', 1)),
}  # fmt: skip


@pytest.mark.parametrize("what", BESIDE)
@pytest.mark.parametrize("packed", [False, True], ids=["folder", "zip"])
def test_work_counts_before_whatever_lies_beside_it_and_is_newer(folder, what, packed):
    name, content = BESIDE[what]
    if packed:
        write(folder / "Ann Lee.zip", zipped({TOPICS: (text("q1", "q2"), NOON), name: (content, NOON + HOUR)}))
    else:
        write(folder / "Ann Lee" / TOPICS, text("q1", "q2"))
        write(folder / "Ann Lee" / name, content, NOON + HOUR)
    handed, where = only(folder)
    assert where.endswith(TOPICS) and handed.chosen[TOPICS].known.begun == ("ch02.q1", "ch02.q2") and not handed.open
    if "twin" not in what:
        assert any("counts; not" in note for note in handed.notes), handed.notes


@pytest.mark.parametrize("packed", [False, True], ids=["folder", "zip"])
@pytest.mark.parametrize("names", [("final", "old"), ("a", "z")])
def test_the_newest_counts_whatever_the_order_of_the_names(folder, packed, names):
    right, wrong = names
    files = {f"{right}/{TOPICS}": (text("q1", "q2"), NOON), f"{wrong}/{TOPICS}": (text("q1"), NOON - HOUR)}
    if packed:
        write(folder / "Ann Lee.zip", zipped(files))
    for name, (content, when) in {} if packed else files.items():
        write(folder / "Ann Lee" / name, content, when)
    handed, where = only(folder)
    assert where.endswith(f"{right}/{TOPICS}") and f"{wrong}/{TOPICS}" in handed.notes[0]


def test_a_later_file_of_one_hand_in_with_less_work_is_asked_about(folder):
    write(folder / "Ann Lee" / TOPICS, text("q1", "q2", "q3"))
    write(folder / "Ann Lee" / "02_topics (1).ipynb", text("q1"), NOON + HOUR)
    handed, where = only(folder)
    assert where is None and "which file is" in handed.open[0]


def test_files_that_nothing_tells_apart_are_asked_about_and_the_answer_counts(folder):
    for name, done in (("final", "q1"), ("old", "q2")):
        write(folder / "Ann Lee" / name / TOPICS, text(done))
    status, rows_by_name = grade(folder)
    assert status == 1 and rows_by_name["Ann Lee"]["status"] == "question" and rows_by_name["Ann Lee"]["total"] == ""
    asked = answer(folder.parent / "questions.csv", Lee=f"old/{TOPICS}")
    assert asked[0]["choices"] == f"final/{TOPICS} | old/{TOPICS}" and asked[0]["answer"] == f"old/{TOPICS}"
    for _ in range(2):
        status, rows_by_name = grade(folder)
        assert status == 0 and rows_by_name["Ann Lee"]["ch02.q2"] == "2" and rows_by_name["Ann Lee"]["ch02.q1"] == "0"
    write(folder / "Ann Lee" / "final" / TOPICS, text("q3"))
    assert grade(folder)[0] == 1, "an answer is about the files that it was given for"


def test_an_answer_that_is_none_of_the_choices_is_no_answer(folder):
    for name, done in (("final", "q1"), ("old", "q2")):
        write(folder / "Ann Lee" / name / TOPICS, text(done))
    grade(folder)
    answer(folder.parent / "questions.csv", Lee="whatever")
    assert grade(folder)[0] == 1
    answer(folder.parent / "questions.csv", Lee="1")
    assert grade(folder)[1]["Ann Lee"]["ch02.q1"] == "1"


@pytest.mark.parametrize(("said", "begun"), [("1", "ch02.q1"), ("2", "ch02.q2"), (f"ann_lee/{TOPICS}", "ch02.q2")])
def test_files_of_one_name_in_two_hand_ins_are_told_apart(folder, said, begun):
    write(folder / "Ann Lee" / TOPICS, text("q1"))
    write(folder / "ann_lee" / TOPICS, text("q2"))
    grade(folder)
    (asked,) = answer(folder.parent / "questions.csv", Lee=said)
    assert asked["choices"] == f"Ann Lee/{TOPICS} | ann_lee/{TOPICS}"
    status, rows_by_name = grade(folder)
    assert (
        status == 0
        and rows_by_name["Ann Lee"][begun] != "0"
        and float(rows_by_name["Ann Lee"]["total"]) == points_of(begun[5:])
    )


def test_the_same_work_twice_is_no_question(folder):
    for name in ("a", "b"):
        write(folder / "Ann Lee" / name / TOPICS, text("q1"))
    assert only(folder)[1] == f"a/{TOPICS}"


def test_only_a_checkpoint_counts_and_is_told(folder):
    write(folder / "Ann Lee" / ".ipynb_checkpoints" / "02_topics-checkpoint.ipynb", text("q1"))
    handed, where = only(folder)
    assert where and "only this checkpoint" in handed.notes[0]


def test_folder_and_files_of_one_student_are_one_person(folder):
    write(folder / "Ann Lee" / TOPICS, text("q1"), NOON - HOUR)
    write(folder / "Ann Lee.ipynb", text("q1", "q2"))
    write(folder / "ann_lee.zip", zipped({SERVICES: text("q1", chapter=SERVICES)}))
    for _ in range(2):
        handed, where = only(folder)
        assert where == "Ann Lee.ipynb" and set(handed.chosen) == {TOPICS, SERVICES} and len(handed.attempts()) == 3


def test_names_that_differ_in_accents_are_two_people_and_that_is_told(folder):
    for name in ("José Roa", "Jose Roa"):
        write(folder / name / TOPICS, text("q1"))
    collection = collected(folder, folder.parent / "scratch")
    assert len(collection.handed) == 2 and "look like one name" in collection.told[0]


def test_a_notebook_is_known_by_what_it_holds(folder):
    write(folder / "Ann Lee" / "homework.ipynb", text("q1"))
    write(folder / "Ann Lee" / "02_topics.ipynb", text("q1", chapter=SERVICES))
    handed = by_name(collected(folder, folder.parent / "scratch"))["Ann Lee"]
    assert handed.chosen[TOPICS].where == "homework.ipynb" and handed.chosen[SERVICES].where == TOPICS


def test_a_notebook_that_nothing_names_is_asked_about(folder):
    bare = notebook("q1")
    bare["cells"] = [{"cell_type": "code", "metadata": {}, "source": "x = 1", "outputs": []}]
    write(folder / "Ann Lee" / "homework.ipynb", str(bare).replace("'", '"'))
    write(folder / "Ben Ito" / TOPICS, text("q1"))
    status, rows_by_name = grade(folder)
    assert status == 1 and rows_by_name["Ann Lee"]["status"] == "question" and rows_by_name["Ann Lee"]["total"] == ""
    answer(folder.parent / "questions.csv", homework=TOPICS)
    status, rows_by_name = grade(folder)
    assert status == 0 and rows_by_name["Ann Lee"]["total"] == "0"


def test_one_student_s_extra_notebook_changes_nobody_else(folder, capsys):
    for name in ("Ann", "Ben", "Cem"):
        write(folder / f"{name}_02_topics.ipynb", text("q1", "q2"))
    before = grade(folder)[1]
    write(folder / "Cem" / SERVICES, text("q1", chapter=SERVICES))
    capsys.readouterr()
    after = grade(folder)[1]
    assert list(after["Ann"]) == list(before["Ann"]) and after["Ann"] == before["Ann"] and after["Ben"] == before["Ben"]
    assert after["Cem"]["total"] == before["Cem"]["total"]
    assert f"{SERVICES} was handed in only by Cem" in capsys.readouterr().out


def test_a_student_called_class_and_those_with_names_of_results(folder):
    names = ["class", "x", "x.results", "grades", "Class 2", "..", "con1" if ON_WINDOWS else "CON", "similar"]
    for name in names:
        if name != "..":
            write(folder / name / TOPICS, text("q1"))
    rows_by_name = grade(folder)[1]
    assert len(rows_by_name) == 7 and len({row["key"].casefold() for row in rows_by_name.values()}) == 7
    kept = folder.parent / "grades"
    assert "<h1>The class: 02_topics</h1>" in (kept / "class.html").read_text()
    assert all((kept / f"{row['key']}.html").is_file() for row in rows_by_name.values())


def test_who_hands_in_something_else_is_told(folder):
    write(folder / "Ann Lee" / "essay.pdf", b"%PDF")
    (folder / "Ben Ito").mkdir()
    write(folder / "Cem" / TOPICS, text("q1"))
    write(folder / "roster copy.txt", "x")
    rows_by_name = grade(folder)[1]
    assert rows_by_name["Ann Lee"]["status"] == "empty" and "essay.pdf" in rows_by_name["Ann Lee"]["notes"]
    assert rows_by_name["Ben Ito"]["status"] == "empty" and set(rows_by_name) == {"Ann Lee", "Ben Ito", "Cem"}


def test_a_file_with_the_name_of_a_chapter_alone_is_nobody_s_until_it_is_said(folder):
    write(folder / TOPICS, text("q1"))
    status, rows_by_name = grade(folder)
    assert status == 1 and not rows_by_name
    answer(folder.parent / "questions.csv", **{"02_topics": "Ann Lee"})
    status, rows_by_name = grade(folder)
    assert status == 0 and rows_by_name["Ann Lee"]["total"] == "1"


def test_the_download_can_be_given_as_it_comes(folder):
    inner = zipped({f"work/{TOPICS}": text("q1", "q2")})
    files = {
        "García López Ana_101_assignsubmission_file_/answers.zip": inner,
        f"Ito Ben_102_assignsubmission_file_/{TOPICS}": text("q1"),
        f"__MACOSX/Ito Ben_102_assignsubmission_file_/._{TOPICS}": "x",
    }
    place = write(folder / "moodle.zip", zipped(files))
    handed_by_name = by_name(collected(place, folder.parent / "scratch"))
    assert set(handed_by_name) == {"García López Ana", "Ito Ben"}
    assert handed_by_name["García López Ana"].chosen[TOPICS].known.begun == ("ch02.q1", "ch02.q2")
    wrapped = write(folder / "week2.zip", zipped({f"week2/Ann Lee/{TOPICS}": text("q1"), "week2/Ben.zip": inner}))
    assert set(by_name(collected(wrapped, folder.parent / "scratch"))) == {"Ann Lee", "Ben"}


def test_collecting_is_the_same_each_time(folder, tmp_path):
    for number, name in enumerate(("Ann Lee", "Ben Ito")):
        write(folder / name / TOPICS, text("q1"), NOON + number)
        write(folder / name / "02_topics (1).ipynb", text("q1", "q2"), NOON + HOUR)
    listings = [
        [(handed.label, handed.chosen[TOPICS].where, handed.notes) for handed in collected(folder, tmp_path / "s").handed]
        for _ in range(2)
    ]
    moved = tmp_path / "moved"
    shutil.copytree(folder, moved)
    assert (
        listings[0]
        == listings[1]
        == [(o.label, o.chosen[TOPICS].where, o.notes) for o in collected(moved, tmp_path / "s").handed]
    )


@pytest.mark.parametrize(("content", "why"), [
    (b"", "the file is empty"), ("<html>Please log in</html>", "it begins with '<html>Please log in</html>'"),
    (text("q1")[:4000], "it breaks off, or is not whole, in line"), (b'{"cells": "\xff\xfe"}', "it is not text in UTF-8"),
])  # fmt: skip
def test_why_a_file_is_no_notebook_is_said_without_a_parser_s_words(folder, content, why):
    write(folder / "Ann Lee" / TOPICS, content)
    handed, where = only(folder)
    assert where is None and f"is no notebook: {why}" in handed.notes[0]


def test_an_answer_about_a_file_does_not_hold_for_another_week_s_of_the_same_name(tmp_path, monkeypatch):
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    (tmp_path / "names.txt").write_text("Ann Lee\nBen Ito\n")
    words = ("--roster", tmp_path / "names.txt")
    write(tmp_path / "class" / "garcia.ipynb", text("q1"))
    assert grade(tmp_path / "class", *words)[0] == 1
    answer(tmp_path / "questions.csv", garcia="nobody")
    assert grade(tmp_path / "class", *words)[0] == 0
    write(tmp_path / "class" / "garcia.ipynb", text("q2"))
    assert grade(tmp_path / "class", *words)[0] == 1, "it is asked again"


def test_a_question_offers_those_whose_name_has_a_word_of_the_file_s(tmp_path):
    write(tmp_path / "class" / "garcia.ipynb", text("q1"))
    roster = Roster(["Ana García", "Luz García Paz", "Ben Ito"])
    (question,) = collected(tmp_path / "class", tmp_path / "scratch", roster=roster).questions
    assert question.choices == ("Ana García", "Luz García Paz")
