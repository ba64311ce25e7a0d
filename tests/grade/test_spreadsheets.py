"""Tables are written as the teacher's spreadsheet opens them, and what it saves is read back without false alarms."""

import csv
import io
from dataclasses import replace

import pytest

from coursekit.grade.roster import Roster
from coursekit.grade.tables import COMMA, SEMICOLON, Form, read_table

from .handed import NOON, TOPICS, answer, cheap_mark, edited, grade, lines, text, write

SPANISH = "Apellidos;Nombre;Número de ID\nGarcía López;Ana;a01\nIto;Ben;a02\n"


def half(*facts):
    """Marks with decimals, but for the course's own solutions."""
    marked = cheap_mark(*facts)
    if any("was done" in code for code in marked.answers):
        marked.verdicts = [replace(verdict, points=0.75 * verdict.points) for verdict in marked.verdicts]
    return marked


@pytest.fixture
def spanish(folder, monkeypatch):
    """A class whose list is a Spanish spreadsheet's; what they get has decimals."""
    monkeypatch.setattr("coursekit.grade.batch.mark", half)
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1"))
    return write(folder.parent / "lista.csv", SPANISH.encode("cp1252"))


def opened(file, separator, decimal):
    """The cells as a spreadsheet shows them: numbers where they are numbers of its language."""
    read = csv.reader(io.StringIO(file.read_text(encoding="utf-8-sig")), delimiter=separator)
    return [[_number(field, decimal) for field in row] for row in read]


def _number(text, decimal):
    plain = text.replace(decimal, "@", 1)
    return float(plain.replace("@", ".")) if plain.replace("@", "", 1).isdigit() else text


def saved(file, cells, separator, decimal, encoding):
    """What a spreadsheet saves."""
    buffer = io.StringIO()
    told = [[f"{value:g}".replace(".", decimal) if isinstance(value, float) else value for value in row] for row in cells]
    csv.writer(buffer, delimiter=separator).writerows(told)
    file.write_bytes(buffer.getvalue().encode(encoding, "replace"))


@pytest.mark.parametrize("encoding", ["cp1252", "mac-roman", "utf-8-sig"])
def test_a_spanish_spreadsheet_opens_the_marks_and_nothing_that_it_saves_is_told_as_a_change(
    folder, spanish, encoding, capsys
):
    write(folder / "Ito Ben_102_assignsubmission_file_" / "Ωρ \N{PENCIL} 02_topics.ipynb", text())  # in notes and attempts
    words = ("--roster", spanish, "--due", "2026-11-22T10:26")
    before = grade(folder, *words)[1]["Ana García López"]
    table = folder.parent / "grades.csv"
    cells = opened(table, ";", ",")
    head, ana = cells[0], cells[1]
    assert (ana[head.index("ch02.q1")], ana[head.index("total")]) == (0.75, 2.25)
    saved(table, cells, ";", ",", encoding)
    capsys.readouterr()
    assert grade(folder, *words)[1]["Ana García López"] == before
    assert "!" not in capsys.readouterr().out
    ana[head.index("ch02.q2")] = 0.5
    saved(table, cells, ";", ",", encoding)
    assert grade(folder, *words)[1]["Ana García López"]["total"] == "1,25"
    assert opened(folder.parent / "grades" / "gradebook.csv", ";", ",")[1][3:5] == [1.25, 1.25]


def test_the_form_of_the_marks_is_that_in_which_they_were_saved_last(folder):
    words = ("--roster", folder.parent / "moodle.csv")
    grade(folder, *words)
    table = folder.parent / "grades.csv"
    assert read_table(table).form == COMMA
    edited(table, student="Ana García López", **{"ch02.q1": "0,5"})
    assert grade(folder, *words)[1]["Ana García López"]["total"] == "2,5"
    assert read_table(table).form == SEMICOLON == read_table(folder.parent / "grades" / "gradebook.csv").form
    grade(folder, *words, "--csv", "comma")
    assert read_table(table).form == COMMA
    assert grade(folder, *words)[1]["Ana García López"]["total"] == "2.5"


@pytest.mark.parametrize(
    ("numbers", "form"),
    [(("100,00", "7"), SEMICOLON), (("100.00", "7"), Form(";", ".")), (("100", "7"), SEMICOLON)],
    ids=["Spanish", "Swiss", "no decimals"],
)
def test_a_list_tells_the_sign_of_decimals_by_its_own_numbers(tmp_path, numbers, form):
    table = "Name;Maximum grade\nAnn Lee;{}\nBen Ito;{}\n".format(*numbers)
    assert Roster.read(write(tmp_path / "list.csv", table)).form == form


def test_moodle_s_list_comes_back_with_marks_as_its_other_numbers(folder, spanish):
    sheet = (
        "Identificador;Nombre completo;Calificación;Calificación máxima\n"
        'Participante101;"García López, Ana";;100,00\nParticipante102;"Ito, Ben";;100,00\n'
    )
    grade(folder, "--roster", write(folder.parent / "sheet.csv", sheet), "--for", "moodle")
    assert [row[2] for row in lines(folder.parent / "grades.moodle.csv")] == ["Calificación", "2,25", "0,75"]
    assert "2,25" in next(row for row in lines(folder.parent / "grades.csv") if row[1].startswith("Ana"))


def test_where_a_list_is_no_moodle_s_own_its_table_has_the_list_s_form_and_canvas_gets_commas(folder, spanish):
    words = ("--roster", spanish, "--chapters", "02")
    grade(folder, *words, "--for", "canvas")
    assert lines(folder.parent / "grades.canvas.csv")[2][-1] == "2.25"
    assert read_table(folder.parent / "grades.canvas.csv").form == COMMA


def test_questions_are_asked_and_answered_in_that_form_too(folder, spanish):
    write(folder / "someone.ipynb", text("q3"), NOON + 60)
    grade(folder, "--roster", spanish)
    assert read_table(folder.parent / "questions.csv").separator == ";"
    answer(folder.parent / "questions.csv", someone="Ben")
    edited(folder.parent / "grades.csv", student="Ben Ito", comment="gut; =1+1")
    _, rows_by_name = grade(folder, "--roster", spanish)
    assert rows_by_name["Ben Ito"]["status"] != "question" and rows_by_name["Ben Ito"]["comment"] == "gut; '=1+1"
