"""The facts of a buffer's frames, taken at one moment."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

STALE_SECONDS = 2.0
"""The age at which a moving frame is marked as late [s]."""


@dataclass(frozen=True)
class Frame:
    """One frame; `parent` is '' for the root of a tree. Times are in nanoseconds."""

    name: str
    parent: str = ""
    static: bool = False
    rate: float = 0.0
    newest: int = 0
    oldest: int = 0
    authority: str = ""
    late: float = 0.0
    """The seconds since its last update, if that is too long; 0 otherwise."""


@dataclass
class FrameFacts:
    """Frames by name, sorted; the children of each; the roots; and the faults."""

    frames: dict[str, Frame] = field(default_factory=dict)
    children: dict[str, list[str]] = field(default_factory=dict)
    roots: list[str] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)
    now: int = 0


def take(buffer: Any, now: int = 0) -> FrameFacts:
    """Take the facts of a FrameBuffer; with `now` (nanoseconds), also find late frames."""
    facts = FrameFacts(now=now)
    for name, cache in sorted(buffer.frames.items()):
        parent = cache.parent if cache is not None else None
        if parent is None:
            facts.frames[name] = Frame(name)
            continue
        span = (cache.newest - cache.oldest) * 1e-9
        age = (now - cache.newest) * 1e-9
        facts.frames[name] = Frame(
            name,
            parent,
            cache.static,
            (len(cache.stamps) - 1) / span if span > 0 else 0.0,
            cache.newest,
            cache.oldest,
            buffer.authorities.get(name, ""),
            age if now and not cache.static and age > STALE_SECONDS else 0.0,
        )
        facts.children.setdefault(parent, []).append(name)
    facts.roots = [name for name, frame in facts.frames.items() if not frame.parent]
    facts.faults = list(_faults(facts))
    return facts


def _faults(facts: FrameFacts):  # type: ignore[no-untyped-def]
    if len(facts.roots) > 1:
        yield (
            f"{len(facts.roots)} trees that nothing joins, with the roots {', '.join(facts.roots)}: no transform "
            "between them can be looked up. Publish the pose of one root in a frame of the other."
        )
    loop = set(facts.frames) - reachable(facts)
    if loop:
        yield f"a loop: {', '.join(sorted(loop))}. Each frame may have one parent, and no frame is its own ancestor."
    for frame in facts.frames.values():
        if frame.late:
            yield f"{frame.name}: no node has published its pose in {frame.parent} for {frame.late:.1f} s"


def reachable(facts: FrameFacts) -> set[str]:
    """Return the frames in trees with a root.

    >>> sorted(reachable(FrameFacts(children={"map": ["odom"], "odom": ["base"], "lost": ["wheel"]}, roots=["map"])))
    ['base', 'map', 'odom']
    """
    reachable: set[str] = set()
    waiting = list(facts.roots)
    while waiting:
        name = waiting.pop()
        reachable.add(name)
        waiting += facts.children.get(name, [])
    return reachable


def note(frame: Frame) -> str:
    """Return the note beside a frame's name.

    >>> note(Frame("laser", "base", static=True)), note(Frame("base", "odom", rate=30.0)), note(Frame("map"))
    ('static', '30.0 Hz', '')
    """
    if not frame.parent:
        return ""
    if frame.static:
        return "static"
    return f"{frame.rate:.1f} Hz" if frame.rate else "once"
