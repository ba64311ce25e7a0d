"""Painted parts as a COLLADA file."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from trimesh import Trimesh

from .pieces import Painted


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
            f'<instance_material symbol="m" target="#{name}-m"/></technique_common></bind_material></instance_geometry>'
            "</node>"
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
        f'<technique_common><accessor source="#{name}-{kind}-a" count="{len(points)}" stride="3">'
        '<param name="X" type="float"/>'
        '<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>'
        for kind, text in zip(("p", "n"), rows, strict=True)
    )
    indices = " ".join(str(index) for index in range(len(points)))
    return (
        f'<geometry id="{name}-g"><mesh>{sources}<vertices id="{name}-v"><input semantic="POSITION" source="#{name}-p"/>'
        f'<input semantic="NORMAL" source="#{name}-n"/></vertices><triangles count="{len(points) // 3}" material="m">'
        f'<input semantic="VERTEX" source="#{name}-v" offset="0"/><p>{indices}</p></triangles></mesh></geometry>'
    )
