"""Copies of several people in one folder: each is settled by its mark or name, or asked about, on its own."""

import pytest

from coursekit.grade.bundle import pack_bundle
from coursekit.grade.roster import Person, Roster

from .handed import NOON, TOPICS, answer, by_name, collected, grade, text, write, zipped
from .test_identifying import copy_of, group

__all__ = ["group"]
ANA, BEN = "AnaGarcíaLópez", "BenIto"


def told(found):
    return {name: (row["status"], row["total"]) for name, row in found.items()}


def run(group):
    return grade(group / "class", "--roster", group / "roster.csv")


@pytest.mark.parametrize("packed", [False, True], ids=["folder", "zip"])
def test_marks_settle_whose_the_copies_in_a_folder_are(group, packed):
    files = {"one.ipynb": copy_of(group, ANA, "q1", "q2"), "two.ipynb": copy_of(group, BEN, "q1")}
    for name, content in {} if packed else files.items():
        write(group / "class" / "group 7" / name, content)
    if packed:
        write(group / "class" / "group 7.zip", zipped(files))
    status, rows_by_name = run(group)
    assert status == 0 and told(rows_by_name) == {"Ana García López": ("graded", "3"), "Ben Ito": ("graded", "1")}
    assert "group 7" in rows_by_name["Ben Ito"]["notes"] and "the mark of the copy" in rows_by_name["Ben Ito"]["notes"]


def test_another_s_copy_in_one_s_own_folder_is_one_question_and_the_rest_is_theirs(group):
    write(group / "class" / "Ben Ito" / TOPICS, copy_of(group, BEN, "q1"))
    write(group / "class" / "Ben Ito" / "from ana.ipynb", copy_of(group, ANA, "q1", "q2"), NOON + 60)
    status, rows_by_name = run(group)
    assert status == 1 and told(rows_by_name) == {"Ana García López": ("question", ""), "Ben Ito": ("question", "")}
    (asked,) = answer(group / "questions.csv", Ben="Ana")
    assert "from ana.ipynb" in asked["about"] and TOPICS not in asked["about"]
    assert asked["choices"] == "Ana García López | Ben Ito" and "1 notebook)" in asked["about"]
    status, rows_by_name = run(group)
    assert status == 0 and told(rows_by_name) == {"Ana García López": ("graded", "3"), "Ben Ito": ("graded", "1")}
    answer(group / "questions.csv", Ben="nobody")
    assert told(run(group)[1]) == {"Ana García López": ("nothing handed in", "0"), "Ben Ito": ("graded", "1")}


def test_each_copy_in_a_stranger_s_folder_is_a_question_of_its_own(group):
    write(group / "class" / "Ben Ito" / "mine.ipynb", text("q1"))
    write(group / "roster.csv", "name,id\nBen Ito,a02\nAna García López,a01\nCem Kaya,a03\n")
    write(group / "class" / "Cem Kaya" / "a.ipynb", copy_of(group, ANA, "q1"))
    write(group / "class" / "Cem Kaya" / "b.ipynb", copy_of(group, BEN, "q2"))
    write(group / "class" / "Cem Kaya" / "c.ipynb", text("q3"))
    status, rows_by_name = run(group)
    assert status == 1 and {row_status for row_status, _ in told(rows_by_name).values()} == {"question"}
    asked = answer(group / "questions.csv", **{"a.ipynb": "Ana", "b.ipynb": "nobody"})
    assert len(asked) == 2
    status, rows_by_name = run(group)
    assert status == 0
    assert {name: row["total"] for name, row in rows_by_name.items()} == {
        "Ben Ito": "1",
        "Ana García López": "1",
        "Cem Kaya": "2",
    }


def test_names_of_what_lies_in_a_nameless_folder_settle_it_and_the_rest_is_asked(tmp_path):
    (tmp_path / "class").mkdir()
    place, people = tmp_path / "class" / "downloads", Roster([Person("Ann Lee"), Person("Ben Ito")])
    write(place / "Ann Lee" / TOPICS, text("q1"))
    write(place / "ben_ito_02_topics.ipynb", text("q2"))
    write(place / "mystery.ipynb", text("q3"))
    collection = collected(tmp_path / "class", tmp_path / "s", roster=people)
    assert {name: handed.chosen[TOPICS].known.begun for name, handed in by_name(collection).items()} == {
        "Ann Lee": ("ch02.q1",), "Ben Ito": ("ch02.q2",),
    }  # fmt: skip
    (question,) = collection.unanswered
    assert "mystery.ipynb" in question.about and "ann" not in question.about.casefold()


def test_a_file_that_cannot_be_read_among_others_copies_is_asked_about(tmp_path):
    place = tmp_path / "class" / "downloads"
    for name in ("Ann Lee", "Ben Ito"):
        write(place / name / TOPICS, text("q1"))
    write(place / "cem.zip", b"PK no zip")
    people = Roster([Person("Ann Lee"), Person("Ben Ito"), Person("Cem Kaya")])
    collection = collected(tmp_path / "class", tmp_path / "s", roster=people)
    assert len(collection.unanswered) == 1


def test_files_of_hand_in_in_one_folder_are_each_their_author_s(tmp_path):
    for name in ("Ann Lee", "Ben Ito"):
        facts = {"student": name, "notebook": TOPICS, "time": "2026-11-23 08:00:00 +0000"}
        data = pack_bundle({TOPICS: text("q1", own=f" by {name}").encode()}, facts)
        write(tmp_path / "class" / "all" / f"{len(name)}{name[:1]}.zip", data)
    collection = collected(tmp_path / "class", tmp_path / "s", roster=Roster([Person("Ann Lee"), Person("Ben Ito")]))
    people = by_name(collection)
    assert not collection.unanswered and all(len(people[name].bundles()) == 1 for name in ("Ann Lee", "Ben Ito"))
    assert [people[name].chosen[TOPICS].bundle for name in people] == [person.bundles()[0] for person in people.values()]


def test_one_person_s_folder_is_parted_by_nothing(tmp_path):
    people = Roster([Person("Ann Lee"), Person("Ben Ito")])
    write(tmp_path / "class" / "Ann Lee" / "ben ito.ipynb", text("q1"))
    write(tmp_path / "class" / "Ann Lee" / TOPICS, text("q1", "q2"))
    handed_by_name = by_name(collected(tmp_path / "class", tmp_path / "s", roster=people))
    assert len(handed_by_name["Ann Lee"].pieces()) == 2 and not handed_by_name["Ben Ito"].entries


def test_a_part_of_a_name_is_an_answer_where_it_is_one_person_s(group):
    write(group / "class" / "Who.ipynb", text("q1"))
    for said, status in (("López", 0), ("ana garcia", 0), ("ito", 0), ("a", 1), ("Ana Ito", 1), ("Ana", 0)):
        run(group)
        answer(group / "questions.csv", Who=said)
        assert run(group)[0] == status, said


def test_a_given_name_of_two_is_no_answer():
    people = Roster([Person("Ann Lee", family="Lee", given="Ann"), Person("Ann Ito", family="Ito", given="Ann")])
    assert people.of("Ann") is None and people.of("Ann I") is None and people.of("Ito").name == "Ann Ito"
    assert Roster(["Ann", "Ann Lee"]).of("Ann").name == "Ann", "a whole name counts before a part"
