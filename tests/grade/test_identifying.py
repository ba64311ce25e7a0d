"""Whose a hand-in is: exact names, then the platforms' patterns, then a question; a copy's own mark settles it."""

import csv
import json
import zipfile

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade.identifying import Identifier, named_in
from coursekit.grade.roster import Roster
from coursekit.grade.variants import Variants

from .handed import NOTEBOOKS, TOPICS, WALLS, answer, by_name, cheap_mark, collected, grade, text, write, zipped

MOODLE = '"Identifier","Full name","ID number","Email address","Status","Grade","Last modified (submission)"\n'
LISTS = {
    "moodle.csv": MOODLE + '"Participant 101","García López, Ana",a01,ana@uni.example,,,\n"Participant 102","Ito, Ben",a02,'
    "ben@uni.example,,,\n",
    "canvas.csv": 'Student,ID,SIS User ID,SIS Login ID,Section,mark\n    Points Possible,,,,,7\n"García López, Ana",12,a01,'
    'ana,1,\n"Ito, Ben",14,a02,ben,1,\n"Student, Test",99,,preview,1,\n',
    "blackboard.csv": '\ufeff"Last Name","First Name","Username","Student ID"\nGarcía López,Ana,ana,a01\nIto,Ben,ben,a02\n',
    "classroom.csv": "Last Name,First Name,Email Address,x\nGarcía López,Ana,ana@uni.example,\nIto,Ben,ben@uni.example,\n",
    "plain.csv": "name;id;e-mail\nAna García López;a01;ana@uni.example\nBen Ito;a02;ben@uni.example\n",
    "tabs.csv": "Given name\tFamily name\tStudent ID\nAna\tGarcía López\ta01\nBen\tIto\ta02\n",
    "names.txt": "Ana García López\nBen Ito\n",
    "sep.csv": "sep=;\nName;ID\nGarcía López, Ana;a01\nIto, Ben;a02\n",
}


def roster_of(tmp_path, name, encoding="utf-8"):
    file = tmp_path / name
    file.write_bytes(LISTS[name].encode(encoding))
    return Roster.read(file)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
@pytest.mark.parametrize("name", LISTS)
def test_every_platform_s_list_is_read(tmp_path, name, encoding):
    if encoding == "cp1252" and "\ufeff" in LISTS[name]:
        pytest.skip("NOT TESTED: that mark has no letter there")
    roster = roster_of(tmp_path, name, encoding)
    assert roster.students in (["Ana García López", "Ben Ito"],)
    if name not in ("names.txt", "classroom.csv"):
        assert [person.id for person in roster.people] == ["a01", "a02"]
    assert bool(roster.notes) == (name == "canvas.csv")


NAMES = {
    "moodle.csv": ["García López Ana_101_assignsubmission_file_", f"García López Ana_101_assignsubmission_file_{TOPICS}"],
    "canvas.csv": [f"garcalpezana_12_13_{TOPICS}", f"garcíalópezana_LATE_12_13_{TOPICS}", f"garcialopezana_12_13_{TOPICS}"],
    "blackboard.csv": [f"Week_2_ana_attempt_2026-11-22-23-59-00_{TOPICS}"],
    "classroom.csv": [f"Ana García López - {TOPICS}"],
    "plain.csv": ["a01", "ana@uni.example", "Ana_Garcia_Lopez", "García López, Ana", "AnaGarcíaLópez_02_topics.ipynb",
                  "A01.zip", "02_topics a01.ipynb", "garcía lópez ana.ipynb"],
}  # fmt: skip


@pytest.mark.parametrize(
    ("name", "handed_in"), [(name, file_name) for name, listed in NAMES.items() for file_name in listed]
)
def test_the_platform_s_names_for_files_are_known(tmp_path, name, handed_in):
    assert named_in(handed_in, roster_of(tmp_path, name)) == "Ana García López"


@pytest.mark.parametrize(
    "handed_in", ["Joana García López_5_assignsubmission_file_", "ito", "ana", "An Ito", "02_topics.ipynb", ""]
)
def test_what_only_resembles_a_name_is_nobody_s(tmp_path, handed_in):
    assert named_in(handed_in, roster_of(tmp_path, "names.txt")) == ""


