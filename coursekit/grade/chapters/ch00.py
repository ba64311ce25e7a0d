"""Chapter 0: getting oriented."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.figures.turtles import PAPER, walked
from coursekit.grade.outputs import way_of
from coursekit.grade.plain import is_number, shown
from coursekit.grade.student_name import EXERCISE, VARIABLE, whole_name
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work, is_text_of_number

TURTLESIM = "run turtlesim turtlesim_node"
CMD_VEL, POSE, TWIST = "/turtle1/cmd_vel", "/turtle1/pose", "geometry_msgs/msg/Twist"
KEYS = {"up": (2.0, 0.0), "down": (-2.0, 0.0), "left": (0.0, 2.0), "right": (0.0, -2.0)}
CHAPTERS = range(1, 10)
ROWS_OF_KEYS = {"asdf", "asdfg", "sdfg", "qwer", "qwert", "qwerty", "bla", "foo"}


@exercise(EXERCISE, "Who are you?", points=1, hints=("Write first and last name between quotes, with a space between.",))
def who(work: Work) -> None:
    """Check for a first and a last name."""
    me = work.value(VARIABLE, str)
    if not whole_name(me):
        cause = 'Do you have one name only? Then write a dash beside it: "Vera -".' if len(me.split()) == 1 else ""
        raise Wrong("a first and a last name", "", cause, gave=shown(me) if me.strip() else "an empty text", hint=0)


@exercise(
    "ch00.q2",
    "Keys",
    points=2,
    hints=(
        "It looks to the right at first: turn round before you drive.",
        "Half a turn is 3.14 rad; at 2 rad/s it takes 1.57 s.",
    ),
)
def keys(work: Work) -> None:
    """Check that the presses bring a fresh turtle to the left half."""
    plan, now = [], 0.5
    for press in work.value("presses", list):
        (forward, turn), seconds = _press(press)
        command = {"linear": {"x": forward}, "angular": {"z": turn}}
        steps = math.ceil(seconds / 0.5)
        plan += [(now + seconds * step / steps, CMD_VEL, TWIST, command) for step in range(steps)]
        now += seconds
    if now > 120:
        raise Wrong("presses of two minutes at most in all", gave=f"{now:.0f} s", hint=NO_HINT)
    plan.append((now, CMD_VEL, TWIST, {}))
    seen = work.try_out(beside=[TURTLESIM], seconds=now + 0.5, publish=plan, record=[POSE])
    places = way_of(seen, POSE)
    work.illustrate(walked, places, (0.0, 5.5, 0.0, PAPER))
    if any("hit the wall" in line for line in seen.beside):
        cause = "Press for a shorter time."
        raise Wrong("no wall on the way", "it hit one", cause, share=0.25, hint=NO_HINT, at=places[-1:])
    driven = sum(math.dist(one[:2], other[:2]) for one, other in pairwise(places))
    if not driven >= 3:
        raise Wrong("at least 3 m", f"{driven:.1f} m", share=0.25, hint=0)
    if not places[-1][0] < 5.5:
        where = f"x = {places[-1][0]:.2f}"
        raise Wrong("an end in the left half, x below 5.5", where, "Where does it look at the start?", share=0.5, hint=0)


def _press(press: Any) -> tuple[tuple[float, float], float]:
    """Return forward and angular velocity while these keys are pressed, and the duration."""
    if type(press) not in (tuple, list) or len(press) != 2 or type(press[0]) is not str:
        raise Wrong('a list of (keys, seconds), such as ("up", 1.0)', gave=shown(press), hint=NO_HINT)
    names = press[0].split("+")
    if any(name not in KEYS for name in names):
        cause = "They are written in small letters and without spaces; `+` joins two."
        raise Wrong(f"keys out of {', '.join(KEYS)}", gave=shown(press), cause=cause, hint=NO_HINT)
    if not is_number(press[1]) or not 0 < press[1] <= 20:
        raise Wrong("more than 0 and at most 20 seconds", gave=shown(press), cause=_why_no_seconds(press[1]), hint=NO_HINT)
    forward, turn = (sum(KEYS[name][part] for name in set(names)) for part in (0, 1))
    return (forward, turn), float(press[1])


def _why_no_seconds(seconds: Any) -> str:
    """Return the likely cause of a duration that is none; empty where there is no usual one."""
    if is_number(seconds) and seconds > 20:
        return "A key is pressed for so many seconds, not for so many degrees."
    return "A number stands without quotes." if is_text_of_number(seconds) else ""


@exercise(
    "ch00.q3",
    "What for?",
    points=1,
    hints=("A dictionary: {chapter number: 'a sentence', ...}.", "Whole sentences, each another one: what, and why?"),
)
def wishes(work: Work) -> None:
    """Check for three chapters, a sentence each."""
    answer = work.value("wishes", dict)
    good = {
        key: sentence for key, sentence in answer.items() if type(key) is int and key in CHAPTERS and _is_sentence(sentence)
    }
    wanted = f"a sentence for at least three chapters from {CHAPTERS[0]} to {CHAPTERS[-1]}"
    if len(good) < 3:
        what = ", ".join(str(key) for key in sorted(good)) or "none"
        cause = "A sentence has four words or more, with spaces between them."
        if sum(map(_is_sentence, answer.values())) >= 3:
            cause = f"Before the colons stand numbers of chapters, from {CHAPTERS[0]} to {CHAPTERS[-1]} and without quotes."
        raise Wrong(wanted, gave=f"sentences for: {what}", cause=cause)
    if len({" ".join(sorted(_words(sentence))) for sentence in good.values()}) < 3:
        raise Wrong(wanted, gave=shown(list(good.values())), cause="Each wish is another one.", hint=1)


def _words(sentence: str) -> set[str]:
    """Return the different plausible words of a sentence: of letters including vowels, in all languages of the course."""
    words = ("".join(letter for letter in word if letter.isalpha()).lower() for word in sentence.split())
    return {word for word in words if word}


def _is_sentence(text: Any) -> bool:
    """Whether a text reads like a sentence: four different words, most of them no rows of keys."""
    if type(text) is not str:
        return False
    words = _words(text)
    return len(words) >= 4 and sum(map(len, words)) >= 12 and not words & ROWS_OF_KEYS
