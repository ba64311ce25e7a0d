"""Makes the meshes of the robots: `python -m robots.make` in the top folder of the repository.

Each part is put together from convex pieces and bodies of revolution, so that it stays small. Parts of one colour are STL
files, coloured by the URDF; the cameras and the computer have several colours and are DAE files.
"""

from __future__ import annotations

from pathlib import Path

from .chassis import deck, finger, lamps, shell, tub
from .dae import dae
from .devices import camera, camera_2, computer, lidar_base, lidar_drum
from .wheels import hub, tyre

ROBOTS = Path(__file__).parents[1]

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
    for made in make(ROBOTS / "meshes"):
        print(f"{made.relative_to(ROBOTS)}: {made.stat().st_size // 1024} KiB")
