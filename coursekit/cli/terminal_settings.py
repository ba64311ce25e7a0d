"""JupyterLab's terminals: they start in the course's folder, with `ros2` and tab completion."""

from __future__ import annotations

import shlex
import shutil
import sys
from pathlib import Path

from coursekit.packages.windows_quotes import powershell_quote
from coursekit.systems import operating_system

_BASHRC = """\
# Terminals of the course: your own settings, then ROS sourced, and completion by Tab.
[ -f ~/.bashrc ] && . ~/.bashrc
export PATH={bin}:"$PATH"
export PS1='\\W$ '
eval "$(register-python-argcomplete ros2 2>/dev/null)"
eval "$(register-python-argcomplete colcon 2>/dev/null)"
cd {folder}
"""

_PROFILE = """\
# Terminals of the course: ROS sourced, and completion by Tab.
$env:PATH = {bin} + [IO.Path]::PathSeparator + $env:PATH
foreach ($command in 'ros2', 'colcon') {{
    register-python-argcomplete --shell powershell $command 2>$null | Out-String | Invoke-Expression
}}
function prompt {{ (Split-Path -Leaf (Get-Location)) + '> ' }}
Set-Location -LiteralPath {folder}
"""
_POWERSHELL = ("pwsh", "powershell")
"""The newer one, installed by the user, then Windows' own."""


def terminal_settings(folder: Path) -> list[str]:
    """Return JupyterLab's options for terminals in the course's folder; empty without a supported shell."""
    command = _for_powershell(folder) if operating_system.WINDOWS else _for_bash(folder)
    return [f"--ServerApp.terminado_settings={{'shell_command': {command!r}}}"] if command else []


def _for_bash(folder: Path) -> list[str]:
    """Return a command with a settings file, because login shells override the inherited PATH."""
    bash = shutil.which("bash")
    if bash is None:
        return []
    quoted = {"bin": shlex.quote(str(_bin())), "folder": shlex.quote(str(folder))}
    return [bash, "--rcfile", str(_write(folder, "terminal.bashrc", _BASHRC.format(**quoted), "utf-8")), "-i"]


def _for_powershell(folder: Path) -> list[str]:
    """Return a command that allows scripts, such as `. install\\setup.ps1`, even if Windows refuses them."""
    shell = next(filter(None, map(shutil.which, _POWERSHELL)), None)
    if shell is None:
        return []
    quoted = {"bin": powershell_quote(str(_bin())), "folder": powershell_quote(str(folder))}
    text = _PROFILE.format(**quoted)
    file = _write(folder, "terminal.ps1", text, "utf-8-sig")  # without this mark the older one assumes the code page
    return [shell, "-NoLogo", "-NoExit", "-ExecutionPolicy", "Bypass", "-File", str(file)]


def _bin() -> Path:
    return Path(sys.executable).parent


def _write(folder: Path, name: str, text: str, encoding: str) -> Path:
    file = folder / ".coursekit" / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding=encoding)
    return file


__all__ = ["terminal_settings"]
