"""The effect of `source /opt/ros/humble/setup.bash` on an environment, for the course's own underlay."""

from __future__ import annotations

import os
import sys
from collections.abc import MutableMapping
from pathlib import Path

from coursekit.interfaces.find import with_underlay
from coursekit.processes.process import DISTRIBUTION


def source_underlay(environ: MutableMapping[str, str]) -> None:
    """Set ROS_DISTRO and similar variables, and add the underlay and our commands to their paths."""
    for name, value in DISTRIBUTION.items():
        environ.setdefault(name, value)
    with_underlay(environ)
    folder = str(Path(sys.executable).parent)
    if folder not in environ.get("PATH", "").split(os.pathsep):
        environ["PATH"] = os.pathsep.join([folder, environ.get("PATH", "")])
