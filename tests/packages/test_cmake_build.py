"""What is told of CMake's and the compiler's output."""

from types import SimpleNamespace

import pytest
from colcon_core.event.output import StdoutLine

from coursekit.packages.cmake_build import ErrorsAside

NINJA = (
    b"[1/2] Building CXX object a.cpp.o\n",
    b"%sFAILED: %sCMakeFiles/a.dir/a.cpp.o \n",
    b"/usr/bin/g++ -c a.cpp\n",
    b"a.cpp:1:1: %serror: %sexpected something\n",
    b"ninja: build stopped: subcommand failed.\n",
)


@pytest.mark.parametrize("colors", [(b"", b""), (b"\x1b[31m", b"\x1b[0m")])
def test_of_what_ninja_prints_the_compiler_s_words_are_kept(colors):
    """In color, too: a kernel of Jupyter asks every program for it."""
    passed = []
    listening = ErrorsAside(SimpleNamespace(put_event_into_queue=passed.append))
    for line in NINJA:
        listening.put_event_into_queue(StdoutLine(line % colors if b"%s" in line else line))
    assert listening.errors == [b"a.cpp:1:1: error: expected something\n"]
    assert len(passed) == len(NINJA) - 1
