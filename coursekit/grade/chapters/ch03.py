"""Chapter 3: a service callback, a client program, a server that is also a client, an own switch, a gripper in C++."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.outputs import exit_code, expect_node, heard, last_words, said, wrote
from coursekit.grade.plain import called, field, is_number, shown
from coursekit.grade.trial import EVERY_NODE_S, Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work
from coursekit.words.counting import counted

PACKAGE, CPP = "s3_py_srvcli", "s3_cpp_srvcli"
ADD = "example_interfaces/srv/AddTwoInts"
SET = "std_srvs/srv/SetBool"
SERVER = "run coursekit_robots odd_adder --ros-args -r add_two_ints:=/py_add_two_ints_service -p more:="
"""The course's server for the students' requests: its answer is not the sum."""
LAMP_SECONDS = 9.0
"""How long a switch is observed [s]."""


@exercise(
    "ch03.q1",
    "A callback that answers",
    points=1,
    hints=(
        "It works exactly when request.data differs from state['holding'].",
        "Fill in both fields of the response in every case, and return it in every case.",
    ),
)
def lift(work: Work) -> None:
    """Check that lifting and putting down alternate; impossible requests must change nothing."""
    from std_srvs.srv import SetBool

    function, state = work.function("lift"), work.value("state", dict)
    before = dict(state)
    try:
        for wanted, holding, succeeds in ((1, 0, 1), (1, 1, 0), (0, 1, 1), (0, 0, 0)):
            state["holding"] = bool(holding)
            case = f"{'lift' if wanted else 'put down'} with {'a box' if holding else 'empty hands'}"
            response = called(function, SetBool.Request(data=bool(wanted)), SetBool.Response(), told=f"lift: {case}")
            if type(response) is not SetBool.Response:
                cause = "Is there a `return response` in every case?"
                raise Wrong(f"{case}: the response, returned", gave=shown(response), cause=cause, hint=1)
            state = work.value("state", dict)
            _expect_lift(response, state.get("holding"), case, bool(succeeds), bool(wanted if succeeds else holding))
    finally:
        state.update(before)


def _expect_lift(response: Any, after: Any, case: str, succeeds: bool, holds: bool) -> None:
    if response.success is not succeeds:
        raise Wrong(f"{case}: success is {succeeds}", gave=shown(response.success), hint=0)
    if after is not holds:
        raise Wrong(f"{case}: state['holding'] is {holds} afterwards", gave=shown(after), hint=0)
    if type(response.message) is not str or not response.message.strip():
        raise Wrong(f"{case}: a message in words", gave="an empty message", share=0.5, hint=1)


@exercise(
    "ch03.q2",
    "The client as a program",
    points=2,
    hints=(
        "Look at len(sys.argv) before anything else; `return 1` ends main with that exit status.",
        "node.ask(a, b) gives a future. Spin until it is complete, then its result() has the field sum.",
    ),
)
def client(work: Work) -> None:
    """Check that the service's answer for two numbers is logged; other counts give the usage line and exit status 1."""
    work.built(PACKAGE, "client_main", "py_client_async_node", "running")
    for words in ("", "17", "1 2 3"):
        _expect_usage(work.try_out(f"run {PACKAGE} client_exe {words}", seconds=1.5), words)
    chance = work.dice("ch03.q2")
    for _ in range(2):
        a, b, more = chance.randint(-99, 99), chance.randint(1, 999), chance.randint(3, 60)
        seen = work.try_out(f"run {PACKAGE} client_exe {a} {b}", beside=[f"{SERVER}{more}"], seconds=3.0)
        _judge_client(seen, a, b, a + b + more)


def _judge_client(seen: Seen, a: int, b: int, answer: int) -> None:
    output = said(seen).strip()
    if f"asked for {a} and {b}" not in "".join(seen.beside):
        wanted = f"client_exe {a} {b} asks the service for {a} and {b}"
        raise Wrong(wanted, wrote(seen, "the server was not asked"), hint=1)
    if f"{a} + {b} = {answer}" not in [line.rpartition("]: ")[2].strip() for line in output.splitlines()]:
        cause = "The check's server counts differently: log its response, not your sum." if f"= {a + b}" in output else ""
        wanted = f"client_exe {a} {b} logs the server's response: {a} + {b} = {answer}"
        raise Wrong(wanted, wrote(seen, "nothing"), cause, share=0.5, hint=1)
    if not re.search(rf"^\[INFO\] .*\[py_client_async_node\]: {a} \+ {b} = {answer}$", output, re.M):
        raise Wrong("the line from the node's logger", wrote(seen), "node.get_logger().info(...)", share=0.75)
    if exit_code(seen) != 0:
        cause = "After the answer main has to end: no rclpy.spin, and it returns None or 0."
        raise Wrong("exit status 0 as soon as the answer is there", f"{exit_code(seen)}", cause, share=0.5)


