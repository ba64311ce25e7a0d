"""Chapter 2: names, a listener, a relay in both languages, an own node."""

from __future__ import annotations

import re
from itertools import pairwise
from random import Random
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.outputs import expect_node, expect_subscription, heard, last_words, said, wrote
from coursekit.grade.plain import called, field, is_number, shown, text
from coursekit.grade.trial import EVERY_NODE_S, Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work
from coursekit.words.counting import counted

PACKAGE, CPP, STRING = "s2_py_pubsub", "s2_cpp_pubsub", "std_msgs/msg/String"
SECONDS = 6.0
"""How long a health node is observed [s]."""
AT_ONCE = 0.005
"""The maximum delay of an immediate answer [s]."""
SYLLABLES = ("ve", "ra", "lo", "mi", "ta", "gru", "ne", "sol", "pi", "do")


def _word(chance: Random) -> str:
    return "".join(chance.choice(SYLLABLES) for _ in range(3))


@exercise(
    "ch02.q1",
    "Names in the graph",
    points=1,
    hints=(
        "Three cases: the name begins with `/`, with `~`, or with neither.",
        "The namespace `/` ends with the slash that you would add. `rstrip` takes it away.",
    ),
)
def full_name(work: Work) -> None:
    """Check that names expand as in ROS, for nodes of any name."""
    from coursekit.rcl.names import expand

    function, chance = work.function("full_name"), work.dice("ch02.q1")
    for name in ("scan", "/scan", "~/scan", "a/b", "/a/b", _word(chance), "~"):  # the rarest last: then all others are right
        for namespace in ("/", "/vera", f"/fleet/{_word(chance)}"):
            node = chance.choice(("lidar", _word(chance)))
            told = f"full_name({name!r}, {node!r}, {namespace!r})"
            wanted = f"{told} that follows the rules of the table"
            got = text(called(function, name, node, namespace, told=told), wanted)
            if got != expand(name, node, namespace):
                raise _misnamed(name, wanted, got)


def _misnamed(name: str, wanted: str, got: str) -> Wrong:
    """Return the verdict on a wrong name; half of the points are earned if only `~` alone fails."""
    if "//" in got:
        return Wrong(wanted, gave=shown(got), cause="With the namespace '/', is there one slash too many?", hint=1)
    if name == "~":
        cause = "`~` alone is the node's own name in its namespace, with nothing after it. All other names are right."
        return Wrong(wanted, gave=shown(got), cause=cause, share=0.5, hint=0)
    return Wrong(wanted, gave=shown(got), hint=0)


@exercise(
    "ch02.q2",
    "A listener",
    points=2,
    hints=(
        "Make the subscription in the constructor: self.create_subscription(String, 'py_str_topic', self.heard, 10).",
        "The callback is a method that takes the message; its text is msg.data.",
    ),
)
def listener(work: Work) -> None:
    """Check that the node receives messages and logs each text once."""
    work.built(PACKAGE, "py_subscriber_node")
    chance = work.dice("ch02.q2")
    words = [f"{_word(chance)} {number}" for number in range(3)]
    spoken = [(0.5 + index, "/py_str_topic", STRING, {"data": word}) for index, word in enumerate(words)]
    seen = work.try_out(f"run {PACKAGE} subscriber_exe", publish=spoken, seconds=4.0)
    expect_node(seen, "/py_subscriber_node")
    expect_subscription(seen, "/py_str_topic", STRING, hint=0)
    output = said(seen)
    logged = re.findall(r"^\[INFO\] \[[0-9.]+\] \[py_subscriber_node\]: I heard: (.*)$", output, re.M)
    if logged != words:
        printed = all(f"I heard: {word}" in output for word in words)
        cause = "Does the callback log msg.data with self.get_logger().info(...)?"
        if printed and logged != words and not logged:
            cause = "These are printed, not logged: self.get_logger().info(...) adds level, time and node."
        elif not logged and all(re.search(rf"^\[INFO\] .*{word}", output, re.M) for word in words):
            cause = "These are logged with other words: is it 'I heard: ', and then the text, and nothing else?"
        wanted = "the node's log with: " + ", ".join(f"I heard: {word}" for word in words)
        raise Wrong(wanted, wrote(seen), cause, share=0.5, hint=1)


@exercise(
    "ch02.q3",
    "A relay",
    points=2,
    hints=(
        "The node has both: a publisher made in the constructor, and a subscription whose callback publishes.",
        "Texts in capitals: msg.data.upper().",
        "The callback itself publishes: one message goes out for each that comes in, without a timer.",
    ),
)
def relay(work: Work) -> None:
    """Check that each message is published in capitals, once and immediately, also in quick succession."""
    work.built(PACKAGE, "py_relay_node")
    _judge_relay(work, PACKAGE, "py", work.dice("ch02.q3"), "str has a method for it.")


