"""What a teacher writes into the table: kept over every run, told, and shown to whom it is meant for."""

import csv

from .handed import NOON, SERVICES, TOPICS, edited, grade, lines, text, write


def test_points_and_comments_by_hand_are_kept_and_told(folder, capsys):
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1"))
    words = ("--roster", folder.parent / "moodle.csv")
    before = grade(folder, *words)[1]["Ben Ito"]
    edited(folder.parent / "grades.csv", student="Ben Ito", comment="Well tried; =see me", oral="2", **{"ch02.q2": "1,5"})
    for _ in range(2):
        capsys.readouterr()
        row = grade(folder, *words, "--again")[1]["Ben Ito"]
        assert (row["ch02.q2"], row["total"], row["comment"], row["oral"]) == ("1,5", "2,5", "Well tried;' =see me".replace(
            ";' =", "; '="), "2")  # fmt: skip
        assert "ch02.q2: 1.5 by hand" in row["notes"]
    page = (folder.parent / "grades" / f"{row['key']}.html").read_text()
    assert "Well tried" in page and "given by hand" in page
    write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q1", "q3"), NOON + 60)
    assert grade(folder, *words)[1]["Ben Ito"]["total"] == "4,5"
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


def test_what_was_marked_without_names_holds_when_names_are_shown(folder):
    grade(folder, "--chapters", "02", "--anonymous")
    table = folder.parent / "grades.csv"
    with open(table, newline="", encoding="utf-8-sig") as file:
        records = list(csv.DictReader(file))
    records[0] |= {"ch02.q1": "0.75", "comment": "Nearly."}
    with open(table, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, records[0].keys())
        writer.writeheader()
        writer.writerows(records)
    assert records[0]["student"].startswith("P-")
    for words in (("--anonymous",), (), ("--again",), ("--anonymous",), ()):
        _, after = grade(folder, "--chapters", "02", *words)
        (row,) = [record for record in after.values() if record["key"] and record["total"] != "0"]
        assert (row["ch02.q1"], row["comment"]) == ("0.75", "Nearly.")
        assert row["student"].startswith("P-") == ("--anonymous" in words)


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
    with_commas = [
        [field.replace(".", ",") if field.replace(".", "").isdigit() else field for field in row] for row in table
    ]
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


def test_more_points_than_there_are_are_asked_about(folder, capsys):
    grade(folder)
    edited(folder.parent / "grades.csv", student="García López Ana", **{"ch02.q2": "9"})
    grade(folder)
    assert "! García López Ana: ch02.q2 is 9 by hand, and has 2 points. A bonus?" in capsys.readouterr().out
