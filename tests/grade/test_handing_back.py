"""Marks go back in the platform's own columns; names can be hidden."""

import csv
import html
import json
import zipfile

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade.statuses import STATUSES
from tests.needs import is_private

from .handed import NOON, TOPICS, answer, edited, grade, lines, notebook, rows, text, write, zipped


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
        pages_by_id = {member.split("_")[1]: packed.read(member).decode() for member in packed.namelist()}
    assert set(pages_by_id) == ({"101", "102"} if name else {"101", "102", "103"})
    assert "López" in pages_by_id["101"] and "Ben" in pages_by_id["102"] and "Ben" not in pages_by_id["101"]


def test_a_comment_reaches_also_whoever_handed_in_nothing(folder):
    words = ("--roster", folder.parent / "moodle.csv", "--for", "moodle")
    grade(folder, *words)
    edited(folder.parent / "grades.csv", student="Ben Ito", comment="Come and see me.")
    grade(folder, *words)
    with zipfile.ZipFile(folder.parent / "grades.feedback.zip") as packed:
        (own,) = [name for name in packed.namelist() if "_102_" in name]
        assert "Come and see me." in packed.read(own).decode()


def test_a_student_reads_their_page_in_the_language_of_the_notebook_that_they_handed_in(folder):
    spanish = notebook("q1")
    spanish["metadata"].setdefault("coursekit", {})["language"] = "es"
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, json.dumps(spanish), when=NOON + 26 * 3600)
    (folder.parent / "policy.toml").write_text("due = 2026-11-23T12:00:00\npercent_per_day = 10\n")
    words = ("--roster", folder.parent / "plain.csv", "--policy", folder.parent / "policy.toml", "--for", "moodle")
    grade(folder, *words, "--chapters", "02")
    with zipfile.ZipFile(folder.parent / "grades.feedback.zip") as packed:
        pages = {name.split("_")[1]: packed.read(name).decode() for name in packed.namelist()}
    assert '<html lang="es">' in pages["102"] and '<html lang="en">' in pages["101"]
    late = "1 día 2 h de retraso"
    for words in ("Por mejorar", "puntos en 02_topics, con 20 % menos por entrega tardía", late, "esperado"):
        assert words in pages["102"] and words not in pages["101"], words
    for words in ("To improve", "points in 02_topics", "expected"):
        assert words in pages["101"] and words not in pages["102"], words
    ana, ben = (" ".join(line) for line in lines(folder.parent / "grades.moodle.csv")[1:])
    assert late in ben and "1 of 1 for ch02.q1" in ana and "1 de 1 en ch02.q1" in ben


@pytest.mark.parametrize("code", ['en"><script>x</script>', "../words/es", "x" * 5000, "fr", 7, None])
def test_a_language_that_is_none_is_english(folder, code):
    odd = notebook("q1")
    odd["metadata"].setdefault("coursekit", {})["language"] = code
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, json.dumps(odd))
    key = grade(folder, "--roster", folder.parent / "moodle.csv", "--chapters", "02")[1]["Ben Ito"]["key"]
    page = (folder.parent / "grades" / f"{key}.html").read_text(encoding="utf-8")
    assert '<html lang="en">' in page and "To improve" in page and "<script>" not in page


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


def test_every_average_is_of_the_marks_after_lateness_and_says_so(folder, capsys):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1", "q2", "q3", "q4"), NOON + 30 * 3600)
    (folder.parent / "policy.toml").write_text("due = 2026-11-23T12:30:00\npercent_per_day = 10\n")
    rows_by_name = grade(folder, "--policy", folder.parent / "policy.toml")[1]
    assert [row["total"] for row in rows_by_name.values()] == ["3", "5.6"]
    words = "on average 4.30 of 7 points after lateness (2 students with work and a mark)"
    page = (folder.parent / "grades" / "class.html").read_text()
    assert words in capsys.readouterr().out and words in page
    kept = json.loads((folder.parent / "grades" / "statistics.json").read_text())
    assert (kept["mean"], kept["median"], kept["averaged"], kept["of"]) == (4.3, 4.3, 2, 7)
    assert kept["questions"]["ch02.q3"] == 0.5 and "Shares are before lateness" in page
    own = (folder.parent / "grades" / f"{rows_by_name['Ito Ben']['key']}.html").read_text()
    assert "<b>5.6</b> of 7 points in 02_topics, after 20 % taken off for being late" in own


def test_the_page_of_the_class_names_the_chapters(folder):
    grade(folder, "--chapters", "02", "03")
    page = (folder.parent / "grades" / "class.html").read_text()
    assert "<h1>The class: 02_topics, 03_services</h1>" in page


