"""Corrects setup scripts of Windows' shells for folders with any name: PowerShell executes no part of one."""

from __future__ import annotations

import re

QUOTES = "'\u2018\u2019\u201a\u201b"
"""The characters that end a single-quoted string in PowerShell: curly quotes count as straight ones."""
_ABSOLUTE = r"(?:[A-Za-z]:|\\\\|/).*"
_ALONE = re.compile(
    r"""^(\s*(?:\$_colcon_python_executable=|\.\ |_colcon_prefix_chain_powershell_source_script\ ))"""
    rf""""({_ABSOLUTE})"$""",
    re.M | re.X,
)
_HOOK = re.compile(rf'^(colcon_\w+_unique_value \w+ )"\$env:COLCON_CURRENT_PREFIX[\\/]({_ABSOLUTE})"$', re.M)
_WILD = re.compile(r"\b(Test-Path|Get-Item) (?=\$_colcon_\w+_param\b|\$_colcon_package_source|\"\$|\$PSCommandPath)")

_BARE = re.compile(r"[\w.:\\/-]+", re.ASCII)
_OPERATORS = (";", "|", "&&", "||")
_CMD_HOOK = re.compile(rf'^(call:colcon_\w+_unique_value \w+ )"({_ABSOLUTE})"$', re.M)
_CMD_CHAIN = re.compile(rf'^(call:_colcon_prefix_chain_bat_call_script )"({_ABSOLUTE})"$', re.M)
_CMD_PYTHON = re.compile(rf'^(\s*set "_colcon_python_executable=)({_ABSOLUTE})"$', re.M)


def word_for_cmd(word: str) -> str:
    r"""Quote an argument for cmd, which knows only double quotes; its own commands and operators stay unquoted.

    >>> print(word_for_cmd(r"C:\Users\Tim O'Neil\setup.bat"), word_for_cmd("&&"), word_for_cmd("set"))
    "C:\Users\Tim O'Neil\setup.bat" && set
    """
    return word if word in _OPERATORS or _BARE.fullmatch(word) else f'"{word}"'


def powershell_quote(text: str) -> str:
    """Quote a word so that PowerShell expands nothing in it.

    >>> print(powershell_quote("C:/Tim's $(calc)"))
    'C:/Tim''s $(calc)'
    """
    return "'" + "".join(sign * 2 if sign in QUOTES else sign for sign in text) + "'"


def quoted_for_powershell(script: str) -> str:
    r"""Quote every path in a script of colcon's, and do not look for absolute folders below the prefix.

    >>> print(quoted_for_powershell('. "C:\\$(calc)\\package.ps1"'))
    . 'C:\$(calc)\package.ps1'
    """
    script = _ALONE.sub(lambda match: match[1] + powershell_quote(match[2]), script)
    script = _HOOK.sub(lambda match: match[1] + powershell_quote(match[2]), script)
    return _WILD.sub(r"\1 -LiteralPath ", script)


def quoted_for_cmd(script: str) -> str:
    r"""Escape percent signs and carets in the paths of a batch file of colcon's.

    `call` parses its line twice, so it gets the name of a variable instead of the path.

    >>> print(quoted_for_cmd('call:colcon_prepend_unique_value PYTHONPATH "C:\\100%d"'))
    set "_colcon_path=C:\100%%d"
    call:colcon_prepend_unique_value PYTHONPATH "%%_colcon_path%%"
    """
    for line in (_CMD_HOOK, _CMD_CHAIN):
        script = line.sub(lambda match: f'set "_colcon_path={_percent(match[2])}"\n{match[1]}"%%_colcon_path%%"', script)
    return _CMD_PYTHON.sub(lambda match: f'{match[1]}{_percent(match[2])}"', script)


def as_bytes(script: str, ending: str) -> bytes:
    r"""Encode a script for its shell: cmd needs Windows line ends and its code page, PowerShell a UTF-8 byte order mark.

    >>> as_bytes("set A=1\n", ".bat"), as_bytes("$a = 'é'", ".ps1")[:3]
    (b'set A=1\r\n', b'\xef\xbb\xbf')
    """
    if ending == ".bat":
        lines = script.replace("\n", "\r\n")
        try:
            return lines.encode("oem")
        except (LookupError, UnicodeEncodeError):  # not on Windows, or a character that is not in this computer's code page
            return lines.encode()
    return script.encode("utf-8-sig" if ending == ".ps1" and not script.isascii() else "utf-8")


def _percent(path: str) -> str:
    return path.replace("%", "%%")


__all__ = ["as_bytes", "powershell_quote", "quoted_for_cmd", "quoted_for_powershell"]