def _expect_usage(seen: Seen, words: str) -> None:
    call = f"client_exe {words}".strip()
    lines = [line for line in said(seen).splitlines() if not line.startswith("[ros2run]")]
    if "usage: client_exe A B" not in [line.strip() for line in lines]:
        raise Wrong(f"{call}: the line `usage: client_exe A B`", wrote(seen), hint=0)
    if exit_code(seen) != 1:
        cause = "sys.argv holds the program's name too. `return 1` gives the exit status."
        raise Wrong(f"{call}: exit status 1", f"exit status {exit_code(seen)}", cause, share=0.5, hint=0)


@exercise(
    "ch03.q3",
    "The gate asks the server",
    points=2,
    hints=(
        "The node has a client and a service, both made in the constructor.",
        "`async def`, and in it `await self.client.call_async(...)`: the result of await is the response.",
        "The client needs a callback group of its own, or its answer waits for the end of your callback.",
    ),
)
def gate(work: Work) -> None:
    """Check that the gate's answer is the server's plus the boxes at the gate; the server does not return the sum."""
    work.built(PACKAGE, "py_gate_node", "gate_main", "running")
    boxes, chance = work.variant("boxes", 10), work.dice("ch03.q3")
    more = chance.randint(20, 70)
    questions = [(chance.randint(-50, 99), chance.randint(-50, 99)) for _ in range(3)]
    calls = [(1.0 + at, "/py_gate_service", ADD, {"a": a, "b": b}) for at, (a, b) in enumerate(questions)]
    seen = work.try_out(f"run {PACKAGE} gate_exe", beside=[f"{SERVER}{more}"], call=calls, seconds=5.0)
    expect_node(seen, "/py_gate_node")
    if "/py_gate_service" not in seen.services:
        others = ", ".join(name for name in seen.services if not name.rpartition("/")[0].endswith("_node")) or "none"
        raise Wrong("a service /py_gate_service", f"services: {others}", "Is create_service in the constructor?", hint=0)
    if len(seen.responses) < 1 or seen.responses[0] is None:
        cause = "The server was not asked: is the client's service py_add_two_ints_service, and does the callback call it?"
        if "asked for " in "".join(seen.beside):
            cause = "A deadlock? Both are needed: `await` with `call_async`, and a group of its own for the client."
        last = last_words(said(seen))
        raise Wrong(f"an answer to {questions[0]}", f"none came; the program said: {last}", cause, hint=2)
    for (a, b), response in zip(questions, seen.responses, strict=True):
        told = f"for a={a}, b={b} the server's response ({a + b + more}; it counts differently), and {boxes} more"
        got = field(response, "sum", int, told)
        if got != a + b + more + boxes:
            cause = "That is the sum by itself. Ask the server." if got == a + b + boxes else ""
            cause = "That is the server's response. Add the boxes." if got == a + b + more else cause
            raise Wrong(told, f"{got}", cause, share=0.25, hint=1)
    asked = "".join(seen.beside).count("asked for ")
    if asked < len(questions):
        raise Wrong("py_add_two_ints_service is asked each time", f"asked {asked} times", "Ask it.", share=0.25, hint=1)


