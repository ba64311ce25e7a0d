"""Marks go back in the platform's own columns; what a teacher wrote by hand stays; names can be hidden."""

import csv
import html
import json
import stat
import zipfile

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade.statuses import STATUSES

from .handed import NOON, SERVICES, TOPICS, answer, cheap_mark, grade, rows, text, write, zipped
from .test_identifying import LISTS


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """What Moodle's download of a class of two looks like; the list of it is beside."""
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    for name in LISTS:
        (tmp_path / name).write_text(LISTS[name], encoding="utf-8")
    write(tmp_path / "class" / "García López Ana_101_assignsubmission_file_" / TOPICS, text("q1", "q2"))
    return tmp_path / "class"


def lines(file):
    with open(file, newline="", encoding="utf-8-sig") as table:
        return list(csv.reader(table))


def test_moodle_s_own_table_comes_back_with_the_grades_and_the_pages_as_its_zip(folder):
    grade(folder, "--roster", folder.parent / "moodle.csv", "--for", "moodle")
    head, ana, ben = lines(folder.parent / "grades.moodle.csv")
    assert head == lines(folder.parent / "moodle.csv")[0]
    assert dict(zip(head, ana, strict=True)) | {"Identifier": "Participant 101", "Grade": "3"} == dict(
        zip(head, ana, strict=True)
    )
    assert ana[head.index("Full name")] == "García López, Ana" and ben[head.index("Grade")] == "0"
    with zipfile.ZipFile(folder.parent / "grades.feedback.zip") as packed:
        assert packed.namelist() == ["Ana García López_101_assignsubmission_file_/feedback.html"]
        assert "Ana García López" in packed.read(packed.namelist()[0]).decode()


@pytest.mark.parametrize("name", ["moodle.csv", "plain.csv", None])
def test_nobody_gets_another_s_page_whatever_folder_their_work_lay_in(folder, name):
    words = ("--roster", folder.parent / name) if name else ()
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q3"))
    write(folder / "Somebody Else_103_assignsubmission_file_" / TOPICS, text("q4"))
    grade(folder, *words)
    if name:
        answer(folder.parent / "questions.csv", Somebody="Ben")
        grade(folder, *words, "--for", "moodle")
    else:
        grade(folder, "--for", "moodle")
    with zipfile.ZipFile(folder.parent / "grades.feedback.zip") as packed:
        found = {one.split("_")[1]: packed.read(one).decode() for one in packed.namelist()}
    assert set(found) == ({"101", "102"} if name else {"101", "102", "103"})
    assert "López" in found["101"] and "Ben" in found["102"] and "Ben" not in found["101"]


def test_a_comment_reaches_also_whoever_handed_in_nothing(folder):
    words = ("--roster", folder.parent / "moodle.csv", "--for", "moodle")
    grade(folder, *words)
    edited(folder.parent / "grades.csv", student="Ben Ito", comment="Come and see me.")
    grade(folder, *words)
    with zipfile.ZipFile(folder.parent / "grades.feedback.zip") as packed:
        (own,) = [one for one in packed.namelist() if "_102_" in one]
        assert "Come and see me." in packed.read(own).decode()


def test_canvas_gets_a_column_and_its_points_possible(folder):
    write(folder.parent / "c" / f"itoben_14_15_{TOPICS}", text("q1"))
    grade(folder.parent / "c", "--roster", folder.parent / "canvas.csv", "--for", "canvas", "--chapters", "02")
    head, possible, ana, ben, test = lines(folder.parent / "grades.canvas.csv")
    assert head[:5] == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"] and head[-1] == "coursekit 02"
    assert [row[-1] for row in (possible, ana, ben, test)] == ["7", "0", "1", ""] and "Points Possible" in possible[0]


def test_blackboard_and_classes_without_its_list_get_its_columns(folder):
    grade(folder, "--roster", folder.parent / "plain.csv", "--for", "blackboard")
    head, ana, _ = lines(folder.parent / "grades.blackboard.csv")
    assert head[:4] == ["Last Name", "First Name", "Username", "Student ID"] and ana[3:5] == ["a01", "3"]


