"""The words and keys of this computer: messages ask here, and name those that its shells and keyboard have."""

from __future__ import annotations

from . import which


def source_workspace() -> str:
    """The line that makes a terminal know a workspace, in its folder, after a build.

    >>> source_workspace()
    'source install/setup.bash'
    """
    if which.WINDOWS:
        return r". install\setup.ps1"
    return "source install/setup.zsh" if which.MAC else "source install/setup.bash"


def set_variable(name: str, value: str) -> str:
    """The line that sets an environment variable for programs that are started next in the same terminal.

    >>> set_variable("ROS_DOMAIN_ID", "7")
    'export ROS_DOMAIN_ID=7'
    """
    return f'$env:{name} = "{value}"' if which.WINDOWS else f"export {name}={value}"


def line_here(command: str) -> str:
    """A line of the course's as this computer's shells have it; most are the same everywhere.

    >>> line_here("printenv ROS_DISTRO")
    'printenv ROS_DISTRO'
    """
    program, _, name = command.partition(" ")
    return f"cmd /c set {name}" if which.WINDOWS and program == "printenv" else command


def install(requirement: str) -> str:
    """The line that installs a package: bash, zsh, PowerShell and cmd all take its marks for quotation marks.

    >>> install("setuptools<80")
    'pip install "setuptools<80"'
    """
    return f'pip install "{requirement}"'


def shortcut(key: str) -> str:
    """A key with the one beside it that gives commands.

    >>> shortcut("S")
    'Ctrl+S'
    """
    return f"Cmd+{key}" if which.MAC else f"Ctrl+{key}"


__all__ = ["install", "line_here", "set_variable", "shortcut", "source_workspace"]
