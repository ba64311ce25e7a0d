"""Commands of CMake that set entries of its cache, for files that it reads before all others."""

from __future__ import annotations


def cache_entry(name: str, value: str, kind: str = "STRING") -> str:
    """Return the command that sets an entry, whatever was there.

    >>> cache_entry("CMAKE_NM", "/usr/bin/nm", "INTERNAL")
    'set(CMAKE_NM [=[/usr/bin/nm]=] CACHE INTERNAL "" FORCE)\\n'
    """
    return f'set({name} {bracketed(value)} CACHE {kind} "" FORCE)\n'


def bracketed(value: str) -> str:
    """Quote a value for CMake without interpreting its content.

    >>> bracketed('my "$ENV{HOME}"'), bracketed("a]=]b")
    ('[=[my "$ENV{HOME}"]=]', '[==[a]=]b]==]')
    """
    level = "="
    while f"]{level}]" in value:
        level += "="
    return f"[{level}[{value}]{level}]"