def test_two_who_fit_are_asked_about_and_a_name_within_a_name_is_not_meant():
    someone = Identifier(Roster(["Ann Lee", "Ann Lee Smith", "Lee Wong"]))
    assert [person.name for person in someone.by_name("Ann Lee Smith_02_topics.ipynb").people] == ["Ann Lee Smith"]
    assert [person.name for person in someone.by_name("ann_lee_wong_02_topics.ipynb").people] == ["Ann Lee", "Lee Wong"]


def test_people_of_one_name_need_ids():
    with pytest.raises(ValueError, match="same name: Ann Lee, ann lee"):
        Roster(["Ann Lee", "ann lee"])


def test_people_of_one_name_are_told_apart_by_ids_and_asked_about_by_name(tmp_path):
    (tmp_path / "a.csv").write_text("name,id\nAnn Lee,a01\nAnn Lee,a02\n")
    roster = Roster.read(tmp_path / "a.csv")
    assert roster.students == ["Ann Lee (a01)", "Ann Lee (a02)"]
    assert named_in("Ann Lee", roster) == "" and named_in("a02.zip", roster) == "Ann Lee (a02)"


@pytest.mark.parametrize(
    ("table", "told"),
    [("name,id\nAnn,1\nBen,1\n", "same id '1': Ann, Ben"), ("name,id\nAnn,1\n,\n  ,\n", None),
     ("name,id\nAnn,1\n,2\n", None), ("name\n\n", "no names"), ("name,email\nA,x@y\nB,X@y\n", "same email")],
)  # fmt: skip
def test_a_list_that_cannot_be_right_is_refused(tmp_path, table, told):
    (tmp_path / "a.csv").write_text(table)
    if told is None:
        assert Roster.read(tmp_path / "a.csv").people[0].name == "Ann"
    else:
        with pytest.raises(ValueError, match=told):
            Roster.read(tmp_path / "a.csv")


@pytest.fixture
def group(tmp_path, monkeypatch):
    """A class of two with a list, whose copies were handed out."""
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    (tmp_path / "roster.csv").write_text(LISTS["plain.csv"], encoding="utf-8")
    assert main(["release", "02", "--roster", str(tmp_path / "roster.csv"), "--out", str(tmp_path / "week2")]) == 0
    (tmp_path / "class").mkdir()
    return tmp_path


def copy_of(group, word, *done):
    """What was handed out to somebody, with exercises done."""
    nb = json.loads((group / "week2" / word / TOPICS).read_text())
    for cell in nb["cells"]:
        if cell["metadata"].get("nbgrader", {}).get("grade_id", "").partition("-")[2] in done:
            cell["source"] = ["done = True\n"]
    return json.dumps(nb)


def test_every_copy_carries_a_mark_that_only_the_teacher_can_read(group):
    secret = (group / "roster.secret").read_text().strip()
    marks = {json.loads(copy_of(group, word))["metadata"]["coursekit"]["copy"] for word in ("AnaGarcíaLópez", "BenIto")}
    assert len(marks) == 2 and marks == set(Variants.read(group / "roster.csv").copy_marks())
    assert not [word for word in (secret, "Ben", "uni.example") if word in copy_of(group, "BenIto")]
    with zipfile.ZipFile(group / "week2" / "BenIto.zip") as packed:
        assert packed.namelist() == [f"week2/{TOPICS}", "week2/images/workspace.svg"]


def test_without_a_list_a_release_says_which_it_is(tmp_path):
    assert main(["release", "02", "--out", str(tmp_path / "week2")]) == 0
    facts = json.loads((tmp_path / "week2" / TOPICS).read_text())["metadata"]["coursekit"]
    assert facts["chapter"] == TOPICS and len(facts["release"]) == 24 and "copy" not in facts


def test_the_copy_says_whose_it_is_whatever_its_name(group):
    write(group / "class" / "homework final (3).ipynb", copy_of(group, "BenIto", "q1"))
    write(group / "class" / TOPICS, copy_of(group, "AnaGarcíaLópez", "q1", "q2"))
    status, rows_by_name = grade(group / "class", "--roster", group / "roster.csv")
    assert status == 0 and {name: row["total"] for name, row in rows_by_name.items()} == {
        "Ana García López": "3",
        "Ben Ito": "1",
    }
    assert rows_by_name["Ben Ito"]["id"] == "a02" and "the mark of the copy" in rows_by_name["Ben Ito"]["notes"]