def test_nothing_is_handed_back_for_whom_a_question_is_open(folder):
    write(folder / "Who Is It.ipynb", text("q1"))
    for name in ("x", "y"):
        write(folder / "Ito Ben_102_assignsubmission_file_" / name / TOPICS, text("q1" if name == "x" else "q2"))
    assert grade(folder, "--roster", folder.parent / "moodle.csv", "--for", "moodle")[0] == 1
    head, _, ben = lines(folder.parent / "grades.moodle.csv")
    assert ben[head.index("Grade")] == ""


def edited(table, **cells):
    """The table with other texts in a row of one student, saved as a German Excel does."""
    found = lines(table)
    row = next(one for one in found if one[1] == cells["student"])
    for name, said in cells.items():
        if name not in found[0]:
            found = [[*one, name if number == 0 else ""] for number, one in enumerate(found)]
            row = next(one for one in found if one[1] == cells["student"])
        row[found[0].index(name)] = said
    with open(table, "w", newline="", encoding="utf-8-sig") as out:
        csv.writer(out, delimiter=";").writerows(found)


def test_points_and_comments_by_hand_are_kept_and_told(folder, capsys):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1"))
    words = ("--roster", folder.parent / "moodle.csv")
    before = grade(folder, *words)[1]["Ben Ito"]
    edited(folder.parent / "grades.csv", student="Ben Ito", comment="Well tried; =see me", oral="2", **{"ch02.q2": "1,5"})
    for _ in range(2):
        capsys.readouterr()
        row = grade(folder, *words, "--again")[1]["Ben Ito"]
        assert (row["ch02.q2"], row["total"], row["comment"], row["oral"]) == ("1.5", "2.5", "Well tried;' =see me".replace(
            ";' =", "; '="), "2")  # fmt: skip
        assert "ch02.q2: 1.5 by hand" in row["notes"]
    page = (folder.parent / "grades" / f"{row['key']}.html").read_text()
    assert "Well tried" in page and "given by hand" in page
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1", "q3"), NOON + 60)
    assert grade(folder, *words)[1]["Ben Ito"]["total"] == "4.5"
    edited(folder.parent / "grades.csv", student="Ben Ito", **{"ch02.q2": ""})
    capsys.readouterr()
    assert grade(folder, *words)[1]["Ben Ito"]["total"] == "3" and before["total"] == "1"
    assert "ch02.q2 is the grader's again" in capsys.readouterr().out


def test_a_total_by_hand_and_one_that_is_no_number(folder, capsys):
    grade(folder)
    edited(folder.parent / "grades.csv", student="García López Ana", total="6", **{"ch02.q1": "good"})
    row = grade(folder)[1]["García López Ana"]
    assert (row["total"], row["points"]) == ("6", "3")
    said = capsys.readouterr().out
    assert "total is 6 by hand (was 3)" in said and "'good' is not a number: ignored" in said


def test_a_total_by_hand_is_that_of_its_chapters_only(folder):
    write(folder / "García López Ana_101_assignsubmission_file_" / SERVICES, text("q1", chapter=SERVICES))
    name = "García López Ana"
    grade(folder, "--chapters", "02")
    edited(folder.parent / "grades.csv", student=name, total="6")
    assert grade(folder, "--chapters", "02")[1][name]["total"] == "6"
    assert lines(folder.parent / "grades" / "gradebook.csv")[1][3:5] == ["6", "6"]
    other = grade(folder, "--chapters", "03")[1][name]
    assert other["total"] == other["points"] != "6" and "by hand" not in other["notes"]
    assert grade(folder, "--chapters", "02")[1][name]["total"] == "6"


def test_every_average_is_of_the_marks_after_lateness_and_says_so(folder, capsys):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1", "q2", "q3", "q4"), NOON + 30 * 3600)
    (folder.parent / "policy.toml").write_text("due = 2026-11-23T12:30:00\npercent_per_day = 10\n")
    found = grade(folder, "--policy", folder.parent / "policy.toml")[1]
    assert [row["total"] for row in found.values()] == ["3", "5.6"]
    words = "on average 4.30 of 7 points after lateness (2 students with work and a mark)"
    page = (folder.parent / "grades" / "class.html").read_text()
    assert words in capsys.readouterr().out and words in page
    kept = json.loads((folder.parent / "grades" / "statistics.json").read_text())
    assert (kept["mean"], kept["median"], kept["averaged"], kept["of"]) == (4.3, 4.3, 2, 7)
    assert kept["questions"]["ch02.q3"] == 0.5 and "Shares are before lateness" in page
    own = (folder.parent / "grades" / f"{found['Ito Ben']['key']}.html").read_text()
    assert "<b>5.6</b> of 7 points in 02_topics, after 20 % taken off for being late" in own


