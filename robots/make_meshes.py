"""Makes the meshes of the rdk_x3_robot and the gripper: `python robots/make_meshes.py`. All lengths in metres.

Each part is put together from convex pieces and bodies of revolution, so that it stays small and closed. Parts of one
colour are STL files, coloured by the URDF; the cameras and the computer have several colours and are DAE files.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
import trimesh
from trimesh import Trimesh

HERE = Path(__file__).parent
Point = tuple[float, float, float]
Painted = tuple[str, tuple[float, float, float], Trimesh]
"""Name, colour and shape of a part of a DAE file."""

BLACK, GRAPHITE, SILVER = (0.05, 0.05, 0.06), (0.16, 0.17, 0.19), (0.75, 0.77, 0.8)
GLASS, GREEN, GOLD = (0.08, 0.12, 0.25), (0.05, 0.38, 0.2), (0.85, 0.65, 0.2)

WHEEL_RADIUS, WHEEL_WIDTH = 0.0375, 0.032


# -- pieces


def joined(*parts: Trimesh) -> Trimesh:
    """Several shapes as one mesh."""
    return trimesh.util.concatenate(list(parts))


def moved(part: Trimesh, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Trimesh:
    """A shifted copy."""
    return part.copy().apply_translation((x, y, z))


def turned(part: Trimesh, angle: float, axis: Point) -> Trimesh:
    """A copy turned about an axis through the origin [rad]."""
    return part.copy().apply_transform(trimesh.transformations.rotation_matrix(angle, axis))


def hull(points: Iterable[Sequence[float]]) -> Trimesh:
    """The smallest convex shape about some points."""
    return trimesh.convex.convex_hull(np.array(list(points), float))


def outline(length: float, width: float, corner: float, steps: int = 3) -> list[tuple[float, float]]:
    """A rectangle about the origin with round corners."""
    points = []
    for quarter, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        for step in range(steps + 1):
            angle = math.pi / 2 * (quarter + step / steps)
            x, y = sx * (length / 2 - corner), sy * (width / 2 - corner)
            points.append((x + corner * math.cos(angle), y + corner * math.sin(angle)))
    return points


def block(length: float, width: float, height: float, corner: float = 0.004, bevel: float = 0.002) -> Trimesh:
    """A block about the origin with round upright edges and bevels above and below."""
    full = outline(length, width, corner)
    small = outline(length - 2 * bevel, width - 2 * bevel, max(corner - bevel, 1e-4))
    half = height / 2
    levels = ((small, -half), (full, -half + bevel), (full, half - bevel), (small, half))
    return hull((x, y, z) for points, z in levels for x, y in points)


def turned_profile(profile: Sequence[tuple[float, float]], sections: int = 32) -> Trimesh:
    """A body of revolution about z from (radius, height) pairs, from below to above."""
    return trimesh.creation.revolve(np.array(profile, float), sections=sections)


def rod(radius: float, height: float, sections: int = 16) -> Trimesh:
    """A cylinder about the origin along z."""
    return turned_profile([(0, -height / 2), (radius, -height / 2), (radius, height / 2), (0, height / 2)], sections)


def box(length: float, width: float, height: float) -> Trimesh:
    """A sharp block about the origin."""
    return trimesh.creation.box((length, width, height))


# -- wheels: about y, as the joints turn


def tyre() -> Trimesh:
    """The rubber, with treads."""
    r, w = WHEEL_RADIUS - 0.0016, WHEEL_WIDTH / 2
    inner = 0.026
    profile = [(inner, -w), (r - 0.004, -w), (r, -w + 0.004), (r, w - 0.004), (r - 0.004, w), (inner, w), (inner, -w)]
    parts = [turned_profile(profile, 36)]
    for number in range(18):
        for side in (-1, 1):
            tread = moved(box(0.0036, 0.0045, WHEEL_WIDTH * 0.44), x=WHEEL_RADIUS - 0.0018, z=side * WHEEL_WIDTH * 0.23)
            tread = turned(tread, side * 0.35, (1, 0, 0))
            parts.append(turned(tread, math.tau * (number + (side > 0) / 2) / 18, (0, 0, 1)))
    return turned(joined(*parts), -math.pi / 2, (1, 0, 0))


def hub() -> Trimesh:
    """The rim with five spokes on either side, and the motor in the middle."""
    w = WHEEL_WIDTH / 2
    rim = turned_profile([(0.0232, -w), (0.0262, -w), (0.0262, w), (0.0232, w), (0.0232, -w)], 36)
    motor = turned_profile(
        [(0, -w + 0.002), (0.009, -w + 0.002), (0.011, -w + 0.005), (0.011, w - 0.005), (0.009, w - 0.002), (0, w - 0.002)], 24
    )
    parts = [rim, motor]
    for number in range(5):
        spoke = hull(
            (x, y, z)
            for x, half in ((0.009, 0.0045), (0.0245, 0.003))
            for y in (-half, half)
            for z in (-w + 0.005, w - 0.005)
        )
        parts.append(turned(spoke, math.tau * number / 5, (0, 0, 1)))
    for number in range(5):
        bolt = moved(rod(0.0016, WHEEL_WIDTH - 0.001, 8), x=0.0065)
        parts.append(turned(bolt, math.tau * (number + 0.5) / 5, (0, 0, 1)))
    return turned(joined(*parts), -math.pi / 2, (1, 0, 0))


# -- chassis, in base_link: 0.0659 m above the floor


def tub() -> Trimesh:
    """The lower body: motors' brackets, bumpers, belly."""
    belly = hull(
        (x, y, z)
        for z, points in (
            (-0.044, outline(0.20, 0.125, 0.012)),
            (-0.034, outline(0.236, 0.146, 0.014)),
            (-0.004, outline(0.250, 0.150, 0.016)),
        )
        for x, y in points
    )
    parts = [belly]
    for x in (-0.08, 0.08):
        axle = turned(rod(0.008, 0.166, 16), math.pi / 2, (1, 0, 0))
        parts.append(moved(axle, x=x, z=WHEEL_RADIUS - 0.0659))
    for x in (-0.132, 0.132):
        parts.append(moved(block(0.018, 0.120, 0.016, 0.007, 0.003), x=x, z=-0.018))
    return joined(*parts)


