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


__all__ = ["install", "set_variable", "shortcut", "source_workspace"]