def test_another_s_copy_under_one_s_own_name_is_asked_about(group):
    write(group / "class" / "Ben Ito" / TOPICS, copy_of(group, "AnaGarcíaLópez", "q1"))
    status, rows_by_name = grade(group / "class", "--roster", group / "roster.csv")
    assert status == 1 and {row["status"] for row in rows_by_name.values()} == {"question"}
    assert {row["total"] for row in rows_by_name.values()} == {""}
    _, coded = grade(group / "class", "--roster", group / "roster.csv", "--anonymous")
    assert not [row for row in coded.values() if "Ben" in str(row) or "Ana" in str(row)]
    asked = answer(group / "questions.csv", Ben="a02")
    assert "the copy was made for Ana García López" in asked[0]["about"]
    status, rows_by_name = grade(group / "class", "--roster", group / "roster.csv")
    assert (
        status == 0
        and rows_by_name["Ben Ito"]["total"] == "1"
        and rows_by_name["Ana García López"]["status"] == "nothing handed in"
    )
    assert f"{TOPICS}: the copy was made for Ana García López" in rows_by_name["Ben Ito"]["notes"]


def test_a_name_that_nobody_has_is_asked_about_and_everybody_has_a_row(group, capsys):
    write(group / "class" / "Who Is That.ipynb", text("q1"))
    write(group / "class" / "Ben Ito.zip", zipped({TOPICS: text("q1")}))
    status, rows_by_name = grade(group / "class", "--roster", group / "roster.csv")
    assert (
        status == 1
        and rows_by_name["Ben Ito"]["status"] == "graded"
        and rows_by_name["Ana García López"]["status"] == "nothing handed in"
    )
    said = capsys.readouterr().out
    assert "Whose is this?" in said and "1 question is open" in said and "questions.csv" in said
    answer(group / "questions.csv", Who="nobody at all")
    assert grade(group / "class", "--roster", group / "roster.csv")[0] == 1
    answer(group / "questions.csv", Who="nobody")
    assert grade(group / "class", "--roster", group / "roster.csv")[0] == 0
    answer(group / "questions.csv", Who="ana@uni.example")
    status, rows_by_name = grade(group / "class", "--roster", group / "roster.csv")
    assert status == 0 and rows_by_name["Ana García López"]["total"] == "1"


def test_files_that_canvas_renamed_are_each_person_s_own(tmp_path):
    (tmp_path / "class").mkdir()
    write(tmp_path / "class" / f"itoben_14_15_{TOPICS}", text("q1"))
    write(tmp_path / "class" / f"garcalpezana_LATE_12_13_{TOPICS}", text("q1", "q2"))
    write(tmp_path / "class" / "itoben_14_16_extra.ipynb", text("q1", chapter="03_services.ipynb"))
    handed_by_name = by_name(collected(tmp_path / "class", tmp_path / "s", roster=roster_of(tmp_path, "canvas.csv")))
    assert {name: sorted(handed.chosen) for name, handed in handed_by_name.items()} == {
        "Ana García López": [TOPICS], "Ben Ito": ["03_services.ipynb", TOPICS][::-1],
    }  # fmt: skip
    assert handed_by_name["Ana García López"].chosen[TOPICS].late_said


def test_two_bundles_of_one_student_are_one_student(tmp_path):
    from coursekit.grade.bundle import pack_bundle

    (tmp_path / "class").mkdir()
    for at, (name, done) in enumerate(((TOPICS, "q1"), ("03_services.ipynb", "q1"))):
        facts = {"student": "Ann Lee", "notebook": name, "time": f"2026-11-2{at} 10:00:00 +0000"}
        data = pack_bundle({name: text(done, chapter=name).encode()}, facts)
        write(tmp_path / "class" / f"AnnLee_{name[:-6]}.zip", data)
    collection = collected(tmp_path / "class", tmp_path / "s")
    (handed,) = collection.handed
    assert handed.label == "Ann Lee" and set(handed.chosen) == {TOPICS, "03_services.ipynb"}
    assert {piece.when_from for piece in handed.chosen.values()} == {"the time that hand_in sealed"}