@exercise(
    "ch03.q4",
    "A switch of your own",
    points=2,
    hints=(
        "One attribute, self.on: the service's callback sets it, a timer publishes it.",
        "std_msgs/msg/Bool is the simplest topic for it; the response needs success = True and a message.",
    ),
)
def switch(work: Work) -> None:
    """Check for a SetBool service whose state is visible on a topic."""
    work.built(PACKAGE, "py_switch_node", "switch_main", "running")
    command = f"run {PACKAGE} switch_exe"
    first = work.try_out(command, seconds=1.0)
    services = [name for name, types in first.services.items() if SET in types]
    if not services:
        last = last_words(said(first))
        cause = "Was it built after the last change?"
        raise Wrong(f"a service of type {SET}", f"none; the program said: {last}", cause, hint=0)
    topics = [name for name in first.topics if name not in EVERY_NODE_S and first.publishers.get(name)]
    if not topics:
        raise Wrong("a topic that shows whether it is on", "the node publishes nothing", share=0.25, hint=0)
    calls = [(when, services[0], SET, {"data": on}) for when, on in ((3.05, True), (6.05, False))]
    seen = work.try_out(command, call=calls, record=topics, seconds=LAMP_SECONDS)
    for (_, name, _, request), response in zip(calls, seen.responses, strict=True):
        told = f"{name} answers {request}: success, and a message"
        if field(response, "success", bool, told) is not True or not field(response, "message", str, told).strip():
            raise Wrong(told, shown(response), share=0.25, hint=1)
    if not any(_shows(heard(seen, name)) for name in topics):
        wanted = "a topic, at least once a second, that differs between on and off"
        raise Wrong(wanted, *_unshown({name: len(heard(seen, name)) for name in topics}), share=0.5, hint=0)


def _unshown(counts: dict[str, int]) -> tuple[str, str]:
    """Return the verdict on topics whose many messages do not show the state."""
    if max(counts.values()) < LAMP_SECONDS - 2:
        told = " and ".join(f"{counted(count, 'message')} on {name}" for name, count in counts.items())
        return f"{told} in {LAMP_SECONDS:g} s", "Does a timer publish it, and not the service's callback alone?"
    told = f"no difference on {', '.join(counts)} before, while and after it was on"
    return told, "Does the callback keep what it was told in self? Before it was on and after, the same has to be published."


def _shows(messages: Sequence[tuple[float, Any]]) -> bool:
    """Whether some field distinguishes on (3 to 6 s) from off (before and after), by its values or by their size."""
    parts = [[_leaves(msg) for when, msg in messages if start <= when < start + 2.9] for start in (0.0, 3.1, 6.1)]
    if min(len(part) for part in parts) < 2:
        return False
    names = set.intersection(*(set(fields) for part in parts for fields in part))
    return any(_tells(*([fields[name] for fields in part] for part in parts)) for name in names)


def _leaves(message: Any, name: str = "") -> dict[str, Any]:
    """Return the plain values in a message by path; numbers within texts, such as times, are removed."""
    inner: Iterator[tuple[Any, Any]] = iter(())
    if isinstance(message, dict):
        inner = iter(message.items())
    elif isinstance(message, list):
        inner = iter(enumerate(message[:100]))
    else:
        return {name: re.sub(r"\d+", "#", message) if isinstance(message, str) else message}
    return {place: leaf for key, value in inner for place, leaf in _leaves(value, f"{name}.{key}").items()}


def _tells(before: list[Any], on: list[Any], after: list[Any]) -> bool:
    if all(is_number(value) for value in before + on + after):
        return min(on) > max(before + after) or max(on) < min(before + after)
    said_on, said_off = {repr(value) for value in on}, ({repr(value) for value in before}, {repr(value) for value in after})
    return not said_on & (said_off[0] | said_off[1]) and bool(said_off[0] & said_off[1])


@exercise(
    "ch03.q5",
    "A gripper in C++",
    points=0,
    hints=(
        "It works exactly when request.data differs from holding_.",
        "Fill in both fields of the response in every case: response.success and response.message. Nothing is returned.",
    ),
)
def gripper(work: Work) -> None:
    """Check that lifting and putting down alternate in any order of requests; impossible requests must change nothing."""
    work.compiled(CPP, "cpp_gripper_node")
    chance = work.dice("ch03.q5")
    asked = [True, True, False, False, *(chance.random() < 0.5 for _ in range(8))]
    calls = [(1.0 + 0.25 * at, "/cpp_gripper_service", SET, {"data": lift}) for at, lift in enumerate(asked)]
    seen = work.try_out(f"run {CPP} gripper_exe", call=calls, seconds=5.0)
    expect_node(seen, "/cpp_gripper_node")
    holds = False
    for number, (lift, response) in enumerate(zip(asked, seen.responses, strict=True), 1):
        case = f"request {number}, to {'lift' if lift else 'put down'} with {'a box' if holds else 'empty hands'}"
        succeeds = lift is not holds
        if field(response, "success", bool, case) is not succeeds:
            raise Wrong(f"{case}: success is {str(succeeds).lower()}", shown(response), hint=0)
        if not field(response, "message", str, case).strip():
            raise Wrong(f"{case}: a message in words", "an empty message", hint=1)
        holds = lift if succeeds else holds
