"""A trial: a student's programs run alone, on the virtual clock, in a process of the system of their own.

The plan goes in and what was seen comes out as JSON. `python -m coursekit.grade.trial` reads a plan from stdin.
"""

from __future__ import annotations

import faulthandler
import json
import os
import secrets
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

PATIENCE = 30.0
"""Real seconds that may pass while the virtual clock stands still."""
STEP = 100_000_000
"""Virtual nanoseconds after which a trial is seen to go on."""
MESSAGES = 5000
"""Messages that are kept of each topic."""

_STOOD_STILL = b"Timeout ("
"""How the answer begins when Python's watchdog ended the trial."""
EVERY_NODE_S = ("/rosout", "/parameter_events")
"""Topics that every node has."""
NOT_FOR_TRIALS = ("COURSEKIT_STOP_AFTER", "ROS_DOMAIN_ID")
"""What a student's environment may have set, and a trial does without."""


@dataclass
class Plan:
    """What happens in a trial.

    `run` are command lines without the word `ros2`, started in order; `record` are topics whose messages are kept, `*`
    means all; `publish` are (seconds, topic, type, fields); `call` are (seconds, service, type, fields); `later` are
    (seconds, command line), started when the rest is up, in that order; `seconds` is when Ctrl-C is pressed in
    everything.
    """

    run: list[list[str]]
    seconds: float = 3.0
    record: list[str] = field(default_factory=list)
    publish: list[tuple[float, str, str, dict[str, Any]]] = field(default_factory=list)
    call: list[tuple[float, str, str, dict[str, Any]]] = field(default_factory=list)
    later: list[tuple[float, list[str]]] = field(default_factory=list)


@dataclass
class Seen:
    """What was seen: at the end of the trial, just before Ctrl-C, and while it ran.

    `outputs` and `exit_codes` are those of `run`, then those of `later`.
    """

    outputs: list[str] = field(default_factory=list)
    exit_codes: list[int | None] = field(default_factory=list)
    nodes: list[str] = field(default_factory=list)
    topics: dict[str, list[str]] = field(default_factory=dict)
    services: dict[str, list[str]] = field(default_factory=dict)
    publishers: dict[str, list[dict[str, Any]]] = field(default_factory=dict)
    subscriptions: dict[str, list[dict[str, Any]]] = field(default_factory=dict)
    messages: dict[str, list[tuple[float, dict[str, Any]]]] = field(default_factory=dict)
    responses: list[dict[str, Any] | None] = field(default_factory=list)


class TrialFailed(Exception):
    """The trial itself did not end: an endless loop without waiting, or a crash of the interpreter."""


def try_out(plan: Plan, env: Mapping[str, str] | None = None, cwd: str | None = None) -> Seen:
    """Carry out `plan` and tell what was seen; TrialFailed when it does not end in time."""
    variables = {key: value for key, value in (env or os.environ).items() if key not in NOT_FOR_TRIALS}
    key, question = asked(plan)
    done = subprocess.run(  # without a time limit: waiting for one would sleep on the session's clock
        [sys.executable, "-m", "coursekit.grade.trial", str(PATIENCE)],
        input=question,
        env=variables | {"COURSEKIT_TIME": "virtual", "PYTHONDONTWRITEBYTECODE": "1"},
        cwd=cwd,
        capture_output=True,
    )
    said = done.stderr.decode(errors="replace").strip()
    if done.returncode and not done.stdout.startswith(_STOOD_STILL):
        raise TrialFailed(said.splitlines()[-1] if said else "it ended abruptly")
    return answered(key, done.stdout)


def asked(plan: Plan) -> tuple[str, bytes]:
    """A key that is used once, and what a trial reads: its answer counts only with the key."""
    key = secrets.token_hex(16)
    return key, f"{key}\n{json.dumps(asdict(plan))}".encode()


def answered(key: str, out: bytes) -> Seen:
    """What a trial saw; TrialFailed when somebody else answered in its place, or forged what it saw."""
    first, _, rest = out.partition(b"\n")
    if first.startswith(_STOOD_STILL):
        raise TrialFailed(f"your program did not give way for {PATIENCE:.0f} s: is there a loop that never waits?")
    if first != key.encode():
        raise TrialFailed("the program ended the trial" if not out else "something that is not the trial answered for it")
    try:
        found = json.loads(rest)
        if set(found) == {"broken"}:
            raise TrialFailed(f"the program interfered with the trial: {found['broken']}")
        return Seen(**found)
    except (ValueError, TypeError):
        raise TrialFailed("the trial was ended while it told what it saw") from None


