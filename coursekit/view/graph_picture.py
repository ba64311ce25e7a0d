"""The drawing of a graph: nodes as pills; topics, services and actions as boxes; faults in red with their remedies."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from coursekit.words.gettext import gettext

from .drawing import Curve, Drawing, Rect, Text, text_width
from .graph_facts import End, Facts, nodes_at, types_of
from .graph_faults import Fault
from .layers import Box, Layout, arrange

RED = "#c8372d"
GREY = "#8795a1"
NAME_SIZE, TYPE_SIZE, LABEL_SIZE, CURE_SIZE = 13.0, 10.5, 11.0, 12.0
COLOURS = {
    "node": ("#e4effb", "#3173b5", "#16385c"),
    "topic": ("#fdf6e7", "#cf9f45", "#57410f"),
    "service": ("#e8f5ec", "#4d9a6a", "#1d5233"),
    "action": ("#f2ecfb", "#8b66c2", "#42286b"),
}
"""Fill, outline and text colour of each kind."""
SMALL = {"node": "#5d6d7a", "topic": "#93783f", "service": "#5b8a6b", "action": "#866ba8"}


@dataclass
class Thing:
    """A box in the picture."""

    kind: str
    name: str
    note: str = ""
    group: str = ""
    badges: list[int] = field(default_factory=list)
    dashed: bool = False

    @property
    def key(self) -> str:
        """The key, unique in the picture: a node and a topic may share a name."""
        return f"{self.kind} {self.name}"

    def box(self) -> Box:
        """Return the box's size."""
        width = max(text_width(self.name, NAME_SIZE), text_width(self.note, TYPE_SIZE))
        return Box(self.key, max(64.0, width + 30.0), 44.0 if self.note else 34.0, self.group)


@dataclass
class Link:
    """A line in the picture; `broken` if a fault blocks its messages."""

    start: str
    end: str
    labels: list[str] = field(default_factory=list)
    heads: str = "end"
    broken: bool = False


def draw(facts: Facts, faults: Sequence[Fault], view: str, *, services: bool, actions: bool) -> Drawing:
    """Return the picture of the graph in one of the views 'nodes', 'active' and 'all'."""
    serious = [fault for fault in faults if fault.serious]
    things = {thing.key: thing for thing in _things(facts, view, services, actions)}
    links = _merged(_links(facts, view, things, serious))
    for number, fault in enumerate(serious, 1):
        for thing in things.values():
            if thing.name in fault.places:
                thing.badges.append(number)
    labels = [text_width(label, LABEL_SIZE) for link in links for label in link.labels]
    layout = arrange(
        [thing.box() for thing in things.values()],
        [(link.start, link.end) for link in links],
        gap=max(64.0, max(labels, default=0.0) + 36.0),
        between=34.0 if view == "nodes" and labels else 18.0,
    )
    return _drawing(layout, things, links, serious)


# -- contents


def _things(facts: Facts, view: str, services: bool, actions: bool) -> Iterator[Thing]:
    groups = sorted({namespace.split("/")[1] for namespace in facts.namespaces})

    def group(name: str) -> str:
        first = name.split("/")[1]
        return f"/{first}" if first in groups and name.count("/") > 1 else ""

    for name in facts.nodes:
        far = name in facts.remote
        yield Thing("node", name, "network" if far else "", group(name), dashed=far)
    for kind, names, sources, targets in _kinds(facts, services, actions):
        for name in names:
            left, right = nodes_at(name, sources), nodes_at(name, targets)
            if kind == "topic" and (view == "nodes" or (view == "active" and not (left and right))):
                continue
            lonely = kind == "topic" and not (left and right)
            note = ", ".join(types_of(name, sources, targets))
            if lonely:
                note += gettext(" · no subscriber") if left else gettext(" · no publisher")
            yield Thing(kind, name, note, group(name), dashed=lonely or not right)


def _kinds(facts: Facts, services: bool, actions: bool) -> list[tuple[str, list[str], Sequence[End], Sequence[End]]]:
    kinds: list[tuple[str, list[str], Sequence[End], Sequence[End]]] = [
        ("topic", facts.topics, facts.publishers, facts.subscriptions)
    ]
    if services:
        kinds.append(("service", facts.services, facts.clients, facts.servers))
    if actions:
        kinds.append(("action", facts.actions, facts.action_clients, facts.action_servers))
    return kinds


def _links(facts: Facts, view: str, things: dict[str, Thing], faults: Sequence[Fault]) -> Iterator[Link]:
    broken = {end for fault in faults for end in fault.ends}
    for kind, names, sources, targets in _kinds(facts, True, True):
        for name in names:
            key = f"{kind} {name}"
            if key in things:
                for node in nodes_at(name, sources):
                    yield Link(f"node {node}", key, broken=(node, name) in broken)
                for node in nodes_at(name, targets):
                    yield Link(key, f"node {node}", broken=(node, name) in broken)
            elif view == "nodes" and kind == "topic":
                for start in nodes_at(name, sources):
                    for end in nodes_at(name, targets):
                        bad = (start, name) in broken and (end, name) in broken
                        yield Link(f"node {start}", f"node {end}", [name], broken=bad)


