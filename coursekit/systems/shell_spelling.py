"""Commands and keys in the form of this computer's shells and keyboard, for messages."""

from __future__ import annotations

from . import operating_system


def set_variable(name: str, value: str) -> str:
    """Return the command that sets an environment variable for later programs in the same terminal.

    >>> set_variable("ROS_DOMAIN_ID", "7")
    'export ROS_DOMAIN_ID=7'
    """
    return f'$env:{name} = "{value}"' if operating_system.WINDOWS else f"export {name}={value}"


def line_here(command: str) -> str:
    """Return a command of the course in the form of this computer's shells; most are the same everywhere.

    >>> line_here("printenv ROS_DISTRO")
    'printenv ROS_DISTRO'
    """
    program, _, name = command.partition(" ")
    return f"cmd /c set {name}" if operating_system.WINDOWS and program == "printenv" else command


def install(requirement: str) -> str:
    """Return the command that installs a package: its quotation marks work in bash, zsh, PowerShell and cmd.

    >>> install("setuptools<80")
    'pip install "setuptools<80"'
    """
    return f'pip install "{requirement}"'


def shortcut(key: str) -> str:
    """Return the shortcut of a key with this system's modifier key.

    >>> shortcut("S")
    'Ctrl+S'
    """
    return f"Cmd+{key}" if operating_system.MAC else f"Ctrl+{key}"


__all__ = ["install", "line_here", "set_variable", "shortcut"]