def shell() -> Trimesh:
    """The coloured upper body, lower in front, with mudguards over the wheels."""
    body = hull(
        [(x, y, -0.004) for x, y in outline(0.252, 0.152, 0.018)]
        + [(x, y, 0.010) for x, y in outline(0.246, 0.148, 0.018)]
        + [(x - 0.012, y, 0.030) for x, y in outline(0.186, 0.112, 0.016)]
    )
    parts = [body]
    for x in (-0.08, 0.08):
        for side in (-1, 1):
            guard = hull(
                [(x + dx, side * y, z) for dx, z in ((-0.045, 0.004), (-0.032, 0.0145), (0.032, 0.0145), (0.045, 0.004))
                 for y in (0.070, 0.112)]
                + [(x + dx, side * y, z) for dx, z in ((-0.045, 0.0015), (-0.032, 0.0115), (0.032, 0.0115), (0.045, 0.0015))
                   for y in (0.070, 0.112)]
            )  # fmt: skip
            parts.append(guard)
    return joined(*parts)


def deck() -> Trimesh:
    """The upper plate on its posts, the mast of the second camera and two aerials."""
    parts = [moved(block(0.196, 0.118, 0.004, 0.014, 0.0008), x=-0.008, z=0.054)]
    for x in (-0.088, 0.072):
        for y in (-0.045, 0.045):
            parts.append(moved(rod(0.0034, 0.030, 10), x=x, y=y, z=0.038))
            parts.append(moved(rod(0.0048, 0.0026, 6), x=x, y=y, z=0.057))
    mast = hull((x, y, z) for z, dx in ((0.055, 0.009), (0.140, 0.006)) for x in (-0.100 - dx, -0.100 + dx) for y in (-0.008, 0.008))
    parts.append(mast)
    for y in (-0.050, 0.050):
        parts.append(moved(turned_profile([(0, 0), (0.0042, 0), (0.0042, 0.012), (0.0022, 0.016), (0.0016, 0.07), (0, 0.071)], 10), x=-0.090, y=y, z=0.056))
    return joined(*parts)


def lamps() -> Trimesh:
    """Two headlamps and a light bar behind."""
    parts = []
    for y in (-0.052, 0.052):
        parts.append(moved(turned(rod(0.0085, 0.008, 20), math.pi / 2, (0, 1, 0)), x=0.1215, y=y, z=0.004))
    parts.append(moved(block(0.006, 0.090, 0.006, 0.0025, 0.001), x=-0.1245, z=0.004))
    return joined(*parts)


