"""Chapter 0: finding one's way."""

from __future__ import annotations

import math
from itertools import pairwise

from coursekit.grade.exercise import exercise
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

CMD_VEL, POSE, TWIST = "/turtle1/cmd_vel", "/turtle1/pose", "geometry_msgs/msg/Twist"
KEYS = {"up": (2.0, 0.0), "down": (-2.0, 0.0), "left": (0.0, 2.0), "right": (0.0, -2.0)}


@exercise("ch00.q1", "Who are you?", points=1, hints=("Text stands between quotes, first name and last name with a space.",))
def who(work: Work) -> None:
    """A name of at least two words."""
    me = work.value("me", str)
    if len(me.split()) < 2 or not all(word[0].isalpha() for word in me.split()):
        raise Wrong("a first and a last name", repr(me) if me.strip() else "an empty text")


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
    """The presses bring a fresh turtle to the left half."""
    presses = work.value("presses", list)
    plan, now = [], 0.5
    for press in presses:
        if not (isinstance(press, tuple) and len(press) == 2 and isinstance(press[0], str)):
            raise Wrong("a list of (keys, seconds)", repr(press)[:80])
        names, seconds = press[0].split("+"), float(press[1])
        unknown = [name for name in names if name not in KEYS]
        if unknown or not 0 < seconds <= 20:
            raise Wrong(f"keys out of {', '.join(KEYS)} and 0 to 20 seconds", repr(press))
        forward, turn = (sum(KEYS[name][part] for name in names) for part in (0, 1))
        command = {"linear": {"x": forward}, "angular": {"z": turn}}
        steps = math.ceil(seconds / 0.5)
        plan += [(now + seconds * step / steps, CMD_VEL, TWIST, command) for step in range(steps)]
        now += seconds
    plan.append((now, CMD_VEL, TWIST, {}))
    seen = work.try_out("run turtlesim turtlesim_node", seconds=now + 0.5, publish=plan, record=[POSE])
    poses = [(pose["x"], pose["y"]) for _, pose in seen.messages[POSE]]
    driven = sum(math.dist(one, other) for one, other in pairwise(poses))
    if "hit the wall" in seen.outputs[0]:
        raise Wrong("no wall on the way", "it hit one", "Press for a shorter time.", share=0.25)
    if driven < 3:
        raise Wrong("at least 3 m", f"{driven:.1f} m", share=0.25)
    if poses[-1][0] >= 5.5:
        seen_at = f"x = {poses[-1][0]:.2f}"
        raise Wrong("an end in the left half, x below 5.5", seen_at, "Where does it look at the start?", share=0.5)


@exercise("ch00.q3", "What for?", points=1, hints=("A dictionary: {chapter number: 'a sentence', ...}.",))
def wishes(work: Work) -> None:
    """Three chapters, a sentence each."""
    found = work.value("wishes", dict)
    good = {key for key, text in found.items() if key in range(1, 9) and isinstance(text, str) and len(text.split()) >= 4}
    if len(good) < 3:
        raise Wrong("a sentence for at least three chapters from 1 to 8", f"sentences for: {sorted(good) or 'none'}")
