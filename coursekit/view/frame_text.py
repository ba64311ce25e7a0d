"""The tree of frames as text; deterministic."""

from __future__ import annotations

from collections.abc import Iterator

from coursekit.words.counting import counted
from coursekit.words.gettext import gettext

from .frame_facts import FrameFacts, note


def described(facts: FrameFacts) -> str:
    """Return a heading, a line for each frame, and a line for each fault."""
    if not facts.frames:
        return "frames: none. No node has published a transform on /tf or /tf_static."
    trees = len(facts.roots)
    lines = [f"frames: {counted(len(facts.frames), 'frame')}, {counted(trees, 'tree')}"]
    for root in facts.roots:
        lines.append(root)
        lines += _below(facts, root, "")
    return "\n".join(lines + [f"! {gettext(fault)}" for fault in facts.faults])


def _below(facts: FrameFacts, name: str, indent: str) -> Iterator[str]:
    children = facts.children.get(name, [])
    for child in children:
        last = child == children[-1]
        yield f"{indent}{'`-- ' if last else '|-- '}{child}  {note(facts.frames[child])}"
        yield from _below(facts, child, indent + ("    " if last else "|   "))