def computer() -> list[Painted]:
    """The RDK X3 board: green, with a heat sink, sockets and two rows of pins; its middle is the origin."""
    fins = [moved(box(0.030, 0.0014, 0.008), y=-0.0135 + 0.0045 * number, z=0.0085) for number in range(7)]
    sockets = [moved(box(0.018, 0.014, 0.014), x=0.036, y=y, z=0.008) for y in (-0.018, 0.000)]
    sockets.append(moved(box(0.020, 0.016, 0.0125), x=0.035, y=0.019, z=0.0072))
    pins = [moved(box(0.050, 0.0022, 0.006), x=-0.010, y=0.0235 + dy, z=0.004) for dy in (-0.0014, 0.0014)]
    return [
        ("board", GREEN, block(0.085, 0.056, 0.0016, 0.003, 0.0003)),
        ("sink", SILVER, joined(moved(box(0.032, 0.030, 0.004), z=0.0028), *fins)),
        ("sockets", (0.6, 0.62, 0.65), joined(*sockets)),
        ("pins", GOLD, joined(*pins)),
        ("parts", BLACK, joined(*(moved(box(0.010, 0.010, 0.002), x=x, y=-0.018, z=0.002) for x in (-0.032, -0.016, 0.012)))),
    ]


# -- sensors, each in its own link


def lidar_base() -> Trimesh:
    """What the drum turns on; the laser's plane is z = 0."""
    foot = moved(block(0.070, 0.056, 0.010, 0.012, 0.0016), z=-0.029)
    neck = turned_profile([(0, -0.026), (0.029, -0.026), (0.026, -0.017), (0.026, -0.014), (0, -0.014)], 32)
    return joined(foot, neck)


def lidar_drum() -> Trimesh:
    """The turning drum, with the slit that the beam leaves by and a bevelled lid."""
    r = 0.0365
    return turned_profile(
        [(0, -0.0145), (r - 0.004, -0.0145), (r, -0.0125), (r, -0.006), (r - 0.0035, -0.0055), (r - 0.0035, 0.0055), (r, 0.006),
         (r, 0.011), (r - 0.003, 0.0145), (r - 0.012, 0.0152), (r - 0.013, 0.0142), (0, 0.0142)], 40
    )  # fmt: skip


def _lens(x: float, y: float, radius: float, depth: float) -> tuple[Trimesh, Trimesh]:
    """A lens looking along x: its ring and its glass."""
    ring = turned_profile([(radius * 0.72, 0), (radius, 0), (radius * 0.96, depth), (radius * 0.72, depth), (radius * 0.72, 0)], 16)
    glass = turned_profile([(0, 0), (radius * 0.74, 0), (radius * 0.74, depth * 0.45), (radius * 0.4, depth * 0.7), (0, depth * 0.78)], 16)
    return tuple(moved(turned(one, math.pi / 2, (0, 1, 0)), x=x, y=y) for one in (ring, glass))  # type: ignore[return-value]


def camera() -> list[Painted]:
    """The depth camera in front: a bar with two eyes, a projector and a colour camera; it looks along x."""
    bar = turned(block(0.024, 0.092, 0.020, 0.009, 0.002), math.pi / 2, (0, 1, 0))
    bar = turned(bar, math.pi / 2, (1, 0, 0)) if bar.extents[1] < bar.extents[2] else bar
    eyes = [_lens(0.0095, y, radius, 0.0035) for y, radius in ((0.032, 0.0078), (0.010, 0.005), (-0.008, 0.005), (-0.030, 0.0078))]
    face = moved(block(0.003, 0.084, 0.017, 0.0012, 0.0006), x=0.0095)
    foot = hull((x, y, z) for z, half in ((-0.011, 0.012), (-0.030, 0.016)) for x in (-0.010, 0.006) for y in (-half, half))
    return [
        ("bar", SILVER, joined(bar, foot)),
        ("face", BLACK, face),
        ("rings", GRAPHITE, joined(*(ring for ring, _ in eyes))),
        ("glass", GLASS, joined(*(glass for _, glass in eyes))),
    ]


def camera_2() -> list[Painted]:
    """The second camera, on the mast: a small cube with one big lens; it looks along x."""
    body = block(0.026, 0.036, 0.032, 0.006, 0.003)
    ring, glass = _lens(0.012, 0.0, 0.0125, 0.010)
    clip = moved(block(0.014, 0.020, 0.012, 0.003, 0.001), x=-0.002, z=-0.020)
    lamp = moved(turned(rod(0.0016, 0.002, 10), math.pi / 2, (0, 1, 0)), x=0.0131, y=0.0125, z=0.011)
    return [
        ("body", GRAPHITE, joined(body, clip)),
        ("ring", BLACK, ring),
        ("glass", GLASS, glass),
        ("lamp", (0.9, 0.15, 0.1), lamp),
    ]