class Watcher:
    """Inside the trial: a node that records, publishes and calls as planned."""

    def __init__(self, plan: Plan, session: Any) -> None:
        self.plan = plan
        self.session = session
        self.seen = Seen(responses=[None] * len(plan.call))
        self.graph = session.graph(0)

    def run(self) -> Seen:
        """Carry it out."""
        started = [self._start(argv) for argv in self.plan.run]
        watching = self.session.start(self._watch, name="watcher")
        now = 0.0
        for when, argv in self.plan.later:
            self.session.clock.sleep(max(0.0, when - now))
            now = max(now, when)
            started.append(self._start(argv))
        self.session.clock.sleep(max(0.0, self.plan.seconds - now))
        self._look()
        for process in started:
            process.interrupt()
        self.seen.exit_codes = [process.wait(5.0) for process in started]
        self.seen.outputs = [process.output for process in started]
        watching.kill()
        return self.seen

    def _start(self, argv: list[str]) -> Any:
        from coursekit.cli.parser import run

        return self.session.start(lambda: run(argv), name="ros2", argv=argv)

    def _watch(self) -> None:
        import rclpy
        from rosidl_runtime_py.utilities import get_message, get_service

        rclpy.init(args=[])
        node = rclpy.create_node("_trial", start_parameter_services=False, enable_rosout=False)
        for topic in self.plan.record:
            if topic == "*":
                self._record_all(node)
            else:
                self._record_when_published(node, topic)
        for when, topic, kind, fields in self.plan.publish:
            publisher = node.create_publisher(get_message(kind), topic, 10)
            self._later(node, when, lambda p=publisher, k=kind, f=fields: p.publish(_filled(get_message(k)(), f)))
        for index, (when, service, kind, fields) in enumerate(self.plan.call):
            client = node.create_client(get_service(kind), service)
            request = _filled(get_service(kind).Request(), fields)
            self._later(node, when, lambda c=client, r=request, i=index: self._call(c, r, i))
        rclpy.spin(node)

    def _later(self, node: Any, seconds: float, action: Any) -> None:
        def once() -> None:
            timer.cancel()
            action()

        timer = node.create_timer(max(seconds, 1e-6), once)

    def _call(self, client: Any, request: Any, index: int) -> None:
        from rosidl_runtime_py import message_to_ordereddict

        def answered(future: Any) -> None:
            self.seen.responses[index] = message_to_ordereddict(future.result())

        client.call_async(request).add_done_callback(answered)

    def _record_all(self, node: Any) -> None:
        """Record every topic of the programs' own, as soon as it is there."""
        known = set(EVERY_NODE_S)

        def look() -> None:
            for topic in sorted(set(dict(self.graph.topics())) - known):
                known.add(topic)
                self._record_when_published(node, topic)

        node.create_timer(0.02, look)

    def _record_when_published(self, node: Any, topic: str) -> None:
        """Subscribe as soon as somebody publishes, with a QoS that hears them."""
        from rosidl_runtime_py.utilities import get_message

        from coursekit.cli.topic_qos import fitting

        def look() -> None:
            infos = node.get_publishers_info_by_topic(topic)
            if infos:
                timer.cancel()
                kept = self.seen.messages.setdefault(topic, [])
                profile, _ = fitting(infos)
                profile.depth = 1000
                kind = get_message(infos[0].topic_type)
                node.create_subscription(kind, topic, lambda msg: self._keep(kept, msg), profile)

        timer = node.create_timer(0.001, look)

    def _keep(self, kept: list[Any], msg: Any) -> None:
        from rosidl_runtime_py import message_to_ordereddict

        if len(kept) < MESSAGES:
            kept.append((self.session.clock.steady() * 1e-9, message_to_ordereddict(msg)))

    def _look(self) -> None:
        seen = self.seen
        ours = ("_trial", "_ros2cli")
        seen.nodes = sorted(node.full_name for node in self.graph.nodes if not node.name.startswith(ours))
        seen.topics = dict(self.graph.topics())
        seen.services = dict(self.graph.services())
        for ends, kept in ((self.graph.publishers, seen.publishers), (self.graph.subscriptions, seen.subscriptions)):
            for name, endpoints in sorted(ends.items()):
                kept[name] = [_described(one) for one in endpoints if not one.node.name.startswith(ours)]


def _described(endpoint: Any) -> dict[str, Any]:
    return {"node": endpoint.node.full_name, "type": endpoint.type_name} | asdict(endpoint.qos)


def _filled(msg: Any, fields: dict[str, Any]) -> Any:
    from rosidl_runtime_py import set_message_fields

    set_message_fields(msg, fields)
    return msg


def main() -> int:
    """Read a key and a plan, carry it out, tell what was seen; the argument: real seconds that it may stand still."""
    key, _, question = sys.stdin.buffer.read().partition(b"\n")
    out, nothing = os.dup(1), os.open(os.devnull, os.O_RDWR)
    for number in (0, 1):  # programs that write past sys.stdout write nowhere
        os.dup2(nothing, number)
    plan = Plan(**json.loads(question))
    _expect_progress(float(sys.argv[1]), out)
    told = _carried_out(plan)
    faulthandler.cancel_dump_traceback_later()
    with os.fdopen(out, "wb") as answer:
        answer.write(key + b"\n" + told)
    os._exit(0)  # whatever the programs left running ends with this process


def _expect_progress(seconds: float, out: int) -> None:
    """End this process, and say so, when the virtual clock stands still for so many real seconds."""
    from coursekit.core.session import current

    clock = current().clock

    def go_on() -> None:
        faulthandler.dump_traceback_later(seconds, exit=True, file=out)
        clock.call_at(clock.steady() + STEP, go_on)

    go_on()


def _carried_out(plan: Plan) -> bytes:
    """What was seen, or how the programs interfered, as JSON."""
    import rosidl_runtime_py.utilities  # noqa: F401 (before the seal)

    import coursekit.cli.topic_qos  # noqa: F401
    from coursekit.core.session import current

    from .seal import hidden_seal

    dump, fields = json.dumps, asdict  # as they are before the programs run
    session, told = current(), hidden_seal()
    seen = Watcher(plan, session).run()
    broken = told()
    return dump({"broken": broken} if broken else fields(seen), default=_plain).encode()


def _plain(value: Any) -> Any:
    return value.tolist() if hasattr(value, "tolist") else list(value) if isinstance(value, Sequence) else str(value)


if __name__ == "__main__":
    sys.exit(main())
