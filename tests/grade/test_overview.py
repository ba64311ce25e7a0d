"""The class on one page."""

from coursekit.grade.mark import Marked
from coursekit.grade.overview import overview
from coursekit.grade.verdict import Verdict


def verdict(points):
    return Verdict("ch02.q1", "Names", points, 2, got="<b>7</b>")


def test_every_student_stands_there_with_marks_concerns_and_a_link():
    answer = "\n".join(f"def f{n}(a, b):\n    return a + b * {n} - {n + 1}" for n in range(9))
    marks = [
        Marked("ann lee", "", [verdict(2)], answers=[answer]),
        Marked("<ben>", "", [verdict(1)], notes=["ch02-q1: the cell is missing"], answers=[answer]),
        Marked("cem", "", [verdict(0)], concerns=["manifest.json: was changed"], minutes_late=5.5),
        Marked("dai", "", status="empty"),
    ]
    page = overview(marks)
    assert "<a href='ann%20lee.html'>ann lee</a>" in page and "&lt;ben&gt;" in page and "<ben>" not in page
    assert [kind in page for kind in ("class='all'", "class='some'", "class='none'")] == [True] * 3
    assert "class='eye'>manifest.json: was changed" in page and "<td>5.5</td>" in page and "<td>empty</td>" in page
    assert "<b>7</b>" not in page and "100 %" in page
    assert "alike" not in overview(marks[2:])