# -- r2d2's gripper


def finger() -> Trimesh:
    """A finger that reaches along x from the origin and bends inwards (to -y) at its end."""
    upper = hull((x, y, z) for x, y in ((0.0, -0.012), (0.0, 0.012), (0.085, 0.030), (0.100, 0.020), (0.088, 0.006)) for z in (-0.014, 0.014))
    tip = hull((x, y, z) for x, y in ((0.086, 0.029), (0.100, 0.020), (0.140, -0.006), (0.136, -0.014), (0.080, 0.008)) for z in (-0.010, 0.010))
    knuckle = rod(0.016, 0.034, 16)
    return joined(upper, tip, knuckle)


# -- files


def dae(parts: Iterable[Painted]) -> str:
    """The parts as COLLADA 1.4.1, in metres, z up, flat shaded."""
    effects, materials, shapes, nodes = [], [], [], []
    for name, (red, green, blue), mesh in parts:
        effects.append(
            f'<effect id="{name}-e"><profile_COMMON><technique sid="common"><phong><diffuse>'
            f"<color>{red} {green} {blue} 1</color></diffuse></phong></technique></profile_COMMON></effect>"
        )
        materials.append(f'<material id="{name}-m"><instance_effect url="#{name}-e"/></material>')
        shapes.append(_geometry(name, mesh))
        nodes.append(
            f'<node id="{name}"><instance_geometry url="#{name}-g"><bind_material><technique_common>'
            f'<instance_material symbol="m" target="#{name}-m"/></technique_common></bind_material></instance_geometry></node>'
        )
    sections = (("effects", effects), ("materials", materials), ("geometries", shapes))
    libraries = "\n".join(f"<library_{name}>\n{chr(10).join(lines)}\n</library_{name}>" for name, lines in sections)
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n'
        '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">\n'
        "<asset><created>2024-01-01T00:00:00</created><modified>2024-01-01T00:00:00</modified>"
        '<unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>\n'
        f'{libraries}\n<library_visual_scenes>\n<visual_scene id="scene">\n{chr(10).join(nodes)}\n</visual_scene>\n'
        '</library_visual_scenes>\n<scene><instance_visual_scene url="#scene"/></scene>\n</COLLADA>\n'
    )


def _geometry(name: str, mesh: Trimesh) -> str:
    points = mesh.triangles.reshape(-1, 3)
    normals = np.repeat(mesh.face_normals, 3, axis=0)
    rows = " ".join(f"{value:.5g}" for value in points.ravel()), " ".join(f"{value:.4g}" for value in normals.ravel())
    sources = "".join(
        f'<source id="{name}-{kind}"><float_array id="{name}-{kind}-a" count="{points.size}">{text}</float_array>'
        f'<technique_common><accessor source="#{name}-{kind}-a" count="{len(points)}" stride="3"><param name="X" type="float"/>'
        '<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>'
        for kind, text in zip(("p", "n"), rows, strict=True)
    )
    indices = " ".join(str(index) for index in range(len(points)))
    return (
        f'<geometry id="{name}-g"><mesh>{sources}<vertices id="{name}-v"><input semantic="POSITION" source="#{name}-p"/>'
        f'<input semantic="NORMAL" source="#{name}-n"/></vertices><triangles count="{len(points) // 3}" material="m">'
        f'<input semantic="VERTEX" source="#{name}-v" offset="0"/><p>{indices}</p></triangles></mesh></geometry>'
    )


SOLIDS = {
    "rdk_x3/tyre": tyre,
    "rdk_x3/hub": hub,
    "rdk_x3/tub": tub,
    "rdk_x3/shell": shell,
    "rdk_x3/deck": deck,
    "rdk_x3/lamps": lamps,
    "rdk_x3/lidar_base": lidar_base,
    "rdk_x3/lidar_drum": lidar_drum,
    "finger": finger,
}
PAINTED = {"rdk_x3/computer": computer, "rdk_x3/camera": camera, "rdk_x3/camera_2": camera_2}


def make(folder: Path) -> list[Path]:
    """Write all meshes into a folder; return the files."""
    files = []
    for name, solid in SOLIDS.items():
        path = folder / f"{name}.stl"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(solid().export(file_type="stl"))
        files.append(path)
    for name, painted in PAINTED.items():
        path = folder / f"{name}.dae"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(dae(painted()), encoding="utf-8", newline="\n")
        files.append(path)
    return files


if __name__ == "__main__":
    for made in make(HERE / "meshes"):
        print(f"{made.relative_to(HERE)}: {made.stat().st_size // 1024} KiB")
