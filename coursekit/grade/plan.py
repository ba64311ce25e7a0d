"""The plan and the observations of a trial: plain values, validated when they return from a sandbox."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

EVERY_NODE_S = ("/rosout", "/parameter_events")
"""Topics of every node."""
MESSAGES = 5000
"""The maximum number of messages recorded per topic."""

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

    `run` are the student's command lines without the word `ros2`, started in order; `later` (seconds, command line)
    are started after the others. They share an interpreter of their own. `beside` are the course's programs, which
    run apart from all of a student's code. `record` are topics whose messages are recorded, `*` means all; `publish`
    are (seconds, topic, type, fields); `call` are (seconds, service, type, fields); `seconds` is when Ctrl-C is
    pressed in all programs.
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

    `services` are those with a server. `outputs` and `exit_codes` are those of `run`, then those of `later`; `beside`
    are the outputs of the course's programs.
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
        """Return the messages of a topic published by the course's own programs, not by the student's.

        >>> seen = Seen(messages={"/odom": [(0.1, {"x": 1}), (0.2, {"x": 9})]}, by_course={"/odom": [True, False]})
        >>> seen.of_course("/odom")
        [(0.1, {'x': 1})]
        """
        told = zip(self.messages.get(topic, []), self.by_course.get(topic, []), strict=False)
        return [message for message, own in told if own]
