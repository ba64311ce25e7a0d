"""`coursekit cpp` and what the lab says of C++."""

from __future__ import annotations

import argparse
import re
from types import SimpleNamespace

import pytest

from coursekit.cli import cpp
from coursekit.cpp.toolchain import NoToolchain
from tests.needs import ON_WINDOWS

TOOLS = SimpleNamespace(cxx=("/usr/bin/g++",), cmake="/usr/bin/cmake", generator="Ninja")


@pytest.fixture
def no_compiler(monkeypatch):
    def find():
        raise NoToolchain("there is none")

    find.cache_clear = lambda: None
    monkeypatch.setattr(cpp, "find_toolchain", find)


def test_the_wheels_are_those_of_the_extra():
    assert sorted(re.match("[a-z]+", word)[0] for word in cpp.wheels()) == ["cmake", "ninja", "ziglang"]


@pytest.mark.skipif(ON_WINDOWS, reason="a child there is another program")
def test_what_pip_cannot_get_is_said(no_compiler, monkeypatch, capsys):
    asked = []
    monkeypatch.setattr(cpp.subprocess, "call", lambda words: asked.append(words) or 1)
    assert cpp.run(argparse.Namespace()) == 1
    assert asked[0][1:4] == ["-m", "pip", "install"] and set(cpp.wheels()) < set(asked[0])
    said = capsys.readouterr()
    assert "130 MB" in said.out and "online" in said.err


def test_a_runtime_that_is_there_is_told_at_once(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(cpp, "runtime_folder", lambda tools: tmp_path)
    assert cpp.make_ready(TOOLS) == 0
    assert capsys.readouterr().out == "C++ is ready (0 s): /usr/bin/g++, /usr/bin/cmake, Ninja\n"


@pytest.mark.skipif(ON_WINDOWS, reason="the program is a shell script")
def test_a_compiler_that_fails_is_told(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(cpp, "runtime_folder", lambda tools: tmp_path / "no" / "runtime")
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(cpp.sys, "executable", str(_program(tmp_path, "echo no room left >&2; exit 3")))
    assert cpp.make_ready(TOOLS) == 1
    assert capsys.readouterr().err == f"no room left\n\n{cpp._FAILED}\n"


def _program(folder, script):
    path = folder / "program"
    path.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
    path.chmod(0o755)
    return path


def test_the_lab_offers_it_where_there_is_no_compiler(no_compiler, capsys):
    cpp.offer({})
    assert "coursekit cpp" in capsys.readouterr().out
