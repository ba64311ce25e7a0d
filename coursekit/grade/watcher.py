"""The course's side of a trial: its clock rules; its node records, publishes and calls as planned.

The student's programs run in another interpreter, connected only by topics and services. The plan comes as JSON on
stdin, the observations go to stdout: `python -m coursekit.grade.watcher SECONDS [READ WRITE]`. The last two are file
descriptors of pipes to the other side, which is started from here when they are missing.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.core.graph import names_and_types
from coursekit.systems.inherited import opened
from coursekit.wiring import COMMANDS, load

from .plan import MESSAGES, Plan, Seen
from .recording import Recorder

if TYPE_CHECKING:
    from rclpy.task import Future

OURS = ("_trial", "_ros2cli")
"""The prefixes of node names to hide."""
END_SECONDS = 5.0
"""The virtual time that programs may take to end after Ctrl-C [s]."""


class Watcher:
    """A trial as seen from the course's side."""

    def __init__(self, plan: Plan, session: Any) -> None:
        self.plan = plan
        self.session = session
        self.seen = Seen(responses=[None] * len(plan.call))
        self.graph = session.graph(0)
        self.leader: Any = None
        self._told = session.clock.new_event()

    def run(self) -> Seen:
        """Carry out the plan."""
        beside = [self._start(argv) for argv in self.plan.beside]
        for argv in self.plan.run:
            self.leader.post("start", argv)
        watching = self.session.start(self._watch, name="watcher")
        now = 0.0
        for when, argv in self.plan.later:
            self.session.clock.sleep(max(0.0, when - now))
            now = max(now, when)
            self.leader.post("start", argv)
        self.session.clock.sleep(max(0.0, self.plan.seconds - now))
        self._look()
        self.leader.post("finish", END_SECONDS)
        self._told.wait(2 * END_SECONDS)
        for process in beside:
            process.interrupt()
        for process in beside:
            process.wait(END_SECONDS)
        self.seen.beside = [process.output for process in beside]
        watching.kill()
        return self.seen

    def on_event(self, event: list[Any]) -> None:
        """Handle the report of the student's side on how its programs ended."""
        kind, outputs, codes = event
        count = len(self.plan.run) + len(self.plan.later)
        if kind != "ended" or len(outputs) != count or len(codes) != count:
            raise ValueError("it does not say how each program ended")
        self.seen.outputs = [str(output) for output in outputs]
        self.seen.exit_codes = [None if code is None else int(code) for code in codes]
        self._told.set()

    def _start(self, argv: list[str]) -> Any:
        ros2 = load(COMMANDS["ros2"])
        return self.session.start(lambda: ros2(argv), name="ros2", argv=argv)

    def _watch(self) -> None:
        import rclpy

        from coursekit.interfaces import load

        rclpy.init(args=[])
        node = rclpy.create_node("_trial", start_parameter_services=False, enable_rosout=False)
        Recorder(self.graph.find_nodes("_trial", "/")[0], self.plan.record, self._keep)
        for when, topic, kind, fields in self.plan.publish:
            publisher = node.create_publisher(load(kind), topic, 10)
            self._later(node, when, partial(publisher.publish, _filled(load(kind)(), fields)))
        for index, (when, service, kind, fields) in enumerate(self.plan.call):
            client = node.create_client(load(kind), service)
            request = _filled(load(kind).Request(), fields)
            self._later(node, when, partial(self._call, client, request, index))
        rclpy.spin(node)

    def _later(self, node: Any, seconds: float, action: Callable[[], Any]) -> None:
        def once() -> None:
            timer.cancel()
            action()

        timer = node.create_timer(max(seconds, 1e-6), once)

    def _call(self, client: Any, request: Any, index: int) -> None:
        from rosidl_runtime_py import message_to_ordereddict

        def answered(future: Future) -> None:
            self.seen.responses[index] = message_to_ordereddict(future.result())

        client.call_async(request).add_done_callback(answered)

    def _keep(self, topic: str, seconds: float, fields: dict[str, Any], by_course: bool) -> None:
        kept = self.seen.messages.setdefault(topic, [])
        if len(kept) < MESSAGES:
            kept.append((seconds, fields))
            self.seen.by_course.setdefault(topic, []).append(by_course)

    def _look(self) -> None:
        seen = self.seen
        seen.nodes = sorted(node.full_name for node in self.graph.nodes if not node.name.startswith(OURS))
        seen.topics = dict(self.graph.topics())
        seen.services = dict(names_and_types(server for some in list(self.graph.servers.values()) for server in some))
        for ends, kept in ((self.graph.publishers, seen.publishers), (self.graph.subscriptions, seen.subscriptions)):
            for name, endpoints in sorted(ends.items()):
                kept[name] = [_described(endpoint) for endpoint in endpoints if not endpoint.node.name.startswith(OURS)]


def _described(endpoint: Any) -> dict[str, Any]:
    return {"node": endpoint.node.full_name, "type": endpoint.type_name} | asdict(endpoint.qos)


def _filled(msg: Any, fields: dict[str, Any]) -> Any:
    from rosidl_runtime_py import set_message_fields

    set_message_fields(msg, fields)
    return msg


def main() -> int:
    """Read a plan, carry it out, and write the observations."""
    plan = Plan(**json.loads(sys.stdin.buffer.read()))
    out, nothing = os.dup(1), os.open(os.devnull, os.O_RDWR)
    for number in (0, 1):  # output written past sys.stdout is discarded
        os.dup2(nothing, number)
    patience, *pipes = sys.argv[1:]
    child = None if pipes else _other_side()
    read, write = map(opened, pipes) if child is None else (child.stdout.fileno(), child.stdin.fileno())

    def answer(facts: dict[str, Any]) -> None:
        if child is not None:
            child.kill()
        with os.fdopen(out, "wb") as to:
            to.write(json.dumps(facts, default=_plain).encode())
        os._exit(0)  # programs left running end with this process

    answer(_carried_out(plan, read, write, float(patience), lambda why: answer({"failed": why})))
    return 0


def _other_side() -> Any:
    """Start the student's side from here, as for a check in a notebook."""
    from .trial import PROGRAMS

    return subprocess.Popen(PROGRAMS, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)


def _carried_out(plan: Plan, read: int, write: int, patience: float, failed: Callable[[str], None]) -> dict[str, Any]:
    from coursekit.joined import Leader, Pipe
    from coursekit.processes.session import current

    _know_the_types_of(os.environ.get("COURSEKIT_WORKSPACE", ""))
    session = current()
    watcher = Watcher(plan, session)
    watcher.leader = Leader(session.clock, watcher.graph, Pipe(read, write), watcher.on_event, failed, patience)
    return {"seen": vars(watcher.run())}


def _know_the_types_of(workspace: str) -> None:
    """Load the interfaces of the student's packages, but none of their programs."""
    from coursekit.interfaces.find import remember

    install = Path(workspace, "install")
    if workspace and install.is_dir():
        for prefix in [install, *sorted(path for path in install.iterdir() if path.is_dir())]:
            if (prefix / "share").is_dir():
                remember(prefix)


def _plain(value: Any) -> Any:
    return value.tolist() if hasattr(value, "tolist") else list(value) if isinstance(value, Sequence) else str(value)


if __name__ == "__main__":
    sys.exit(main())