def _merged(links: Iterator[Link]) -> list[Link]:
    """Merge links so that each pair of boxes has one line; a link in both directions gets two heads."""
    link_by_pair: dict[tuple[str, str], Link] = {}
    for link in links:
        pair, back = (link.start, link.end), (link.end, link.start)
        if back in link_by_pair and back != pair and link_by_pair[back].labels == link.labels:
            link_by_pair[back].heads = "both"
            link_by_pair[back].broken |= link.broken
        elif pair in link_by_pair:
            link_by_pair[pair].labels += link.labels
            link_by_pair[pair].broken |= link.broken
        else:
            link_by_pair[pair] = link
    return list(link_by_pair.values())


# -- drawing


def _drawing(layout: Layout, things: dict[str, Thing], links: list[Link], faults: Sequence[Fault]) -> Drawing:
    drawing = Drawing(max(layout.width, 220.0), max(layout.height, 60.0))
    for name, (x, y, width, height) in layout.frames.items():
        title = Text(x + 12, y + 17, name, LABEL_SIZE, "#5d6d7a", bold=True, kind="ck-group-title")
        drawing.add(Rect(x, y, width, height, 10, "#f5f8fa", "#d3dce3", 1.0, kind="ck-group"), title)
    for link, route in zip(links, layout.routes, strict=True):
        if route:
            colour = RED if link.broken else GREY
            kind = "ck-link ck-broken" if link.broken else "ck-link"
            ends = (link.start.split(" ", 1)[1], link.end.split(" ", 1)[1])
            drawing.add(Curve(tuple(route), colour, link.heads, dashed=link.broken, kind=kind, ends=ends))
    for thing in things.values():
        _draw_thing(drawing, thing, layout)
    for link, route in zip(links, layout.routes, strict=True):
        _draw_labels(drawing, link, route)
    if not things:
        drawing.add(Text(110, 35, gettext("The graph is empty: no node runs."), CURE_SIZE, GREY, "middle"))
    _draw_faults(drawing, faults)
    return drawing


def _draw_thing(drawing: Drawing, thing: Thing, layout: Layout) -> None:
    x, y = layout.centres[thing.key]
    box = thing.box()
    fill, line, ink = COLOURS[thing.kind]
    left, top = x - box.width / 2, y - box.height / 2
    radius = box.height / 2 if thing.kind == "node" else 6.0
    stroke = RED if thing.badges else line
    shapes: list[Rect | Text | Curve] = [
        Rect(left, top, box.width, box.height, radius, fill, stroke, 1.4, thing.dashed, kind=f"ck-{thing.kind}"),
        Text(
            x,
            y + (-2 if thing.note else 4.5),
            thing.name,
            NAME_SIZE,
            ink,
            "middle",
            thing.kind == "node",
            "ck-name",
        ),
    ]
    if thing.note:
        shapes.append(Text(x, y + 13, thing.note, TYPE_SIZE, SMALL[thing.kind], "middle", kind="ck-type"))
    for place, number in enumerate(thing.badges):
        shapes += _badge(left + box.width - 8 - 18 * place, top, number)
    drawing.add(*shapes, name=thing.name, tip=f"{thing.kind} {thing.name}")


def _badge(x: float, y: float, number: int) -> list[Rect | Text | Curve]:
    return [
        Rect(x - 8, y - 8, 16, 16, 8, RED, "#ffffff", 1.2, kind="ck-badge"),
        Text(x, y + 3.8, str(number), 10.5, "#ffffff", "middle", True, "ck-badge-text"),
    ]


def _draw_labels(drawing: Drawing, link: Link, route: list[tuple[float, float]]) -> None:
    """Draw the topic names on a line between two nodes, on a white background."""
    if not link.labels or not route:
        return
    (x0, y0), (x1, y1) = route[0], route[1]
    x, y = (x0 + x1) / 2, (y0 + y1) / 2 - 7.0 * (len(link.labels) - 1)
    for place, label in enumerate(link.labels):
        width, down = text_width(label, LABEL_SIZE) + 8, y + 14.0 * place
        ink = RED if link.broken else "#57410f"
        drawing.add(
            Rect(x - width / 2, down - 8, width, 16, 4, "#ffffff", "none", 0.0, kind="ck-label-paper"),
            Text(x, down + 4, label, LABEL_SIZE, ink, "middle", kind="ck-label"),
            name=label,
            tip=f"topic {label}",
        )


def _draw_faults(drawing: Drawing, faults: Sequence[Fault]) -> None:
    """Draw the numbered list of faults below the picture."""
    if not faults:
        return
    drawing.width = max(drawing.width, 560.0)
    columns = int((drawing.width - 60) / (CURE_SIZE * 0.56))
    y = drawing.height + 8
    for number, fault in enumerate(faults, 1):
        drawing.add(*_badge(22, y, number))
        for text, ink, bold in ((gettext(fault.text), RED, True), (gettext(fault.cure), "#3d4a55", False)):
            for line in textwrap.wrap(text, columns, break_long_words=False):
                drawing.add(Text(40, y + 4, line, CURE_SIZE, ink, bold=bold, kind="ck-fault" if bold else "ck-cure"))
                y += 17
        y += 8
    drawing.height = y + 4
