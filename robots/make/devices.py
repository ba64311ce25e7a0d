"""Computer, LiDAR and cameras of the rdk_x3_robot, each in its own link."""

from __future__ import annotations

import math

from trimesh import Trimesh

from .pieces import Painted, block, box, hull, joined, moved, rod, turned, turned_profile

BLACK, GRAPHITE, SILVER = (0.05, 0.05, 0.06), (0.16, 0.17, 0.19), (0.75, 0.77, 0.8)
GLASS, GREEN, GOLD = (0.08, 0.12, 0.25), (0.05, 0.38, 0.2), (0.85, 0.65, 0.2)


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
        (
            "parts",
            BLACK,
            joined(*(moved(box(0.010, 0.010, 0.002), x=x, y=-0.018, z=0.002) for x in (-0.032, -0.016, 0.012))),
        ),
    ]


def lidar_base() -> Trimesh:
    """What the drum turns on; the laser's plane is z = 0."""
    foot = moved(block(0.070, 0.056, 0.010, 0.012, 0.0016), z=-0.029)
    neck = turned_profile([(0, -0.026), (0.029, -0.026), (0.026, -0.017), (0.026, -0.014), (0, -0.014)], 32)
    return joined(foot, neck)


def lidar_drum() -> Trimesh:
    """The turning drum, with the slit that the beam leaves by and a bevelled lid."""
    r = 0.0365
    return turned_profile(
        [(0, -0.0145), (r - 0.004, -0.0145), (r, -0.0125), (r, -0.006), (r - 0.0035, -0.0055), (r - 0.0035, 0.0055),
         (r, 0.006), (r, 0.011), (r - 0.003, 0.0145), (r - 0.012, 0.0152), (r - 0.013, 0.0142), (0, 0.0142)], 40
    )  # fmt: skip


def _lens(x: float, y: float, radius: float, depth: float) -> tuple[Trimesh, Trimesh]:
    """A lens looking along x: its ring and its glass."""
    ring = turned_profile(
        [(radius * 0.72, 0), (radius, 0), (radius * 0.96, depth), (radius * 0.72, depth), (radius * 0.72, 0)], 16
    )
    glass = turned_profile(
        [(0, 0), (radius * 0.74, 0), (radius * 0.74, depth * 0.45), (radius * 0.4, depth * 0.7), (0, depth * 0.78)], 16
    )
    return tuple(moved(turned(one, math.pi / 2, (0, 1, 0)), x=x, y=y) for one in (ring, glass))  # type: ignore[return-value]


def camera() -> list[Painted]:
    """The depth camera in front: a bar with two eyes, a projector and a colour camera; it looks along x."""
    bar = turned(block(0.024, 0.092, 0.020, 0.009, 0.002), math.pi / 2, (0, 1, 0))
    bar = turned(bar, math.pi / 2, (1, 0, 0)) if bar.extents[1] < bar.extents[2] else bar
    eyes = [
        _lens(0.0095, y, radius, 0.0035)
        for y, radius in ((0.032, 0.0078), (0.010, 0.005), (-0.008, 0.005), (-0.030, 0.0078))
    ]
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
