"""How it stands with somebody's work is said with one word, the same everywhere."""

import pytest

from coursekit.grade.mark import Marked
from coursekit.grade.statuses import LOOK, STATUSES, by_status, status_of, told
from coursekit.grade.verdict import Verdict

OVER = Verdict("q", "t", 0, 1, got="it did not come to an end", timed_out=True)
FAULTY = Verdict("q", "t", 0, 1, fault="TypeError: no")
USUAL = {"opened": False, "handed_in": True, "late": False, "tier": "bubblewrap"}
CASES = {
    "graded": (Marked("", "", tier="bubblewrap"), {}),
    "late": (Marked("", "", tier="bubblewrap"), {"late": True}),
    "ran elsewhere": (Marked("", "", tier="limits"), {"late": True}),
    "timed out": (Marked("", "", [OVER], tier="limits"), {"late": True}),
    "empty": (Marked("", "", status="empty"), {"late": True}),
    "unreadable": (Marked("", "", status="unreadable"), {}),
    "not marked": (None, {}),
    "nothing handed in": (None, {"handed_in": False}),
    "question": (Marked("", "", [OVER]), {"opened": True}),
}


@pytest.mark.parametrize("status", CASES)
def test_the_first_that_is_so_is_the_status(status):
    marked, facts = CASES[status]
    assert status_of(marked, **{**USUAL, **facts}) == status


def test_every_status_can_be_reached_and_an_error_of_ours_is_no_mark():
    assert set(CASES) == set(STATUSES) and set(LOOK) == set(STATUSES) - {"graded", "late", "nothing handed in"}
    assert status_of(Marked("", "", status="error"), **USUAL) == "not marked"
    assert status_of(Marked("", "", [FAULTY], tier="bubblewrap"), **USUAL) == "not marked"


def test_words_of_a_student_s_are_no_status():
    said = Verdict("q", "t", 0, 1, got="'it took longer than 20 s, it did not answer in time, timed out'")
    assert status_of(Marked("", "", [said], tier="bubblewrap"), **USUAL) == "graded"


def test_counts_are_told_in_a_fixed_order():
    said = "2 graded, 1 late, 1 empty, 1 with an open question"
    assert told(by_status(["question", "graded", "late", "graded", "empty"])) == said
