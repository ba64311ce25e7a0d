"""C's messages: a program in C, and the same in C++, under a watch for memory that is lost or used wrongly."""

from __future__ import annotations

import subprocess

import pytest

from tests.nodes.compiled.conftest import PROGRAMS, ROOM

_WATCH = ["-g", "-Wall", "-Wextra", "-Werror", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]


@pytest.mark.parametrize("compiler", [["gcc", "-std=gnu99"], ["g++", "-std=gnu++17", "-x", "c++"]], ids=["c", "cpp"])
def test_they_are_made_filled_compared_copied_and_given_back(cpp_library, tmp_path, compiler):
    folders = [f"-I{ROOM / 'include'}", f"-I{cpp_library / 'include'}"]
    program = tmp_path / "messages"
    command = [*compiler, *_WATCH, *folders, str(PROGRAMS / "messages.c"), "-o", str(program)]
    built = subprocess.run(command, capture_output=True, encoding="utf-8")
    if "cannot find" in built.stderr:
        pytest.skip("the compiler has no sanitizers")
    assert built.returncode == 0, built.stderr
    done = subprocess.run([str(program)], capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert [line for line in lines if not line.startswith("ok ")] == []
    assert len(lines) == 21
