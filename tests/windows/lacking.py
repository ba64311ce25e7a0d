"""What Wine lacks and Windows has: three libraries, made by zig; threads for OpenCV; and Git's small commands."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from .wine import COMMANDS, HOME, VENV

HERE = Path(__file__).parent
MATHS = b"api-ms-win-crt-math-l1-1-0.dll"
OURS = b"ckw-ms-win-crt-math-l1-1-0.dll"
"""By what name the modules import C's maths, and the name as long that they get instead."""
_DOUBLE = "cabs carg ccos ccosh cexp cimag clog clog10 conj cpow cproj creal csin csinh csqrt ctan ctanh"
COMPLEX = {name + end for name in _DOUBLE.split() for end in ("", "f")}
"""What complex_functions.c computes."""
SYSTEM = b"ntdll.dll"
CALLS = b"ckntd.dll"
"""By what name programs import the system's own calls, and the name as long that zig gets instead."""
ANSWERED = {"NtLockFile", "NtUnlockFile", "NtQueryAttributesFile"}
"""What system_calls.c answers."""
_IMPORTS = """
import sys, pefile
for file in sys.argv[2:]:
    pe = pefile.PE(file, fast_load=True)
    pe.parse_data_directories([pefile.DIRECTORY_ENTRY["IMAGE_DIRECTORY_ENTRY_IMPORT"]])
    for library in getattr(pe, "DIRECTORY_ENTRY_IMPORT", []):
        if library.dll in sys.argv[1].encode().split():
            print(file, *(one.name.decode() for one in library.imports if one.name), sep="|")
"""
_tools = HOME / "tools" / "bin" / "python"
_system = HOME / "prefix" / "drive_c" / "windows" / "system32"


def get_tools() -> None:
    """zig, which compiles for Windows, and what reads its programs; from PyPI, in an environment of their own."""
    if not _tools.is_file():
        subprocess.run([sys.executable, "-m", "venv", HOME / "tools"], check=True)
        subprocess.run([_tools, "-m", "pip", "install", "-q", "ziglang", "pefile"], check=True)


def add_random_bytes() -> None:
    """The library that modules written in Rust need."""
    _link("bcryptprimitives.dll", HERE / "random_bytes.c", "-ladvapi32")


def add_complex_functions() -> None:
    """Complex maths for numpy and scipy: their modules are pointed to a library of ours that has it, the rest is Wine's."""
    wanted: set[str] = set()
    for file, names in _imports((MATHS, OURS), "*.pyd", "*.dll").items():
        if names & COMPLEX:
            file.write_bytes(file.read_bytes().replace(MATHS, OURS))
        data = file.read_bytes()
        wanted |= names if OURS in data else set()
    exports = _exports("complex.def", COMPLEX, "ucrtbase", wanted - COMPLEX)
    _link(OURS.decode(), HERE / "complex_functions.c", exports, "-lucrtbase", "-fno-builtin")


def add_system_calls() -> None:
    """What zig asks of the system: its program is pointed to a library of ours that answers as Windows does."""
    wanted: set[str] = set()
    for file, names in _imports((SYSTEM, CALLS), "zig.exe").items():
        file.write_bytes(file.read_bytes().replace(SYSTEM + b"\0", CALLS + b"\0"))
        wanted |= names
    exports = _exports("system_calls.def", ANSWERED, "ntdll", wanted - ANSWERED)
    _link(CALLS.decode(), HERE / "system_calls.c", exports, "-lntdll")


def _exports(name: str, ours: set[str], library: str, theirs: set[str]) -> Path:
    """What a library of ours offers: functions of its own, and those of one of Wine's that it passes on."""
    file = HOME / name
    lines = [f"  {symbol}=shim_{symbol}" for symbol in sorted(ours)] + [
        f"  {symbol}={library}.{symbol}" for symbol in sorted(theirs)
    ]
    file.write_text("\n".join(["EXPORTS", *lines, ""]), encoding="utf-8")
    return file


def add_commands() -> None:
    """echo and its like, which stand for other programs in tests."""
    COMMANDS.mkdir(exist_ok=True)
    for name in ("echo", "true", "false", "sleep"):
        program = COMMANDS / f"{name}.exe"
        _zig(HERE / "commands.c", "-lkernel32", "-fno-builtin", "-Wl,-e,mainCRTStartup", "-o", str(program))


def one_thread_for_opencv() -> None:
    """OpenCV's threads raise "Unknown exception" in Wine."""
    file = VENV / "Lib" / "site-packages" / "wine_threads.pth"
    file.write_text("import cv2; cv2.setNumThreads(1)\n", encoding="utf-8")


def _imports(libraries: tuple[bytes, ...], *patterns: str) -> dict[Path, set[str]]:
    """What files of installed packages import from these libraries, by file."""
    site = VENV / "Lib" / "site-packages"
    every = (file for pattern in patterns for file in site.rglob(pattern))
    files = [file for file in every if any(name in file.read_bytes() for name in libraries)]
    names = b" ".join(libraries).decode()
    said = subprocess.run([_tools, "-c", _IMPORTS, names, *files], check=True, stdout=subprocess.PIPE).stdout
    rows = (line.split("|") for line in said.decode().splitlines())
    return {Path(file): set(functions) for file, *functions in rows}


def _link(name: str, *words: Path | str) -> None:
    """Make a library and give it to Wine."""
    _zig("-shared", *words, "-o", name)
    shutil.copy(HOME / name, _system)


def _zig(*words: Path | str) -> None:
    """Compile for Windows what needs no C library."""
    zig = [_tools, "-m", "ziglang", "cc", "-target", "x86_64-windows-gnu", "-O1", "-nostdlib"]
    subprocess.run([*zig, *words], check=True, cwd=HOME)