def test_the_page_of_the_class_names_the_chapters(folder):
    grade(folder, "--chapters", "02", "03")
    page = (folder.parent / "grades" / "class.html").read_text()
    assert "<h1>The class: 02_topics, 03_services</h1>" in page


def test_names_are_hidden_and_who_is_who_lies_apart(folder):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1", own=" by Ben Ito"))
    write(folder / "Ito Ben_102_assignsubmission_file_" / "Ito.txt", "Ben Ito")
    words = ("--roster", folder.parent / "moodle.csv", "--anonymous")
    found = grade(folder, *words)[1]
    assert all(name.startswith("P-") and len(name) == 10 for name in found) and len(found) == 2
    who = folder.parent / "grades.names.csv"
    assert stat.S_IMODE(who.stat().st_mode) == 0o600
    assert {row[0]: row[1] for row in lines(who)[1:]}.keys() == found.keys()
    shown = [
        folder.parent / "grades.csv",
        *(p for p in (folder.parent / "grades").iterdir() if p.suffix in (".html", ".json", ".csv")),
    ]
    for file in shown:
        said = file.read_text(encoding="utf-8-sig") + file.name
        assert not [one for one in ("García", "Ana ", "Ben", "Ito", "a01", "uni.example") if one in said], file.name
    assert grade(folder, *words)[1] == found
    named = grade(folder, *words[:2])[1]
    assert sorted(row["total"] for row in named.values()) == sorted(row["total"] for row in found.values())
    with pytest.raises(SystemExit, match="--for needs the names"):
        main(["grade", "--allow-root", str(folder), "--anonymous", "--for", "moodle"])


def test_table_page_and_closing_line_count_the_same(folder, capsys):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, "<html>")
    write(folder / "Nobody Known.zip", zipped({TOPICS: text("q1")}))
    status, found = grade(folder, "--roster", folder.parent / "moodle.csv")
    said = capsys.readouterr().out
    counts = "2 students: 1 graded, 1 unreadable; 1 hand-in is nobody's yet"
    page = (folder.parent / "grades" / "class.html").read_text()
    assert counts in said and html.escape(counts) in page and status == 1 and "1 question is open:" in said
    assert {row["status"] for row in found.values()} == {"graded", "unreadable"} and {
        row["status"] for row in found.values()
    } <= set(STATUSES)
    assert "sandbox bubblewrap" in said and "sandbox <code>bubblewrap</code>" in page
    assert page.index("Needs a look") < page.index("the hardest first") < page.index("All students")
    assert "Nobody Known" in page and "docs/teachers.md" in said.replace("\\", "/")


def test_the_page_of_a_student_has_their_code_beside_the_verdict(folder):
    write(folder / "Ann" / TOPICS, text("q1").replace("# ch02-q1 was done", "# <script>alert(1)</script>\\u202e"))
    row = grade(folder)[1]["Ann"]
    page = (folder.parent / "grades" / f"{row['key']}.html").read_text()
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in page and "<script>" not in page and "\u202e" not in page
    assert page.index("To improve") < page.index("Right")
    scores = json.loads((folder.parent / "grades" / f"{row['key']}.results.json").read_text())
    assert scores["score"] == 1 and len(scores["tests"]) == 4


def test_three_equal_works_of_five_are_listed(tmp_path):
    from coursekit.grade.mark import Marked
    from coursekit.grade.similar import similar

    def work(seed):
        return ["\n".join(f"def f{n}(a, b):\n    return a {'+-*/%'[(seed * n + n) % 5]} b ** {seed + n}" for n in range(12))]

    marks = [Marked(name, "", answers=work(seed)) for name, seed in (("a", 1), ("b", 1), ("c", 1), ("d", 7), ("e", 13))]
    assert [pair[:2] for pair in similar(marks)] == [("a", "b"), ("a", "c"), ("b", "c")]


