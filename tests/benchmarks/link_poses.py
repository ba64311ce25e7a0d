"""All link poses of a 16-link robot, by ours, yourdfpy and pinocchio in one run; prints JSON (microseconds)."""

import io
import json
import math
import random
import timeit

from coursekit.urdf import parse
from coursekit.urdf.kinematics import Kinematics

LINKS = 16


def robot(straight: bool) -> str:
    """A chain of revolute joints: along the axes, as most robots are, or with every origin and axis askew."""
    chance = random.Random(1)
    text = '<robot name="chain"><link name="l0"/>'
    for number in range(1, LINKS):
        xyz = " ".join(f"{chance.uniform(-1, 1):.4f}" for _ in range(3))
        askew = [" ".join(f"{chance.uniform(-size, size):.4f}" for _ in range(3)) for size in (3, 1)]
        rpy, axis = (f"{math.pi / 2} 0 0", "0 0 1") if straight else askew
        text += (
            f'<link name="l{number}"/><joint name="j{number}" type="revolute"><origin xyz="{xyz}" rpy="{rpy}"/>'
            f'<parent link="l{number - 1}"/><child link="l{number}"/><axis xyz="{axis}"/>'
            '<limit lower="-3" upper="3" effort="1" velocity="1"/></joint>'
        )
    return text + "</robot>"


def best(function: object) -> float:
    """The time of one call [µs]."""
    timer = timeit.Timer(function)  # type: ignore[arg-type]
    count = max(10, timer.autorange()[0] // 4)
    return min(timer.repeat(7, count)) / count * 1e6


def yourdfpy_time(text: str, positions: dict[str, float]) -> float | None:
    """Its update and the matrix of each link."""
    try:
        import yourdfpy
    except ImportError:
        return None
    urdf = yourdfpy.URDF.load(io.BytesIO(text.encode()), load_meshes=False)
    names = list(urdf.link_map)

    def poses() -> list[object]:
        urdf.update_cfg(positions)
        return [urdf.get_transform(name) for name in names]

    return best(poses)


def pinocchio_time(text: str, positions: dict[str, float]) -> float | None:
    """Its frames' poses, each as a 4x4 matrix."""
    try:
        import numpy as np
        import pinocchio
    except ImportError:
        return None
    model = pinocchio.buildModelFromXML(text)
    data = model.createData()
    q = np.array([positions[name] for name in model.names[1:]])
    frames = [model.getFrameId(f"l{number}", pinocchio.FrameType.BODY) for number in range(LINKS)]

    def poses() -> list[object]:
        pinocchio.framesForwardKinematics(model, data, q)
        return [data.oMf[frame].homogeneous for frame in frames]

    return best(poses)


def main() -> None:
    """Measure and print."""
    positions = {f"j{number}": 0.1 * number for number in range(1, LINKS)}
    result = {}
    for straight in (True, False):
        text = robot(straight)
        kinematics = Kinematics(parse(text))
        result["straight" if straight else "askew"] = {
            "ours": best(lambda kinematics=kinematics: kinematics.poses(positions)),
            "matrices": best(lambda kinematics=kinematics: kinematics.matrices(positions)),
            "yourdfpy": yourdfpy_time(text, positions),
            "pinocchio": pinocchio_time(text, positions),
        }
    print(json.dumps(result))


if __name__ == "__main__":
    main()
