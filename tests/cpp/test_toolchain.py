"""What compiles C++ here: on Windows zig alone, in words that CMake reads there; where something is missing, it is named."""

import pytest

from coursekit.cli import checks
from coursekit.cpp import toolchain
from coursekit.cpp.toolchain import NoToolchain, find_toolchain
from coursekit.systems import operating_system

PROGRAMS = {"zig": "C:/Users/José Luis/ziglang/zig.EXE", "cmake": "C:/cmake.EXE", "ninja": "C:/ninja.EXE"}


@pytest.fixture
def programs(monkeypatch):
    """The programs of a computer with Windows, by name; what was found on this computer is forgotten, before and after."""
    there = dict(PROGRAMS)
    find_toolchain.cache_clear()
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    monkeypatch.setattr(toolchain.shutil, "which", lambda name, path=None: f"C:/MinGW/{name}.EXE")
    monkeypatch.setattr(toolchain, "_program", lambda name, _folder: there.get(name))
    monkeypatch.setattr(toolchain, "_zig", lambda: there.get("zig"))
    yield there
    find_toolchain.cache_clear()


def test_on_windows_zig_compiles_for_it_whatever_else_is_called_a_compiler(programs):
    tools = find_toolchain()
    words = ("-target", "x86_64-windows-gnu", "-fno-sanitize=undefined")
    assert (tools.cxx, tools.cc) == ((programs["zig"], "c++", *words), (programs["zig"], "cc", *words))
    assert (tools.generator, tools.system) == ("Ninja", None)


def test_zig_is_one_program_for_all_that_cmake_asks_of_it(programs):
    told, zig = find_toolchain().defines(), programs["zig"]
    assert told["CMAKE_CXX_COMPILER"] == f"{zig};c++;-target;x86_64-windows-gnu;-fno-sanitize=undefined"
    assert told["CMAKE_AR"] == zig
    assert told["CMAKE_C_CREATE_STATIC_LIBRARY"] == told["CMAKE_CXX_CREATE_STATIC_LIBRARY"]
    assert told["CMAKE_CXX_CREATE_STATIC_LIBRARY"].startswith("<CMAKE_AR> ar rcs <TARGET>")


@pytest.mark.parametrize(("gone", "called"), [("zig", r"C\+\+ compiler"), ("cmake", "CMake"), ("ninja", "ninja here")])
def test_what_is_missing_on_windows_is_named_with_what_brings_it(programs, gone, called):
    del programs[gone]
    with pytest.raises(NoToolchain, match=rf'there is no {called}.*pip install "coursekit\[cpp\]"'):
        find_toolchain()


def test_the_doctor_names_the_command_and_finds_no_fault(programs):
    del programs["zig"]
    check = checks.cpp_tools()
    assert "coursekit cpp" in check.finding and check.fault == ""