def test_a_manifest_of_the_course_s_own_folder_is_no_bundle(tmp_path):
    (tmp_path / "class").mkdir()
    files = {TOPICS: text("q1"), ".coursekit/manifest.json": "{}", "ros2_ws/manifest.json": "{}"}
    write(tmp_path / "class" / "Ann Lee.zip", zipped(files))
    (handed,) = collected(tmp_path / "class", tmp_path / "s").handed
    assert handed.bundles() == [] and handed.submission(TOPICS).bundles() == [] and not handed.concerns


def test_the_release_tells_the_points_that_the_judges_give(tmp_path):
    from coursekit.grade.exercise import all_exercises
    from coursekit.grade.release import release, released, with_points
    from coursekit.grade.variants import checks_in

    known, told = all_exercises(), {}
    chapters = [json.loads(file.read_text(encoding="utf-8")) for file in sorted(NOTEBOOKS.glob("*.ipynb"))]
    for source in filter(checks_in, chapters):
        for nb in (source, released(source), with_points(released(source))):
            for name, place in checks_in(nb).items():
                told[name] = nb["cells"][place]["metadata"]["nbgrader"]["points"]
                assert told[name] == known[name].points, name
    assert set(told) == set(known)
    source = json.loads((NOTEBOOKS / TOPICS).read_text(encoding="utf-8"))
    source["cells"][max(checks_in(source).values())]["metadata"]["nbgrader"]["points"] = 99
    assert 99 not in [cell["metadata"].get("nbgrader", {}).get("points") for cell in with_points(released(source))["cells"]]
    release(sorted(NOTEBOOKS.glob("02*.ipynb")), tmp_path / "out")
    assert "<td>4</td><td>7</td>" in (tmp_path / "out" / "page.html").read_text()


@WALLS
def test_a_chapter_that_is_none_is_refused_beside_one_that_is(tmp_path):
    with pytest.raises(SystemExit, match=r"No chapter begins with 99. There are: 00_start_here, "):
        main(["release", "02", "99", "--out", str(tmp_path / "week2")])
    with pytest.raises(SystemExit, match="No chapter begins with 99"):
        main(["grade", "--allow-root", str(tmp_path), "--chapters", "02", "99"])


def test_what_moves_a_terminal_is_taken_out_of_a_list(tmp_path):
    (tmp_path / "a.csv").write_text("name,id\nAnn\x1b[2J Lee,a\u202e01\n", encoding="utf-8")
    (ann,) = Roster.read(tmp_path / "a.csv").people
    assert (ann.name, ann.id) == ("Ann [2J Lee", "a01")


def test_the_table_of_a_list_has_no_formula(group):
    (group / "roster.csv").write_text('name,id\n"=1+1",a01\n"Ben;=cmd()",a02\n', encoding="utf-8")
    grade(group / "class", "--roster", group / "roster.csv")
    with open(group / "grades.csv", newline="", encoding="utf-8-sig") as file:
        assert [row["student"] for row in csv.DictReader(file)] == ["'=1+1", "Ben;'=cmd()"]


@pytest.mark.parametrize("more", ["", "Eva Lee,eva@uni.example\n"])
def test_whoever_has_no_e_mail_does_not_get_what_is_nobody_s(tmp_path, more):
    """No answer to the question whose it is was taken for the one person whose e-mail is empty."""
    (tmp_path / "list.csv").write_text(f"Full name,Email address\nBen Ito,\n{more}", encoding="utf-8")
    write(tmp_path / "class" / "García López Ana_101_assignsubmission_file_" / TOPICS, text("q1", "q2"))
    roster = Roster.read(tmp_path / "list.csv")
    collection = collected(tmp_path / "class", tmp_path / "scratch", roster=roster)
    assert not by_name(collection)["Ben Ito"].entries and "Whose is this?" in collection.questions[0].text
    assert roster.of("") is None and roster.of("  ") is None