def test_rows_are_whole_while_it_runs(folder, monkeypatch):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1"))
    table, seen = folder.parent / "grades.csv", []
    monkeypatch.setattr("coursekit.grade.bar.Bar.__call__", lambda *_: seen.append(rows(table)))
    grade(folder, "--roster", folder.parent / "moodle.csv", "--jobs", "1")
    assert [set(one) for one in seen] == [{"Ana García López", "Ben Ito"}] * 2
    assert sorted(row["status"] for row in seen[0].values()) == ["graded", "not marked"]
    assert not list(folder.parent.glob(".grades*"))


def test_what_was_marked_without_names_holds_when_names_are_shown(folder):
    grade(folder, "--chapters", "02", "--anonymous")
    table = folder.parent / "grades.csv"
    with open(table, newline="", encoding="utf-8-sig") as file:
        found = list(csv.DictReader(file))
    found[0] |= {"ch02.q1": "0.75", "comment": "Nearly."}
    with open(table, "w", newline="", encoding="utf-8") as file:
        made = csv.DictWriter(file, found[0].keys())
        made.writeheader()
        made.writerows(found)
    assert found[0]["student"].startswith("P-")
    for words in (("--anonymous",), (), ("--again",), ("--anonymous",), ()):
        _, after = grade(folder, "--chapters", "02", *words)
        (row,) = [one for one in after.values() if one["key"] and one["total"] != "0"]
        assert (row["ch02.q1"], row["comment"]) == ("0.75", "Nearly.")
        assert row["student"].startswith("P-") == ("--anonymous" in words)


def test_nobody_with_an_open_question_has_a_total_in_the_gradebook(folder):
    for name in ("x", "y"):
        write(folder / "Ito Ben_102_assignsubmission_file_" / name / TOPICS, text("q1" if name == "x" else "q2"))
    assert grade(folder, "--roster", folder.parent / "moodle.csv")[0] == 1
    found = {row[0]: row[3:5] for row in lines(folder.parent / "grades" / "gradebook.csv")[1:]}
    assert found == {"Ana García López": ["3", "3"], "Ben Ito": ["", ""]}


def test_whose_page_moodle_cannot_deal_out_is_told(folder, capsys):
    write(folder / "Ben Ito.ipynb", text("q1"))
    people = folder.parent / "participants.csv"
    people.write_text("First name;Last name;Email address\nAna;García López;ana@uni\nBen;Ito;ben@uni\n", encoding="utf-8")
    grade(folder, "--roster", people, "--for", "moodle")
    said = capsys.readouterr().out
    assert "! The zip of pages has none for Ben Ito: Moodle's number of them is not known. Download" in said
    with zipfile.ZipFile(folder.parent / "grades.feedback.zip") as packed:
        assert [name.split("_")[1] for name in packed.namelist()] == ["101"]
    grade(folder, "--roster", folder.parent / "moodle.csv", "--for", "moodle")
    assert "has none" not in capsys.readouterr().out


def test_a_list_of_participants_comes_back_with_its_separator_the_marks_and_the_comments(folder):
    people = folder.parent / "participants.csv"
    words = ("--roster", people, "--for", "moodle")
    people.write_text("First name;Last name;ID number\nAna;García López;a01\nBen;Ito;b02\n", encoding="utf-8")
    grade(folder, *words)
    edited(folder.parent / "grades.csv", student="Ana García López", comment="Well done")
    grade(folder, *words)
    with open(folder.parent / "grades.moodle.csv", encoding="utf-8-sig", newline="") as file:
        head, ana, _ = csv.reader(file, delimiter=";")
    assert head == ["First name", "Last name", "ID number", "coursekit 02", "coursekit 02 comments"]
    assert ana[:4] == ["Ana", "García López", "a01", "3"] and ana[4].endswith("Well done")


def test_a_teacher_s_own_columns_are_not_shown_to_the_student(folder):
    words = ("--roster", folder.parent / "plain.csv", "--for", "moodle")
    key = grade(folder, *words)[1]["Ana García López"]["key"]
    said = {"comment": "Well done", "ch02.q1 comment": "Shorter next time", "private": "copied?"}
    edited(folder.parent / "grades.csv", student="Ana García López", **said)
    row = grade(folder, *words)[1]["Ana García López"]
    assert row["private"] == "copied?"
    back = (folder.parent / "grades.moodle.csv").read_text(encoding="utf-8")
    for page in ((folder.parent / "grades" / f"{key}.html").read_text(), back):
        assert "Well done" in page and "Shorter next time" in page and "copied" not in page


