"""colcon's scripts for PowerShell and cmd: each path in them is a path, whatever its folders are called."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from coursekit.packages.shell_quotes import QuotingShell, expand_quoted
from coursekit.packages.windows_quotes import as_bytes, quoted_for_cmd, quoted_for_powershell
from coursekit.systems import operating_system
from tests.needs import real_windows

HOSTILE = r"C:\Users\ñ o' $(calc) `calc` %d & ^ ! %PATH%"
TEMPLATES = Path(importlib.util.find_spec("colcon_core").origin).parent / "shell" / "template"  # type: ignore[union-attr, arg-type]


def read_by_powershell(text: str) -> str:
    """The value of one word of PowerShell, by its rules; AssertionError where a part of it would be replaced or run."""
    if text.startswith("'"):
        assert re.fullmatch("'(?:[^'\u2018\u2019\u201a\u201b]|['\u2018\u2019\u201a\u201b]{2})*'", text), text
        return re.sub("(['\u2018\u2019\u201a\u201b]){2}", r"\1", text[1:-1])
    inner = re.sub(r"[:;][$]env:\w+$", "", text.removeprefix('"').removesuffix('"'))  # what the variable was before
    assert inner.isascii(), "the console's code page may have no such letters"
    units = "".join(map(_read_token, re.findall(r"`.|[$][(]\[char\]0x[0-9A-F]{4}[)]|.", inner)))
    return units.encode("utf-16-le", "surrogatepass").decode("utf-16-le")


def _read_token(token: str) -> str:
    if token.startswith("$("):
        return chr(int(token[-5:-1], 16))
    assert token not in ("$", '"', "`"), token
    return token[-1]


@pytest.mark.parametrize("name", [HOSTILE, "C:\\\u2018; calc; \u2019", "C:\\Users\\vera", r"\\server\share\$home"])
@pytest.mark.parametrize(
    "line",
    [
        '    $_colcon_python_executable="{}"',
        '. "{}"',
        '_colcon_prefix_chain_powershell_source_script "{}"',
        'colcon_prepend_unique_value PYTHONPATH "$env:COLCON_CURRENT_PREFIX\\{}"',
    ],
)
def test_powershell_reads_a_path_as_it_is(name: str, line: str) -> None:
    quoted = quoted_for_powershell(line.format(name))
    word = quoted[quoted.index("'") :]
    assert read_by_powershell(word) == name and "COLCON_CURRENT_PREFIX" not in quoted


def test_powershell_still_finds_what_lies_below_the_prefix() -> None:
    lines = 'colcon_prepend_unique_value PYTHONPATH "$env:COLCON_CURRENT_PREFIX\\Lib\\site-packages"\n'
    lines += '_colcon_prefix_chain_powershell_source_script "$env:COLCON_CURRENT_PREFIX\\local_setup.ps1"\n'
    lines += '$_colcon_python_executable="python"\n'
    assert quoted_for_powershell(lines) == lines


def test_powershell_takes_brackets_in_a_path_for_no_pattern() -> None:
    quoted = quoted_for_powershell("if (Test-Path $_colcon_package_source_powershell_script) {\n(Get-Item $PSCommandPath)")
    first, second = quoted.splitlines()
    assert first == "if (Test-Path -LiteralPath $_colcon_package_source_powershell_script) {"
    assert second == "(Get-Item -LiteralPath $PSCommandPath)"


def test_what_the_utility_prints_is_read_as_values_by_powershell(tmp_path: Path) -> None:
    """The lines that setup.ps1 gives to Invoke-Expression."""
    shell = SimpleNamespace(
        FORMAT_STR_COMMENT_LINE="# {comment}",
        FORMAT_STR_SET_ENV_VAR='Set-Item -Path "Env:{name}" -Value "{value}"',
        FORMAT_STR_USE_ENV_VAR="$env:{name}",
        FORMAT_STR_INVOKE_SCRIPT='_colcon_prefix_powershell_source_script "{script_path}"',
        FORMAT_STR_REMOVE_LEADING_SEPARATOR="",
        FORMAT_STR_REMOVE_TRAILING_SEPARATOR="",
    )
    name = "ñ 🤖 $(calc) `calc` %d & ^ ! \u201d $x"
    name += "" if operating_system.WINDOWS else ' "$(calc)"'
    install = tmp_path / name
    share = install / "talks" / "share"
    (share / "talks").mkdir(parents=True)
    (share / "talks" / "package.dsv").write_text("prepend-non-duplicate;SOME_PATH;here\nsource;share/talks/more.ps1\n")
    (share / "talks" / "more.ps1").touch()
    (share / "colcon-core" / "packages").mkdir(parents=True)
    (share / "colcon-core" / "packages" / "talks").touch()
    utility = install / "_local_setup_util_ps1.py"
    expand_quoted(TEMPLATES / "prefix_util.py.em", utility, {"shell_extension": shell})
    done = subprocess.run([sys.executable, utility, "ps1"], capture_output=True, encoding="utf-8", check=True)
    values = [line for line in done.stdout.splitlines() if "SOME_PATH" in line and "Value" in line]
    scripts = [line.partition(" ")[2] for line in done.stdout.splitlines() if line.startswith("_colcon_prefix_powershell")]
    assert [read_by_powershell(value.partition("-Value ")[2]) for value in values] == [str(install / "talks" / "here")]
    assert [Path(read_by_powershell(script)) for script in scripts] == [share / "talks" / "more.ps1"]


def test_cmd_is_given_a_variable_where_it_would_read_a_path_twice() -> None:
    lines = f'call:colcon_prepend_unique_value PYTHONPATH "{HOSTILE}"\n    set "_colcon_python_executable={HOSTILE}"'
    first, second, third = quoted_for_cmd(lines).splitlines()
    assert first == f'set "_colcon_path={HOSTILE.replace("%", "%%")}"'
    assert second == 'call:colcon_prepend_unique_value PYTHONPATH "%%_colcon_path%%"'
    assert third.strip() == f'set "_colcon_python_executable={HOSTILE.replace("%", "%%")}"'
    kept = 'call:colcon_prepend_unique_value PYTHONPATH "%COLCON_CURRENT_PREFIX%\\Lib"'
    assert quoted_for_cmd(kept) == kept


def test_each_shell_gets_the_line_ends_and_letters_that_it_reads(tmp_path: Path) -> None:
    assert as_bytes("@echo off\ngoto :eof\n", ".bat") == b"@echo off\r\ngoto :eof\r\n"
    assert as_bytes("'ñ'\n", ".ps1") == b"\xef\xbb\xbf'\xc3\xb1'\n" and as_bytes("'n'\n", ".ps1") == b"'n'\n"
    data = {"hooks": [], "python_executable": "C:/x/python.exe", "merge_install": False}
    expand_quoted(TEMPLATES / "prefix.bat.em", tmp_path / "local_setup.bat", data)
    text = (tmp_path / "local_setup.bat").read_bytes()
    assert text.count(b"\r\n") == text.count(b"\n") > 100 and b"\r\r" not in text


@pytest.mark.skipif(not operating_system.WINDOWS, reason="cmd is Windows'")
@real_windows("its cmd reads the line of a call once, Windows' reads it twice")
def test_cmd_puts_such_a_folder_before_the_others(tmp_path: Path) -> None:
    folder = r"C:\100%d ^ & mine"
    hook = tmp_path / "hook.bat"
    expand_quoted(TEMPLATES / "hook_prepend_value.bat.em", hook, {"name": "CK_PATHS", "subdirectory": folder})
    (tmp_path / "try.bat").write_bytes(f'@echo off\r\ncall "{hook}"\r\nset CK_PATHS\r\n'.encode("oem"))
    done = subprocess.run(["cmd", "/d", "/c", str(tmp_path / "try.bat")], capture_output=True, encoding="oem", check=True)
    assert done.stdout.strip() == f"CK_PATHS={folder}"


def test_on_windows_colcon_s_command_lines_name_folders_with_single_quotation_marks(monkeypatch):
    from colcon_core import subprocess as commands

    monkeypatch.setattr(commands, "escape_shell_argument", commands.escape_shell_argument)
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    QuotingShell()
    assert commands.escape_shell_argument(rf"{HOSTILE}\set.bat") == rf'"{HOSTILE}\set.bat"'
    assert commands.escape_shell_argument("&&") == "&&"
