"""A model's colour for a camera: the material of its first visual."""

from __future__ import annotations

from coursekit.urdf.xml_tree import Element

Look = tuple[str, tuple[float, float, float] | None]
"""A texture, and a colour that tints it (None: its usual one)."""
PLAIN: Look = ("plain", None)
NAMES: dict[str, Look] = {
    "brick": ("brick", None), "wood": ("wood", None), "concrete": ("concrete", None), "grass": ("hedge", None),
    "darkgrey": ("plain", (0.18, 0.18, 0.18)), "grey": ("plain", (0.6, 0.6, 0.6)), "white": ("plain", (1.0, 1.0, 1.0)),
    "black": ("plain", (0.05, 0.05, 0.05)), "red": ("plain", (1.0, 0.0, 0.0)), "green": ("plain", (0.0, 1.0, 0.0)),
    "blue": ("plain", (0.0, 0.0, 1.0)), "yellow": ("plain", (1.0, 1.0, 0.0)), "orange": ("plain", (1.0, 0.51, 0.05)),
    "purple": ("plain", (1.0, 0.0, 1.0)), "turquoise": ("plain", (0.0, 1.0, 1.0)), "indigo": ("plain", (0.33, 0.0, 0.5)),
    "gold": ("plain", (0.8, 0.65, 0.12)),
}  # fmt: skip
"""Words in the names of Gazebo's own materials, such as Gazebo/RedBright."""


def look_of(model: Element) -> Look:
    """Return the look of a `<model>`: the first material of a visual with a name or colours."""
    for link in model.all("link"):
        for visual in link.all("visual"):
            look = look_of_material(visual.first("material"))
            if look != PLAIN:
                return look
    return PLAIN


def look_of_material(material: Element | None) -> Look:
    """Return the look of an SDF `<material>`; plain if it is unknown."""
    if material is None:
        return PLAIN
    named = look_named(material.tell("script/name"))
    if named != PLAIN:
        return named
    for tag in ("diffuse", "ambient"):
        try:
            red, green, blue = (min(max(float(word), 0.0), 1.0) for word in material.tell(tag).split()[:3])
        except ValueError:
            continue
        return "plain", (red, green, blue)
    return PLAIN


def look_named(name: str) -> Look:
    """Return the look of one of Gazebo's own materials.

    >>> look_named("Gazebo/DarkGrey"), look_named("Gazebo/Bricks"), look_named("My/Own")
    (('plain', (0.18, 0.18, 0.18)), ('brick', None), ('plain', None))
    """
    word = name.rpartition("/")[2].lower()
    return next((look for known, look in NAMES.items() if known in word), PLAIN)


__all__ = ["PLAIN", "Look", "look_named", "look_of", "look_of_material"]