def test_a_table_saved_with_decimal_commas_is_not_changed(folder, capsys):
    words = ("--due", "2026-11-22T10:26", "--roster", folder.parent / "moodle.csv")
    before = grade(folder, *words)[1]["Ana García López"]
    table = lines(folder.parent / "grades.csv")
    with_commas = [[one.replace(".", ",") if one.replace(".", "").isdigit() else one for one in row] for row in table]
    with_commas[1][table[0].index("minutes_late")] += ",0"
    with open(folder.parent / "grades.csv", "w", newline="", encoding="utf-8-sig") as out:
        csv.writer(out, delimiter=";").writerows(with_commas)
    capsys.readouterr()
    assert grade(folder, *words)[1]["Ana García López"] == before
    assert "!" not in capsys.readouterr().out


def test_a_total_by_hand_says_so_on_the_page(folder):
    words = ("--due", "2026-11-22T10:26", "--policy", folder.parent / "policy.toml")
    words[3].write_text("percent_per_day = 10\n", encoding="utf-8")
    key = grade(folder, *words)[1]["García López Ana"]["key"]
    page = folder.parent / "grades" / f"{key}.html"
    assert "after 20 % taken off for being late" in page.read_text()
    edited(folder.parent / "grades.csv", student="García López Ana", total="6")
    grade(folder, *words)
    assert "</b> of 7 points in 02_topics, given by hand" in page.read_text() and "taken off" not in page.read_text()


SPANISH = (
    "Identificador;Nombre completo;Dirección de correo;Estatus;Calificación;Calificación máxima;"
    "Última modificación (entrega);Comentarios de retroalimentación\n"
    'Participante101;"García López, Ana";ana@uni;;;100,00;-;\nParticipante102;"Ito, Ben";ben@uni;;;100,00;-;\n'
)
GERMAN = (
    "ID;Vollständiger Name;E-Mail-Adresse;Status;Bewertung;Bestwertung;Zuletzt geändert (Abgabe);Feedback als Kommentar\n"
    'Teilnehmer/in101;"García López, Ana";ana@uni;;;100,00;-;\nTeilnehmer/in102;"Ito, Ben";ben@uni;;;100,00;-;\n'
)
UNKNOWN = SPANISH.replace("Calificación;Cal", "Hodnocení;Cal").replace("Identificador;Nombre completo", "X;Y")


@pytest.mark.parametrize("sheet", [SPANISH, GERMAN, UNKNOWN], ids=["es", "de", "unknown words"])
def test_moodle_s_worksheet_is_known_in_other_languages(folder, sheet, capsys):
    people = folder.parent / "sheet.csv"
    people.write_text(sheet, encoding="utf-8-sig")
    _, found = grade(folder, "--roster", people, "--for", "moodle")
    assert set(found) == {"Ana García López", "Ben Ito"}
    with open(folder.parent / "grades.moodle.csv", encoding="utf-8-sig", newline="") as file:
        head, ana, ben = csv.reader(file, delimiter=";")
    assert head == sheet.splitlines()[0].split(";"), "no column is added"
    assert (ana[4], ben[4], ana[5]) == ("3", "0", "100,00") and "2 of 2 for" in ana[7]
    assert "maximum grade is 100,00, and these marks are of 7 points" in capsys.readouterr().out
    with zipfile.ZipFile(folder.parent / "grades.feedback.zip") as packed:
        assert [one.split("_")[1] for one in packed.namelist()] == ["101"]


def test_more_points_than_there_are_are_asked_about(folder, capsys):
    grade(folder)
    edited(folder.parent / "grades.csv", student="García López Ana", **{"ch02.q2": "9"})
    grade(folder)
    assert "! García López Ana: ch02.q2 is 9 by hand, and has 2 points. A bonus?" in capsys.readouterr().out


def test_pages_never_go_into_the_folder_of_what_was_handed_in(folder):
    with pytest.raises(SystemExit, match="its pages would go into the folder"):
        grade(folder, out=folder.with_suffix(".csv"))
    assert not folder.with_suffix(".csv").exists()
