"""Every package with programs is in the ament index: without its entry `ros2 run` does not find it."""

from pathlib import Path

import coursekit
from coursekit.building.executables import EXECUTABLES

INDEX = Path(coursekit.__file__).parent / "share" / "ament_index" / "resource_index" / "packages"


def test_every_package_with_programs_is_in_the_index():
    assert sorted(EXECUTABLES.keys() - {path.name for path in INDEX.iterdir()}) == []
