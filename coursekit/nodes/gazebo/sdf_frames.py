"""Names in SDF models and worlds with their poses: links, joints, frames, nested and included models."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from coursekit.files import read_text
from coursekit.geometry.plane import Array
from coursekit.urdf import MeshError
from coursekit.urdf.xml_tree import Element, read

from .model_paths import MissingModel, find_model
from .value_parsing import pose

DEEPEST = 20
"""The maximum nesting of models; deeper nesting means that a model includes itself."""
TAGS = ("link", "joint", "frame", "model", "include")


def included(element: Element, file: Path | None) -> tuple[Element, Path]:
    """Return the `<model>` of an `<include>`, and its file. Raises MeshError and UrdfError."""
    path = find_model(element.tell("uri"), file)
    root = read(_text(path), str(path))
    model = root.first("model") if root.tag == "sdf" else None
    if model is None:
        raise root.error("holds no <model>", "Begin with <sdf version='1.7'><model name='...'>.")
    return model, path


def _text(path: Path) -> str:
    try:
        return read_text(path)
    except (OSError, UnicodeDecodeError) as error:
        raise MeshError(f"cannot be read: {error}", file=str(path), cure="A model is text in XML.") from None


def is_merged(element: Element) -> bool:
    """Whether the links of an `<include>` are merged into the containing model."""
    return element.get("merge") in ("true", "1")


def frames_of(model: Element, file: Path | None = None, depth: int = 0) -> Callable[[str], Array]:
    """Return a function from a name in a model or world to its pose; `a::b` is b in the model a."""
    if depth > DEEPEST:
        raise model.error(f"holds more than {DEEPEST} models inside each other", "Does it include itself?")
    named = {child.get("name") or child.tell("name"): child for child in model.children if child.tag in TAGS}

    def within(element: Element) -> Callable[[str], Array]:
        """Return the frames of a nested or included model."""
        if element.tag == "model":
            return frames_of(element, file, depth + 1)
        inner, path = included(element, file)
        return frames_of(inner, path, depth + 1)

    def merged(name: str, above: tuple[str, ...]) -> Array | None:
        for child in model.children:
            if child.tag == "include" and is_merged(child):
                inner, path = _try(child, file)
                if inner is not None and any((each.get("name") or each.tell("name")) == name for each in inner.children):
                    return placed(child, above) @ frames_of(inner, path, depth + 1)(name)
        return None

    def placed(element: Element, above: tuple[str, ...]) -> Array:
        place = element.first("pose")
        told = place.get("relative_to") if place is not None else None
        usual = (
            element.tell("child")
            if element.tag == "joint"
            else (element.get("attached_to") or "" if element.tag == "frame" else "")
        )
        return of(told or usual, above) @ pose(element)

    def of(name: str, above: tuple[str, ...] = ()) -> Array:
        if name in ("", "__model__", "world"):
            return np.eye(4)
        outer, _, inner = name.partition("::")
        if inner and name not in named and outer in named and named[outer].tag in ("model", "include"):
            return of(outer, (*above, name)) @ within(named[outer])(inner)
        element = named.get(name)
        matrix = merged(name, (*above, name)) if element is None and name not in above else None
        if matrix is not None:
            return matrix
        if element is None or name in above:
            what = "which is relative to itself" if element is not None else "which does not exist"
            raise model.error(f"has a pose relative to '{name}', {what}", f"Frames are: {', '.join(named) or 'none'}.")
        return placed(element, (*above, name))

    return of


def _try(element: Element, file: Path | None) -> tuple[Element | None, Path | None]:
    try:
        return included(element, file)
    except MissingModel:
        return None, None


__all__ = ["DEEPEST", "frames_of", "included", "is_merged"]
