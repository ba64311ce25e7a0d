"""What the checks of chapter 0 say of keys, seconds and wishes that are not as asked for."""

import pytest

from tests.grade.tried import told_of

SENTENCES = ["I want to learn about nodes.", "My robot shall tell me things.", "I want to ask it questions."]


@pytest.mark.parametrize(
    ("press", "cause"),
    [
        (("Left", 1.57), "small letters"),
        (("left ", 1.57), "without spaces"),
        (("left", "1.57"), "without quotes"),
        (("left", 180), "not for so many degrees"),
    ],
)
def test_of_a_press_the_part_that_is_wrong_is_named(tmp_path, press, cause):
    assert cause in told_of("ch00.q2", {"presses": [press]}, tmp_path).cause


@pytest.mark.parametrize("seconds", [0, -1, None, True, float("nan"), "long", "nan"])
def test_of_seconds_that_are_neither_degrees_nor_between_quotes_nothing_is_guessed(tmp_path, seconds):
    said = told_of("ch00.q2", {"presses": [("left", seconds)]}, tmp_path)
    assert said.expected == "more than 0 and at most 20 seconds" and not said.cause


@pytest.mark.parametrize("chapters", [["1", "2", "3"], [0, 2, 3], ["two", "three", "four"]])
def test_sentences_beside_other_numbers_are_not_told_to_be_too_short(tmp_path, chapters):
    said = told_of("ch00.q3", {"wishes": dict(zip(chapters, SENTENCES, strict=True))}, tmp_path)
    assert "numbers of chapters" in said.cause and "four words" not in said.cause


def test_too_few_words_are_told(tmp_path):
    assert "four words" in told_of("ch00.q3", {"wishes": {1: "nodes", 2: "topics", 3: "maps"}}, tmp_path).cause


@pytest.mark.parametrize(("me", "cause"), [("Vera", "write a dash beside it"), (" ", ""), ("Vera 7", "")])
def test_who_has_one_name_is_told_what_to_write(tmp_path, me, cause):
    said = told_of("ch00.q1", {"me": me}, tmp_path)
    assert cause in said.cause and bool(said.cause) == bool(cause)
