"""What a format is to the fuzzer: who reads it, and what may come out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Faults = tuple[type[BaseException], ...]
ROOT = Path(__file__).resolve().parents[2]
SHARE, MAPS = ROOT / "coursekit" / "share", ROOT / "maps"
XML = (
    "<", ">", "/", '"', "&", "&#0;", "<!--", "]]>", "<![CDATA[", "<?x?>", "nan", "1e999", "-1", "\x00", "é", "${1/0}",
    "$(x)", "<!DOCTYPE r [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;&a;'>]>", "&b;",
    "${'a'*9**9}", "${9**9**9}",
)  # fmt: skip
YAML = (
    "- ", ": ", "{", "}", "[", "]", "&a ", "*a", "!!python/name:os.system ", "!!int x", "|\n", "nan", ".inf", "1e999",
    "null", "2001-99-99", "~", "\t", "\x00", "é", "'", '"', "-1", "9" * 40, "0x", "[" * 200, "<<: *a\n", "? ", "---\n",
    "%YAML 9\n",
)  # fmt: skip
TEXT = (
    "", " ", "\n", "\r", "\t", "\x00", "é", "(", ")", '"', "\\", "$", "${", "}", ";", ",", "-1", "9" * 40, "nan", "[<=", "]",
    "=", "#", "@",
)  # fmt: skip


@dataclass(frozen=True)
class Format:
    """What is read: `name` and ending, a sound example, who reads a file, and what that may raise."""

    name: str
    ending: str
    sound: Callable[[], bytes]
    read: Callable[[Path], Any]
    faults: Callable[[], Faults]
    pieces: tuple[str, ...] = ()
    """What damages it worst; bytes where it is no text."""



def values_only() -> Faults:
    """What most readers raise."""
    return ValueError, OSError
