"""Windows' access control lists, in its own notation (SDDL); other systems have none."""

from __future__ import annotations

import ctypes
from pathlib import Path
from typing import Any

THERE = hasattr(ctypes, "WinDLL")
"""Whether this system has such lists."""
_FILE, _DACL, _PROTECTED = 1, 0x4, 0x80000000
_TOKEN_QUERY, _TOKEN_USER = 0x8, 1


def read(path: Path) -> str:
    """Return the list of a file or folder; OSError when it cannot be read."""
    descriptor, text = ctypes.c_void_p(), ctypes.c_wchar_p()
    names = _advapi()
    _check(names.GetNamedSecurityInfoW(str(path), _FILE, _DACL, None, None, None, None, ctypes.byref(descriptor)), path)
    try:
        convert = names.ConvertSecurityDescriptorToStringSecurityDescriptorW
        if not convert(descriptor, 1, _DACL, ctypes.byref(text), None):
            raise _last_error(path)
        return text.value or ""
    finally:
        _free(descriptor, text)


def write(path: Path, access: str) -> None:
    """Set the list of a file or folder, without inherited entries; OSError when that is refused."""
    descriptor = ctypes.c_void_p()
    if not _advapi().ConvertStringSecurityDescriptorToSecurityDescriptorW(access, 1, ctypes.byref(descriptor), None):
        raise _last_error(path)
    try:
        if not _advapi().SetFileSecurityW(str(path), ctypes.c_ulong(_DACL | _PROTECTED), descriptor):
            raise _last_error(path)
    finally:
        _free(descriptor)


def user() -> str:
    """Return the SID of the user who runs this program, such as S-1-5-21-...-1001."""
    token, size, text = ctypes.c_void_p(), ctypes.c_ulong(), ctypes.c_wchar_p()
    kernel, names = _kernel(), _advapi()
    if not names.OpenProcessToken(ctypes.c_void_p(-1), _TOKEN_QUERY, ctypes.byref(token)):
        raise _last_error(Path())
    try:
        names.GetTokenInformation(token, _TOKEN_USER, None, 0, ctypes.byref(size))
        data = ctypes.create_string_buffer(size.value)
        if not names.GetTokenInformation(token, _TOKEN_USER, data, size, ctypes.byref(size)):
            raise _last_error(Path())
        number = ctypes.c_void_p.from_buffer(data)  # the first word of the result points to it
        if not names.ConvertSidToStringSidW(number, ctypes.byref(text)):
            raise _last_error(Path())
        return text.value or ""
    finally:
        kernel.CloseHandle(token)
        _free(text)


def _advapi() -> Any:
    return ctypes.WinDLL("advapi32", use_last_error=True)  # type: ignore[attr-defined]


def _kernel() -> Any:
    return ctypes.WinDLL("kernel32", use_last_error=True)  # type: ignore[attr-defined]


def _free(*given: Any) -> None:
    for pointer in given:
        _kernel().LocalFree(ctypes.cast(pointer, ctypes.c_void_p))


def _check(code: int, path: Path) -> None:
    if code:
        raise OSError(None, ctypes.FormatError(code), str(path), code)  # type: ignore[attr-defined]


def _last_error(path: Path) -> OSError:
    code = ctypes.get_last_error()  # type: ignore[attr-defined]
    return OSError(None, ctypes.FormatError(code), str(path), code)  # type: ignore[attr-defined]


__all__ = ["read", "user", "write"]
