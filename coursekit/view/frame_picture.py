"""The drawing of a tree of frames: boxes from left to right, faults in red below."""

from __future__ import annotations

import textwrap

from coursekit.tf.errors import seconds_text
from coursekit.words.gettext import gettext

from .drawing import Curve, Drawing, Rect, Text, text_width
from .frame_facts import Frame, FrameFacts, note
from .layers import Box, arrange

NAME_SIZE, NOTE_SIZE, FAULT_SIZE = 13.0, 10.5, 12.0
GREY, RED = "#8795a1", "#c8372d"
FILLS = {"root": ("#eef1f4", "#6b7a86"), "static": ("#e8f5ec", "#4d9a6a"), "moving": ("#e4effb", "#3173b5")}
"""Fill and outline of roots, static frames and moving frames."""


def draw(facts: FrameFacts, details: bool = False) -> Drawing:
    """Return the picture; `details` adds broadcaster and times."""
    frames = list(facts.frames.values())
    notes = {frame.name: _notes(frame, details) for frame in frames}
    boxes = [_box(frame, notes[frame.name]) for frame in frames]
    edges = [(frame.parent, frame.name) for frame in frames if frame.parent]
    layout = arrange(boxes, edges, gap=56.0)
    said = [line for fault in facts.faults for line in textwrap.wrap(gettext(fault), 90)]
    if not frames:
        said = ["No tf data received"]
    width = max([layout.width, *(text_width(line, FAULT_SIZE) + 28.0 for line in said)])
    drawing = Drawing(width, layout.height + (len(said) * 17.0 + 10.0 if said else 0.0))
    for (parent, child), route in zip(edges, layout.routes, strict=True):
        static = facts.frames[child].static
        drawing.add(Curve(tuple(route), GREY, dashed=static, kind="ck-link", ends=(parent, child)))
    for box, frame in zip(boxes, frames, strict=True):
        _frame(drawing, frame, box, layout.centres[box.key], notes[frame.name])
    for number, line in enumerate(said):
        drawing.add(Text(14.0, layout.height + 12.0 + 17.0 * number, line, FAULT_SIZE, RED, kind="ck-cure"))
    return drawing


def _notes(frame: Frame, details: bool) -> list[str]:
    first = note(frame)
    if not first or not details:
        return [first] if first else []
    buffered = (frame.newest - frame.oldest) * 1e-9
    return [
        f"Broadcaster: {frame.authority}",
        f"Average rate: {first}",
        f"Buffer length: {buffered:.3f}",
        f"Most recent transform: {seconds_text(frame.newest)}",
        f"Oldest transform: {seconds_text(frame.oldest)}",
    ]


def _box(frame: Frame, notes: list[str]) -> Box:
    width = max(text_width(frame.name, NAME_SIZE), *(text_width(line, NOTE_SIZE) for line in ["", *notes]))
    return Box(frame.name, max(64.0, width + 28.0), 30.0 + 13.0 * len(notes))


def _frame(drawing: Drawing, frame: Frame, box: Box, centre: tuple[float, float], notes: list[str]) -> None:
    x, y = centre
    left, top = x - box.width / 2, y - box.height / 2
    kind = "root" if not frame.parent else "static" if frame.static else "moving"
    fill, line = FILLS[kind]
    stroke = RED if frame.late else line
    shapes: list[Rect | Text] = [
        Rect(left, top, box.width, box.height, 7.0, fill, stroke, 1.4, bool(frame.late), kind="ck-node"),
        Text(x, top + 20.0, frame.name, NAME_SIZE, "#16385c", "middle", True, kind="ck-name"),
    ]
    for number, text in enumerate(notes):
        shapes.append(Text(x, top + 34.0 + 13.0 * number, text, NOTE_SIZE, GREY, "middle", kind="ck-type"))
    tip = f"{frame.name} in {frame.parent}, {', '.join(notes)}" if frame.parent else f"{frame.name}: a root"
    drawing.add(*shapes, name=frame.name, tip=tip)
