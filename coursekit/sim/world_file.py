"""Worlds as YAML files. The example shows the format; every error is reported with its line and remedy.

```yaml
world: yard                      # its name
start: [0.5, 0.5, 0.0]           # where robots begin: x, y, heading
floor: tiles                     # texture of the floor
walls:                           # chains of upright walls
  - {name: fence, points: [[0, 0], [4, 0], [4, 3]], closed: true, thickness: 0.1, height: 2.0, texture: brick}
polygons:
  - {name: desk, points: [[1, 1], [2, 1], [2, 1.5]], height: 0.7}
circles:
  - {name: post, center: [3, 1], radius: 0.1}
boxes:                           # with a mass [kg] they can be pushed
  - {name: crate, center: [2, 2], size: [0.4, 0.3], yaw: 0.2, mass: 4.0, friction: 0.3}
doors:                           # on a hinge; `yaw` is the closed leaf's direction, `open` the opening angle
  - {name: door, hinge: [0, 1], width: 0.8, yaw: 1.57, open: 0.6, mass: 6.0}
```

Every element has `bottom` and `height`, `texture` and `colour`, and `repeat: {count: 3, step: [1.0, 0.0]}`: copies
NAME_1, NAME_2, ... each one step further.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import yaml

from coursekit.files import read_text
from coursekit.geometry.plane import Pose2D

from .elements import ELEMENTS, Fields
from .errors import WorldError, known
from .world import TEXTURES, Thing, World

TOP = {"world", "start", "floor", *ELEMENTS}
MOST_THINGS = 20_000


class Lines(dict[str, Any]):
    """A mapping of the file with its line number."""

    line = 0


class _Loader(yaml.SafeLoader):
    """Loads mappings with line numbers; a duplicate key is an error."""


def _mapping(loader: _Loader, node: yaml.MappingNode) -> Lines:
    lines = Lines()
    lines.line = node.start_mark.line + 1
    for key_node, value_node in node.value:
        key = loader.construct_object(key_node, deep=True)
        if not isinstance(key, str) or key in lines:
            what = "is there twice" if key in lines else "is no word"
            raise yaml.constructor.ConstructorError(None, None, f"the key {key!r} {what}", key_node.start_mark)
        lines[key] = loader.construct_object(value_node, deep=True)
    return lines


_Loader.add_constructor("tag:yaml.org,2002:map", _mapping)


def load_world(path: str | Path) -> World:
    """Load the world of a YAML file. Raises WorldError, also for a missing file."""
    return read_world(world_text(path), str(Path(path)))


def world_text(path: str | Path) -> str:
    """Read the text of a world file. Raises WorldError when it cannot be read."""
    file = Path(path)
    try:
        return read_text(file)
    except (OSError, UnicodeDecodeError) as error:
        beside = [sibling.name for sibling in file.parent.glob("*.yaml")] if file.parent.is_dir() else []
        cure = f"Check the path. {known(file.name, beside)}"
        raise WorldError(f"cannot be read: {error}", file=str(file), cure=cure) from None


def read_world(text: str, file: str = "world") -> World:
    """Parse the world in a text. Raises WorldError.

    >>> read_world("world: yard\\ncircles: [{name: post, center: [1, 0], radius: 0.1}]").thing("post").parts[0].radius
    0.1
    """
    try:
        data = yaml.load(text, _Loader)
    except (yaml.YAMLError, RecursionError, ValueError) as error:
        mark = getattr(error, "problem_mark", None)
        what = getattr(error, "problem", None) or str(error) or "is nested too deep"
        raise WorldError(
            f"is no YAML: {what}", file=file, line=mark.line + 1 if mark else 0, cure="Check indents, colons, brackets."
        ) from None
    if not isinstance(data, Lines) or "world" not in data:
        raise WorldError("is no world", file=file, cure="Begin with 'world: NAME', then walls, boxes, ...")
    return _world(data, file)


def _world(data: Lines, file: str) -> World:
    for key in data:
        if key not in TOP:
            raise WorldError(f"unknown key '{key}'", file=file, line=data.line, cure=known(key, TOP))
    head = Fields(data, "world", file, data.line)
    x, y, *rest = head.numbers("start", (0.0, 0.0, 0.0), (2, 3))
    things: list[Thing] = []
    for kind, build in ELEMENTS.items():
        rows = data.get(kind) or []
        if not isinstance(rows, list):
            raise WorldError(f"'{kind}' is no list", file=file, line=data.line, cure="Begin each with '- {name: ...}'.")
        for number, row in enumerate(rows, 1):
            things += _element(row, kind, number, build, file)
            if len(things) > MOST_THINGS:
                raise WorldError(f"has more than {MOST_THINGS} things", file=file, cure="Make it smaller.")
    return World(
        head.word("world"), tuple(things), Pose2D(x, y, *rest), head.word("floor", "tiles", TEXTURES), file=file
    )


def _element(row: Any, kind: str, number: int, build: Callable[[Fields], Thing], file: str) -> list[Thing]:
    if not isinstance(row, Lines):
        raise WorldError(f"'{row}' is no element", file=file, element=f"{kind}[{number}]", cure="Write {name: ..., ...}.")
    singular = "box" if kind == "boxes" else kind.removesuffix("s")
    label = str(row.get("name", f"{singular}_{number}"))
    fields = Fields(row, f"{singular} '{label}'", file, row.line)
    thing = replace(build(fields), name=label, model=label)
    copies = _copies(fields, thing)
    fields.finish()
    return copies


def _copies(fields: Fields, thing: Thing) -> list[Thing]:
    """Return the object, or its copies if it has `repeat`."""
    if "repeat" not in fields.data:
        return [thing]
    told = fields.data["repeat"]
    if not isinstance(told, Lines) or set(told) != {"count", "step"}:
        raise fields.fault("'repeat' must be {count: N, step: [x, y]}")
    inner = Fields(told, fields.element + " repeat", fields.file, told.line)
    count, (dx, dy) = inner.number("count", least=1, most=1000), inner.numbers("step", None, (2,))
    fields.used.add("repeat")
    if int(count) != count:
        raise fields.fault("'count' must be a whole number")
    at = thing.place
    return [
        replace(thing, name=f"{thing.name}_{k + 1}", place=Pose2D(at.x + k * dx, at.y + k * dy, at.theta))
        for k in range(int(count))
    ]


__all__ = ["load_world", "read_world"]
