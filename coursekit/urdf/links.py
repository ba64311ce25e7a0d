"""Reading `<link>` and `<material>`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from .errors import Negative, UrdfError
from .model import Box, Collision, Cylinder, Geometry, Inertial, Link, Material, Mesh, Sphere, Visual
from .values import colour, number, origin, plain, vector
from .xml_tree import Element

T = TypeVar("T")
SHAPES = ("box", "cylinder", "sphere", "mesh")
_NOT_A_FLOAT = "{name} [{text}] is not a valid float"
_ABOUT_GEOMETRY = 'Put a shape in it, such as <geometry><box size="0.1 0.1 0.1"/></geometry>.'


def read_link(element: Element, faults: list[UrdfError]) -> Link:
    """Read a link; raises UrdfError if it has no name or a negative value.

    As in urdfdom, other faults end only the reading of this link: it keeps its earlier parts, and `faults` grows.
    """
    name = element.get("name")
    if not name:
        raise element.error("No name given for the link.", 'Write <link name="...">, for example name="base_link".')
    inertial: Inertial | None = None
    visuals: list[Visual] = []
    collisions: list[Collision] = []
    try:
        for own in [*element.all("inertial")][:1]:
            inertial = _part(own, name, _inertial)
        for visual in element.all("visual"):
            visuals.append(_part(visual, name, _visual))
        for collision in element.all("collision"):
            collisions.append(_part(collision, name, _collision))
    except Negative:
        raise
    except UrdfError as error:
        faults.append(error)
    return Link(name, tuple(visuals), tuple(collisions), inertial, element.line)


def _part(element: Element, link: str, read: Callable[[Element], T]) -> T:
    try:
        return read(element)
    except Negative:
        raise
    except UrdfError as error:
        raise error.within(f"Could not parse {element.tag} element for Link [{link}]") from None


def _visual(element: Element) -> Visual:
    material = element.first("material")
    return Visual(
        _geometry(element),
        origin(element),
        None if material is None else read_material(material, visual=True),
        element.get("name") or "",
        element.line,
    )


def _collision(element: Element) -> Collision:
    return Collision(_geometry(element), origin(element), element.get("name") or "", element.line)


def _inertial(element: Element) -> Inertial:
    mass, inertia = element.first("mass"), element.first("inertia")
    if mass is None:
        raise element.error("Inertial element must have a mass element", 'Add <mass value="1.0"/> (in kg).')
    if mass.get("value") is None:
        raise mass.error("Inertial: mass element must have value attribute", 'Write <mass value="1.0"/> (in kg).')
    kilograms = plain(mass.attributes["value"])
    if kilograms is None:
        what = f"Inertial: mass [{mass.get('value')}] is not a float"
        raise mass.error(what, 'Write a number of kilograms, without a unit: <mass value="1.0"/>.')
    if kilograms < 0:
        what = f"Inertial: mass [{mass.get('value')}] is negative"
        cure = "Nothing weighs less than nothing: write the mass in kg, or leave <inertial> out."
        raise mass.error(what, cure, kind=Negative)
    if inertia is None:
        raise element.error("Inertial element must have inertia element", "Add <inertia ixx=... iyy=... izz=.../>.")
    ixx, ixy, ixz, iyy, iyz, izz = (_moment(inertia, name) for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    return Inertial(kilograms, (ixx, ixy, ixz, iyy, iyz, izz), origin(element), element.line)


def _moment(element: Element, name: str) -> float:
    if element.get(name) is None:
        cure = f'All six are needed; add {name}="0.0" (in kg m^2).'
        raise element.error(f"Inertial: inertia element missing {name} attribute", cure)
    value = plain(element.attributes[name])
    if value is None:
        cure = f'Write a number (in kg m^2): {name}="0.001".'
        raise element.error(f"Inertial: inertia element {name} is not a valid double", cure)
    return value


def _geometry(element: Element) -> Geometry:
    geometry = element.first("geometry")
    if geometry is None:
        raise element.error(f"<{element.tag}> has no geometry", _ABOUT_GEOMETRY)
    if not geometry.children:
        raise geometry.error("Geometry tag contains no child element.", _ABOUT_GEOMETRY)
    shape = geometry.children[0]
    if shape.tag not in SHAPES:
        raise shape.error(f"Unknown geometry type '{shape.tag}'", f"The shapes are: {', '.join(SHAPES)}.")
    return _READERS[shape.tag](shape)


def _box(shape: Element) -> Box:
    if shape.get("size") is None:
        raise shape.error("Box shape has no size attribute", 'Write <box size="0.3 0.2 0.1"/> (edges in m).')
    size = vector(shape, "size", (0.0, 0.0, 0.0))
    _not_negative(shape, "size", min(size))
    return Box(size)


def _cylinder(shape: Element) -> Cylinder:
    if shape.get("length") is None or shape.get("radius") is None:
        cure = 'Write <cylinder radius="0.1" length="0.2"/> (in m).'
        raise shape.error("Cylinder shape must have both length and radius attributes", cure)
    return Cylinder(_size(shape, "radius"), _size(shape, "length"))


def _sphere(shape: Element) -> Sphere:
    if shape.get("radius") is None:
        raise shape.error("Sphere shape must have a radius attribute", 'Write <sphere radius="0.1"/> (in m).')
    return Sphere(_size(shape, "radius"))


def _mesh(shape: Element) -> Mesh:
    filename = shape.get("filename")
    if not filename:
        cure = 'Write <mesh filename="package://my_package/meshes/part.stl"/>.'
        raise shape.error("Mesh must contain a filename attribute", cure)
    scale = vector(shape, "scale", (1.0, 1.0, 1.0), "Mesh scale was specified, but could not be parsed: ")
    return Mesh(filename, scale)


_READERS: dict[str, Callable[[Element], Geometry]] = {
    "box": _box,
    "cylinder": _cylinder,
    "sphere": _sphere,
    "mesh": _mesh,
}


def _size(shape: Element, name: str) -> float:
    value = number(shape, name, 0.1, _NOT_A_FLOAT)
    _not_negative(shape, name, value)
    return value


def _not_negative(shape: Element, name: str, value: float) -> None:
    if value < 0:
        what = f"{name} [{shape.get(name)}] is negative"
        raise shape.error(what, "Sizes are given in metres, from 0 up.", kind=Negative)


def read_material(element: Element, *, visual: bool = False) -> Material:
    """Read a material; in a visual the name alone is sufficient. Raises UrdfError."""
    name = element.get("name")
    if name is None or not (name or visual):
        what = "Visual material must contain a name attribute" if visual else "Material must contain a name attribute"
        raise element.error(what, 'Write <material name="blue">.')
    shade, texture = element.first("color"), element.first("texture")
    rgba = None if shade is None else colour(shade, name)
    image = None if texture is None else texture.get("filename")
    if rgba is None and image is None and not visual:
        cure = 'Add <color rgba="0.2 0.4 0.8 1"/> to it.'
        raise element.error(f"Material [{name}] color has no rgba", cure, (f"Material [{name}] not defined in file",))
    return Material(name, rgba, image)


__all__ = ["read_link", "read_material"]
