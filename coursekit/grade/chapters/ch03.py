"""Chapter 3: a callback that answers, a client as a program, a server that asks, a switch of one's own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.trial import Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

PACKAGE = "s3_py_srvcli"
ADD = "example_interfaces/srv/AddTwoInts"
SET = "std_srvs/srv/SetBool"
SERVER = f"run {PACKAGE} server_exe"


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
    """Lifting and putting down alternate; the impossible changes nothing."""
    from std_srvs.srv import SetBool

    function, state = work.function("lift"), work.value("state", dict)
    before = dict(state)
    try:
        for wanted, holding, succeeds in ((1, 0, 1), (1, 1, 0), (0, 1, 1), (0, 0, 0)):
            state["holding"] = bool(holding)
            response = function(SetBool.Request(data=bool(wanted)), SetBool.Response())
            _expect_lift(response, state["holding"], bool(wanted), bool(holding), bool(succeeds))
    finally:
        state.update(before)


def _expect_lift(response: Any, after: object, wanted: bool, holding: bool, succeeds: bool) -> None:
    case = f"{'lift' if wanted else 'put down'} with {'a box' if holding else 'empty hands'}"
    if response is None:
        raise Wrong(f"{case}: the response, returned", "None", "Is there a `return response` in every case?")
    if response.success is not succeeds:
        raise Wrong(f"{case}: success is {succeeds}", f"{response.success}")
    if after is not (wanted if succeeds else holding):
        raise Wrong(f"{case}: state['holding'] is {wanted if succeeds else holding} afterwards", f"{after}")
    if not response.message.strip():
        raise Wrong(f"{case}: a message in words", "an empty message", share=0.5)


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
    """Two numbers are added by the service; other counts give the usage line and exit status 1."""
    work.built(PACKAGE)
    for words in ("", "17", "1 2 3"):
        _expect_usage(work.try_out(f"run {PACKAGE} client_exe {words}", seconds=1.5), words)
    for a, b in ((17, 25), (-4, 1004)):
        seen = work.try_out(f"run {PACKAGE} client_exe {a} {b}", SERVER, seconds=3.0)
        asked = f"{a} + {b} = " in seen.outputs[1]
        said = seen.outputs[0].strip()
        if not asked:
            raise Wrong(f"client_exe {a} {b} asks the service for {a} and {b}", said or "the server was not asked")
        if f"{a} + {b} = {a + b}" not in said:
            raise Wrong(f"client_exe {a} {b} logs: {a} + {b} = (the sum)", said or "nothing", share=0.5)
        if "[py_client_async_node]" not in said:
            raise Wrong("the line from the node's logger", said, "node.get_logger().info(...)", share=0.75)
        if seen.exit_codes[0] != 0:
            cause = "After the answer main has to end: no rclpy.spin, and it returns None or 0."
            raise Wrong("exit status 0 as soon as the answer is there", f"{seen.exit_codes[0]}", cause, share=0.5)


def _expect_usage(seen: Seen, words: str) -> None:
    call = f"client_exe {words}".strip()
    lines = [line for line in seen.outputs[0].splitlines() if not line.startswith("[ros2run]")]
    if "usage: client_exe A B" not in [line.strip() for line in lines]:
        raise Wrong(f"{call}: the line `usage: client_exe A B`", "\n".join(lines)[-300:] or "nothing was printed")
    if seen.exit_codes[0] != 1:
        cause = "sys.argv holds the program's name too. `return 1` gives the exit status."
        raise Wrong(f"{call}: exit status 1", f"exit status {seen.exit_codes[0]}", cause, share=0.5)


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
    """The gate's answer is the server's plus the boxes that stand there; without the server there is none."""
    work.built(PACKAGE)
    boxes = work.variant("boxes", 10)
    questions = [(17, 25), (-30, 3), (0, 0)]
    calls = [(1.0 + at, "/py_gate_service", ADD, {"a": a, "b": b}) for at, (a, b) in enumerate(questions)]
    seen = work.try_out(f"run {PACKAGE} gate_exe", SERVER, call=calls, seconds=5.0)
    if "/py_gate_node" not in seen.nodes:
        raise Wrong("a node named /py_gate_node", ", ".join(seen.nodes) + _last_words(seen))
    if "/py_gate_service" not in seen.services:
        raise Wrong("a service /py_gate_service", "none of that name", "Is create_service in the constructor?")
    if seen.responses[0] is None:
        cause = "A deadlock? Both are needed: `await` with `call_async`, and a group of its own for the client."
        raise Wrong(f"an answer to {questions[0]}", "none came" + _last_words(seen), cause)
    for (a, b), response in zip(questions, seen.responses, strict=True):
        if response is None or response["sum"] != a + b + boxes:
            raise Wrong(f"for a={a}, b={b} what the server says, and {boxes} more", f"{response}", share=0.25)
    if seen.outputs[1].count(" = ") < len(questions):
        raise Wrong("py_add_two_ints_service is asked each time", "its server heard less", "Ask it.", share=0.25)


def _last_words(seen: Seen) -> str:
    lines = seen.outputs[0].strip().splitlines()
    return f"; the program's last line: {lines[-1]}" if lines else ""


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
    """A SetBool service whose state can be seen on a topic."""
    work.built(PACKAGE)
    command = f"run {PACKAGE} switch_exe"
    first = work.try_out(command, seconds=1.0)
    services = [name for name, types in first.services.items() if SET in types]
    if not services:
        raise Wrong(f"a service of type {SET}", "none" + _last_words(first), "Was it built after the last change?")
    usual = ("/rosout", "/parameter_events")
    topics = [name for name in first.topics if name not in usual and first.publishers.get(name)]
    if not topics:
        raise Wrong("a topic that shows whether it is on", "the node publishes nothing", share=0.25)
    calls = [(when, services[0], SET, {"data": on}) for when, on in ((3.05, True), (6.05, False))]
    seen = work.try_out(command, call=calls, record=topics, seconds=9.0)
    for (_, name, _, request), response in zip(calls, seen.responses, strict=True):
        if response is None or not response["success"] or not response["message"].strip():
            raise Wrong(f"{name} answers {request}: success, and a message", f"{response}", share=0.25)
    if not any(_shows(seen.messages.get(name, [])) for name in topics):
        raise Wrong(
            "a topic, at least once a second, that differs between on and off",
            f"the same on {', '.join(topics)} before, while and after it was on, or too seldom",
            share=0.5,
        )


def _shows(messages: Sequence[tuple[float, Mapping[str, Any]]]) -> bool:
    """Whether what is said while it is on (3 to 6 s) is never said before and after, at least twice in each part."""
    parts = [[repr(msg) for when, msg in messages if start <= when < start + 2.9] for start in (0.0, 3.1, 6.1)]
    before, on, after = (set(part) for part in parts)
    return min(len(part) for part in parts) >= 2 and not on & (before | after)
