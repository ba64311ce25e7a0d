"""A trial's plan and its observations: plain values, checked when they come back from a sandbox."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

EVERY_NODE_S = ("/rosout", "/parameter_events")
"""Topics that every node has."""
MESSAGES = 5000
"""Messages that are kept of each topic."""

Heard = list[tuple[float, dict[str, Any]]]
"""(seconds, fields) of messages."""


class TrialFailed(Exception):
    """The trial itself did not end: an endless loop without waiting, or a crash of the interpreter."""

    def __init__(self, why: str, *, timed_out: bool = False) -> None:
        super().__init__(why)
        self.timed_out = timed_out


@dataclass
class Plan:
    """The steps of a trial.

    `run` are the student's command lines without the word `ros2`, started in order, and `later` (seconds, command line)
    those that are started when the rest is up; they share an interpreter of their own. `beside` are the course's programs:
    they run where nothing of a student's does. `record` are topics whose messages are kept, `*` means all; `publish` are
    (seconds, topic, type, fields); `call` are (seconds, service, type, fields); `seconds` is when Ctrl-C is pressed in
    everything.
    """

    run: list[list[str]]
    seconds: float = 3.0
    record: list[str] = field(default_factory=list)
    publish: list[tuple[float, str, str, dict[str, Any]]] = field(default_factory=list)
    call: list[tuple[float, str, str, dict[str, Any]]] = field(default_factory=list)
    later: list[tuple[float, list[str]]] = field(default_factory=list)
    beside: list[list[str]] = field(default_factory=list)


@dataclass
class Seen:
    """The observations at the end of the trial, just before Ctrl-C, and while it ran.

    `services` are those that a node serves; one that is only called is not among them.
    `outputs` and `exit_codes` are those of `run`, then those of `later`; `beside` are the outputs of the course's programs.
    """

    outputs: list[str] = field(default_factory=list)
    exit_codes: list[int | None] = field(default_factory=list)
    beside: list[str] = field(default_factory=list)
    nodes: list[str] = field(default_factory=list)
    topics: dict[str, list[str]] = field(default_factory=dict)
    services: dict[str, list[str]] = field(default_factory=dict)
    publishers: dict[str, list[dict[str, Any]]] = field(default_factory=dict)
    subscriptions: dict[str, list[dict[str, Any]]] = field(default_factory=dict)
    messages: dict[str, Heard] = field(default_factory=dict)
    by_course: dict[str, list[bool]] = field(default_factory=dict)
    """By topic, for each message: whether one of the course's own programs published it."""
    responses: list[dict[str, Any] | None] = field(default_factory=list)

    def of_course(self, topic: str) -> Heard:
        """The messages of a topic that the course's own programs published, and no program of the student's.

        >>> seen = Seen(messages={"/odom": [(0.1, {"x": 1}), (0.2, {"x": 9})]}, by_course={"/odom": [True, False]})
        >>> seen.of_course("/odom")
        [(0.1, {'x': 1})]
        """
        told = zip(self.messages.get(topic, []), self.by_course.get(topic, []), strict=False)
        return [message for message, own in told if own]