def test_names_are_hidden_and_who_is_who_lies_apart(folder):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1", own=" by Ben Ito"))
    write(folder / "Ito Ben_102_assignsubmission_file_" / "Ito.txt", "Ben Ito")
    words = ("--roster", folder.parent / "moodle.csv", "--anonymous")
    rows_by_name = grade(folder, *words)[1]
    assert all(name.startswith("P-") and len(name) == 10 for name in rows_by_name) and len(rows_by_name) == 2
    who = folder.parent / "grades.names.csv"
    assert is_private(who)
    assert {row[0]: row[1] for row in lines(who)[1:]}.keys() == rows_by_name.keys()
    shown = [
        folder.parent / "grades.csv",
        *(p for p in (folder.parent / "grades").iterdir() if p.suffix in (".html", ".json", ".csv")),
    ]
    for file in shown:
        said = file.read_text(encoding="utf-8-sig") + file.name
        assert not [word for word in ("García", "Ana ", "Ben", "Ito", "a01", "uni.example") if word in said], file.name
    assert grade(folder, *words)[1] == rows_by_name
    named = grade(folder, *words[:2])[1]
    assert sorted(row["total"] for row in named.values()) == sorted(row["total"] for row in rows_by_name.values())
    with pytest.raises(SystemExit, match="--for needs the names"):
        main(["grade", "--allow-root", str(folder), "--anonymous", "--for", "moodle"])


def test_what_could_not_be_read_is_told_with_its_reason(folder):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, "")
    sheet = folder.parent / "sheet.csv"
    heads = "Identifier,Full name,Email address,Grade,Feedback comments"
    sheet.write_text(f"{heads}\nParticipant 102,Ben Ito,ben@uni.example,,\n", encoding="utf-8")
    grade(folder, "--roster", sheet, "--for", "moodle")
    (row,) = [row for row in lines(folder.parent / "grades.moodle.csv") if "Ben Ito" in row]
    assert "the file is empty; 0 of 1 for ch02.q1" in row[-1], row


def test_table_page_and_closing_line_count_the_same(folder, capsys):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, "<html>")
    write(folder / "Nobody Known.zip", zipped({TOPICS: text("q1")}))
    status, rows_by_name = grade(folder, "--roster", folder.parent / "moodle.csv")
    said = capsys.readouterr().out
    counts = "2 students: 1 graded, 1 unreadable; 1 hand-in is nobody's yet"
    page = (folder.parent / "grades" / "class.html").read_text()
    assert counts in said and html.escape(counts) in page and status == 1 and "1 question is open:" in said
    assert {row["status"] for row in rows_by_name.values()} == {"graded", "unreadable"} and {
        row["status"] for row in rows_by_name.values()
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
    monkeypatch.setattr("coursekit.grade.marking_progress.Bar.__call__", lambda *_: seen.append(rows(table)))
    grade(folder, "--roster", folder.parent / "moodle.csv", "--jobs", "1")
    assert [set(rows_by_name) for rows_by_name in seen] == [{"Ana García López", "Ben Ito"}] * 2
    assert sorted(row["status"] for row in seen[0].values()) == ["graded", "not marked"]
    assert not list(folder.parent.glob(".grades*"))


def test_nobody_with_an_open_question_has_a_total_in_the_gradebook(folder):
    for name in ("x", "y"):
        write(folder / "Ito Ben_102_assignsubmission_file_" / name / TOPICS, text("q1" if name == "x" else "q2"))
    assert grade(folder, "--roster", folder.parent / "moodle.csv")[0] == 1
    marks_by_name = {row[0]: row[3:5] for row in lines(folder.parent / "grades" / "gradebook.csv")[1:]}
    assert marks_by_name == {"Ana García López": ["3", "3"], "Ben Ito": ["", ""]}


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
    _, rows_by_name = grade(folder, "--roster", people, "--for", "moodle")
    assert set(rows_by_name) == {"Ana García López", "Ben Ito"}
    with open(folder.parent / "grades.moodle.csv", encoding="utf-8-sig", newline="") as file:
        head, ana, ben = csv.reader(file, delimiter=";")
    assert head == sheet.splitlines()[0].split(";"), "no column is added"
    assert (ana[4], ben[4], ana[5]) == ("3", "0", "100,00") and "2 of 2 for" in ana[7]
    assert "maximum grade is 100,00, and these marks are of 7 points" in capsys.readouterr().out
    with zipfile.ZipFile(folder.parent / "grades.feedback.zip") as packed:
        assert [name.split("_")[1] for name in packed.namelist()] == ["101"]


def test_pages_never_go_into_the_folder_of_what_was_handed_in(folder):
    with pytest.raises(SystemExit, match="its pages would go into the folder"):
        grade(folder, out=folder.with_suffix(".csv"))
    assert not folder.with_suffix(".csv").exists()
