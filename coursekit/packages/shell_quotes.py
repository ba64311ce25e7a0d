"""Corrects colcon's setup scripts for folders with any name: a shell executes no part of a name.

colcon fills its templates with `expand_template`. In this process that function is replaced by ours, so everything written
for a shell is quoted before it is read, including scripts that run during a build.
"""

from __future__ import annotations

import contextlib
import importlib
import re
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

from colcon_core import subprocess
from colcon_core.plugin_system import satisfies_version
from colcon_core.shell import ShellExtensionPoint
from colcon_core.shell.template import expand_template

from coursekit.files import read_text
from coursekit.packages.folder_name import refusal
from coursekit.packages.windows_quotes import as_bytes, quoted_for_cmd, quoted_for_powershell, word_for_cmd
from coursekit.systems import operating_system

_WRITERS = (
    "colcon_core.shell.sh",
    "colcon_core.shell.bat",
    "colcon_bash.shell.bash",
    "colcon_zsh.shell.zsh",
    "colcon_powershell.shell.powershell",
)
_UTILITY = "_local_setup_util_sh.py"
_UTILITY_OF_POWERSHELL = "_local_setup_util_ps1.py"

_PATH_ALONE = re.compile(
    r"""^(\s*(?:export\s+)?\w+=          # NAME= or export NAME=
         |\s*\.\ +                       # . FILE
         |_colcon_\w+_unique_value\ \w+\ # a hook that puts a folder before or behind others
        )(?:"(/.*)"|(/.*))$""",
    re.M | re.X,
)
_COMMAND = re.compile(r'^(\s*|.*"\$\()(\$_colcon_python_executable) ', re.M)
_EXPORT = r"eval export $_listname=\"$_all_values\""
_SAFE_EXPORT = r'eval "export $_listname=\"\$_all_values\""'
"""`eval` gets the name of the variable instead of its value, which would be executed."""

_PRINTED = re.compile(r"^(FORMAT_STR_(?:SET_ENV_VAR|INVOKE_SCRIPT) = )('.*')", re.M)
_FIRST_FORMAT = "FORMAT_STR_COMMENT_LINE = "
_QUOTING = '''class Quoting(str):
    """A line for the shell, in which a value between quotation marks stands for itself."""

    def format_map(self, words):
        use = 'USE' + words.get('name', '')
        return super().format_map({key: self.plain(value, use) for key, value in words.items()})

    def plain(self, value, use):
        start = use + os.pathsep if value.startswith(use + os.pathsep) else ''
        end = os.pathsep + use if value.endswith(os.pathsep + use) else ''
        inner = value[len(start):len(value) - len(end)]
        quoted = inner.translate({ord(sign): 'ESCAPE' + sign for sign in 'SIGNS'})
        return start + SPELT + end


'''
_LETTERS_OF_POWERSHELL = """''.join(
            chr(one) if one < 128 else '$([char]0x%04X)' % one for one in memoryview(quoted.encode('utf-16-le')).cast('H')
        )"""
"""Characters by their codes: PowerShell decodes Python's output with the console's code page, which may lack them."""


class QuotingShell(ShellExtensionPoint):  # type: ignore[misc]
    """Not a shell: it makes the other shell extensions quote what they would leave unquoted."""

    PRIORITY = 10  # below the default: others do not need its scripts

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(ShellExtensionPoint.EXTENSION_POINT_VERSION, "^2.2")
        for name in _WRITERS:
            with contextlib.suppress(ModuleNotFoundError):  # PowerShell's exists on Windows only
                importlib.import_module(name).expand_template = expand_quoted  # type: ignore[attr-defined]
        if operating_system.WINDOWS:
            subprocess.escape_shell_argument = word_for_cmd  # colcon's function doubles single quotes as for a Unix shell

    def create_prefix_script(self, prefix_path: Path, merge_install: bool) -> list[Path]:
        """Write nothing."""
        return []

    def create_package_script(self, prefix_path: Path, pkg_name: str, hooks: Any) -> list[Path]:
        """Write nothing."""
        return []


def expand_quoted(template_path: Path, destination_path: Path, data: dict[str, Any]) -> None:
    """Call colcon's `expand_template`, and quote the result if it is for a shell.

    Raises RuntimeError, which colcon reports in one sentence, for a folder that no setup script can name.
    """
    why = refusal(destination_path.parent)
    if why:
        raise RuntimeError(why)
    expand_template(template_path, destination_path, data)
    change = _CHANGES.get(destination_path.name) or _CHANGES.get(destination_path.suffix)
    if change is not None:
        destination_path.write_bytes(as_bytes(change(read_text(destination_path)), destination_path.suffix))


def quoted(script: str) -> str:
    """Quote every path in a script with single quotes, and pass no values to `eval`.

    >>> print(quoted("_colcon_prefix=/home/José Luis/ws\\n$_colcon_python_executable \\"$x\\""))
    _colcon_prefix='/home/José Luis/ws'
    "$_colcon_python_executable" "$x"
    """
    script = _PATH_ALONE.sub(lambda match: match[1] + shlex.quote(match[2] or match[3]), script)
    return _COMMAND.sub(r'\1"\2" ', script).replace(_EXPORT, _SAFE_EXPORT)


def _quoted_utility(program: str, use: str = "$", escape: str = r"\\", signs: str = r'\\"$`', spelt: str = "quoted") -> str:
    """Quote the paths that this program prints, because setup scripts execute its output with `eval`."""
    quoting = _QUOTING.replace("USE", use).replace("ESCAPE", escape).replace("SIGNS", signs).replace("SPELT", spelt)
    program = program.replace(_FIRST_FORMAT, quoting + _FIRST_FORMAT, 1)
    return _PRINTED.sub(r"\1Quoting(\2)", program)


def _quoted_utility_of_powershell(program: str) -> str:
    """Likewise: `Invoke-Expression` executes its output, in which a backquote escapes the next character."""
    return _quoted_utility(program, "$env:", "`", '`$"', _LETTERS_OF_POWERSHELL)


_CHANGES: dict[str, Callable[[str], str]] = {
    **dict.fromkeys((".sh", ".bash", ".zsh"), quoted),
    ".bat": quoted_for_cmd,
    ".ps1": quoted_for_powershell,
    _UTILITY: _quoted_utility,
    _UTILITY_OF_POWERSHELL: _quoted_utility_of_powershell,
}
"""The correction of each file, by its name or its suffix."""