def _judge_relay(work: Work, package: str, language: str, chance: Random, cause_of_case: str) -> None:
    """Judge the relay of a package, whose node and topics are named after the language."""
    hears, says = f"/{language}_str_topic", f"/{language}_upper_topic"
    texts = ["Vera is awake: 1", *(f"{_word(chance)} MiXed {number}" for number in range(7))]
    if language == "py":
        texts[1] = "grüß dich"  # a C++ text is bytes, and a letter may have two
    times = [0.5 + 0.4 * index + chance.uniform(0.0, 0.3) for index in range(len(texts) - 2)]
    times += [times[-1] + 0.011, times[-1] + 0.022]
    spoken = [(when, hears, STRING, {"data": text}) for when, text in zip(times, texts, strict=True)]
    seen = work.try_out(f"run {package} relay_exe", record=[says], publish=spoken, seconds=4.5)
    expect_node(seen, f"/{language}_relay_node")
    _expect_ends(seen, hears, says)
    answers = [(when, field(message, "data", str, says)) for when, message in heard(seen, says)]
    got = [answer for _, answer in answers]
    if [word.casefold() for word in got] != [word.casefold() for word in texts]:
        wanted = f"{len(texts)} messages, one for each that came in"
        cause = "Does a timer publish? It misses what comes in between, or sends it twice." if got else ""
        raise Wrong(wanted, f"{counted(len(got), 'message')}: {shown(got)}", cause, share=0.25, hint=2 if got else 0)
    if got != [word.upper() for word in texts]:
        raise Wrong("texts in capitals", shown(got), cause_of_case, share=0.5, hint=1)
    late = [when - came for (when, _), came in zip(answers, times, strict=True)]
    if not max(late) <= AT_ONCE:
        cause = "Publish in the callback, not on a timer."
        raise Wrong("an answer at once", f"{max(late):.3f} s later", cause, share=0.5, hint=2)


def _expect_ends(seen: Seen, hears: str, says: str) -> None:
    """Raise Wrong unless the relay subscribes to one topic and publishes on the other."""
    if not seen.publishers.get(says):
        names = ", ".join(name for name, ends in seen.publishers.items() if ends and name not in EVERY_NODE_S) or "none"
        raise Wrong(f"a publisher on {says}", f"publishers: {names}", "Is the topic's name right?", hint=0)
    expect_subscription(seen, hears, STRING, hint=0)


@exercise(
    "ch02.q5",
    "A relay in C++",
    points=0,
    hints=(
        "Both lines stand in this chapter's C++ nodes: create_publisher<String>(topic, 10), and create_subscription with a "
        "lambda. Keep what they return in the members of the class.",
        "The lambda may take the message by value, `[this](String msg)`: then it can change the text and publish it.",
        "The callback itself publishes: one message goes out for each that comes in, without a timer.",
    ),
)
def relay_in_cpp(work: Work) -> None:
    """Check the same relay between the topics of the C++ nodes."""
    work.compiled(CPP, "cpp_relay_node")
    cause = "`std::toupper` makes one letter a capital: is every letter changed?"
    _judge_relay(work, CPP, "cpp", work.dice("ch02.q5"), cause)


@exercise(
    "ch02.q4",
    "Vera's health",
    points=2,
    hints=(
        "Two create_publisher lines with different types, one timer that publishes on both.",
        "std_msgs/msg has Float64, Int32, Bool, String and more: `%ros2 interface package std_msgs`.",
        "The timer's period is between 0.05 and 1 second, and its callback calls publish() of both publishers.",
        "Count or compute something in the callback, so that each message has another value.",
    ),
)
def health(work: Work) -> None:
    """Check for two topics of different types, at 1 to 20 Hz, with changing values."""
    work.built(PACKAGE, "py_health_node")
    seen = work.try_out(f"run {PACKAGE} health_exe", record=["*"], seconds=SECONDS)
    own = {name: types[0] for name, types in seen.topics.items() if name not in EVERY_NODE_S and seen.publishers.get(name)}
    if len(set(own.values())) < 2:
        what = ", ".join(f"{name} ({kind})" for name, kind in own.items()) or f"none; it said: {last_words(said(seen))}"
        causes = ("Was it built after the last change?", "Is there a second one?", "They have the same type.")
        raise Wrong("at least two topics of different types", what, causes[min(len(own), 2)], hint=0)
    for name in own:
        _judge_health(name, heard(seen, name))


def _judge_health(topic: str, messages: list[tuple[float, Any]]) -> None:
    wanted = f"{topic} between 1 and 20 times a second"
    if len(messages) < SECONDS - 2:
        cause = "" if messages else f"Does the timer's callback publish on {topic}, too? Is the period in seconds?"
        raise Wrong(wanted, f"{counted(len(messages), 'message')} in {SECONDS:g} s", cause, share=0.5, hint=2)
    gaps = sorted(after - before for (before, _), (after, _) in pairwise(messages))
    usual = gaps[len(gaps) // 2]
    if not (is_number(usual) and 1 / 20.5 <= usual <= 1.01 and gaps[-1] <= 2.02):
        got = f"one each {usual:.3f} s" + (f", once {gaps[-1]:.1f} s" if gaps[-1] > 1.01 else "")
        raise Wrong(wanted, got, share=0.5, hint=2)
    if len({repr(message) for _, message in messages}) < 2:
        raise Wrong(f"values on {topic} that change", f"always {shown(messages[0][1])}", share=0.5, hint=3)
