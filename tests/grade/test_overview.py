"""The class on one page."""

import json

from coursekit.grade.collector import Collection
from coursekit.grade.mark import Marked
from coursekit.grade.outcome import Outcome
from coursekit.grade.overview import overview
from coursekit.grade.person_submission import PersonSubmission
from coursekit.grade.questions import Question
from coursekit.grade.record import Late, Record
from coursekit.grade.roster import Person
from coursekit.grade.statistics import average, write_statistics
from coursekit.grade.submission_parts import Entry, Piece
from coursekit.grade.verdict import Verdict

CHAPTER = "02_topics.ipynb"


def verdict(points, got="<b>7</b>"):
    return Verdict("ch02.q1", "Names", points, 2, got=got)


def record(name, *verdicts, **more):
    """Somebody's line; of somebody who handed in an empty folder if there are no verdicts."""
    handed = PersonSubmission(Person(name), name, [Entry(name)])
    new_record = Record(handed, {CHAPTER: [verdict(0, "nothing was handed in")]}, tier="bubblewrap")
    if verdicts:
        handed.chosen[CHAPTER] = Piece(CHAPTER, CHAPTER)
        new_record.marks[CHAPTER] = Marked(name, "", list(verdicts), tier="bubblewrap", **more)
    return new_record


def test_every_student_stands_there_with_marks_concerns_and_a_link():
    answer = "\n".join(f"def f{n}(a, b):\n    return a + b * {n} - {n + 1}" for n in range(9))
    records = [
        record("ann lee", verdict(2), answers=[answer]),
        record("<ben>", verdict(1), notes=["ch02-q1: the cell is missing"], answers=[answer]),
        record("cem", verdict(0), concerns=["manifest.json: was changed"]),
        record("dai"),
    ]
    records[2].late[CHAPTER] = Late(5.5)
    page = overview(records)
    assert f"<a href='{records[0].key}.html'>ann lee</a>" in page and "&lt;ben&gt;" in page and "<ben>" not in page
    assert [kind in page for kind in ("class='all'", "class='some'", "class='none'")] == [True] * 3
    assert "class='eye'>manifest.json: was changed" in page and ">empty</td>" in page
    assert "<td class='late'>5 min</td>" in page
    assert "<b>7</b>" not in page and "100 %" in page
    assert "alike" not in overview(records[2:])


def test_the_hardest_exercise_and_the_most_frequent_wrong_answer_come_first():
    easy = Verdict("ch02.q2", "A listener", 2, 2)
    seen = ["no node", "no node", "a\x1b[2Jb", "no node"]
    page = overview([record(f"s{number}", verdict(0, got), easy) for number, got in enumerate(seen)])
    hardest = page[page.index("the hardest first") : page.index("All students")]
    assert hardest.index("ch02.q1") < hardest.index("ch02.q2") and hardest.index("3 × no node") < hardest.index("1 × a [2Jb")


def test_wrong_answers_stand_there_as_they_were_typed():
    gave = ["['topic list', 'a < b']", "'/scan'", "a list: [(1, 'x')]", "[" * 150, "9" * 159, "['ab', 'c…", "[…", "\\"]
    page = overview([record(f"s{n}", Verdict("ch02.q1", "Names", 0, 2, gave=answer)) for n, answer in enumerate(gave)])
    for answer in gave[3:]:
        overview([record("s", Verdict("ch02.q1", "Names", 0, 2, gave=answer))])
    assert "1 × topic list | a &lt; b" in page and "1 × /scan" in page and "1 × a list: (1, &#x27;x&#x27;)" in page


def test_who_needs_a_look_says_which_exercise_took_too_long_or_has_a_faulty_check():
    over = Verdict("ch02.q1", "Names", 0, 2, got="x", timed_out=True)
    faulty = Verdict("ch02.q1", "Names", 0, 2, fault="TypeError: no")
    page = overview([record("ann", over), record("ben", faulty), record("cem", verdict(1))])
    look = page[page.index("Needs a look") : page.index("the hardest first")]
    assert "ch02.q1: its time was over" in look and "ch02.q1: its check has a fault" in look and "cem" not in look
    assert look.index("ben") < look.index("ann") and "not marked" in look and "timed out" in look


def test_a_question_says_where_it_is_answered():
    asked = Question("Q1", "Whose is it?", "x.ipynb")
    outcome = Outcome([record("ann", verdict(1))], Collection([], [], [], whose=[("x.ipynb", asked)], unanswered=[asked]))
    assert "Answer the questions in <code>questions.csv</code>" in overview(outcome.records, outcome)
    assert "questions.csv" not in overview([record("ann"), record("ben")])


def test_what_was_taken_off_stands_beside_the_total():
    late = record("ann", verdict(2))
    late.late[CHAPTER] = Late(1536.2, percent_off=20)
    assert "<td class='late'>1 day 1 h</td><td>20 %</td>" in overview([late])


def test_text_and_picture_tell_one_mean(tmp_path, monkeypatch):
    titles = []
    monkeypatch.setattr("matplotlib.axes.Axes.set_title", lambda axes, title, **more: titles.append(title))
    records = [record(f"s{number}", verdict(points)) for number, points in enumerate((1.44, 1.45))]
    write_statistics(tmp_path, records, {})
    told = json.loads((tmp_path / "statistics.json").read_text())["mean"]
    assert f"on average {told:.2f} of" in average(records) and f"mean {told:.2f} of" in " ".join(titles)


def test_an_empty_hand_in_counts_in_no_average():
    assert "(1 student with work and a mark)" in average([record("ann", verdict(2)), record("dai")])
