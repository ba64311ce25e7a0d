"""`source install/setup.bash` sets the ROS distribution, even in a shell without other setup."""

from __future__ import annotations

import contextlib
from pathlib import Path

from colcon_core.environment import EnvironmentExtensionPoint
from colcon_core.plugin_system import satisfies_version
from colcon_core.shell import ShellExtensionPoint, get_shell_extensions

from coursekit.processes.process import DISTRIBUTION

TOLD = ("ROS_DISTRO", "ROS_VERSION", "ROS_PYTHON_VERSION")


class Distribution(EnvironmentExtensionPoint):  # type: ignore[misc]
    """Adds hooks to each package that set ROS_DISTRO and similar variables: on a robot the sourced underlay does it."""

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(EnvironmentExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    def create_environment_hooks(self, prefix_path: Path, pkg_name: str) -> list[Path]:
        """Return the files created: one for each variable and each kind of shell that supports it."""
        hooks = []
        for shell in _shells():
            with contextlib.suppress(NotImplementedError):  # PowerShell's extension, which uses the dsv files
                for name in TOLD:
                    hooks.append(shell.create_hook_set_value(name.lower(), prefix_path, pkg_name, name, DISTRIBUTION[name]))
        return hooks


def _shells() -> list[ShellExtensionPoint]:
    """Return the primary shells, whose scripts all others use."""
    ranks = get_shell_extensions().items()
    return [shell for rank, shells in ranks if rank > ShellExtensionPoint.PRIORITY for shell in shells.values()]
