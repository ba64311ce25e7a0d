"""Compiled programs: nav2's costmaps, outlines, lines and paths."""

from __future__ import annotations

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program


def test_the_names_do_what_they_say(session, build):
    path = build("costmaps", program("costmaps.cpp"))
    process = session.launch(make_process(session, path, [], name="costmaps"))
    assert process.wait(20.0) == 0, process.output
    assert process.output.splitlines() == [
        "1 3 2 00",
        "-0.75 0.25 11 3 0 1.75 3",
        "9 7 -0.5",
        "1 16 2540",
        "1 3 2540",
        "0 254 254",
        "1000",
        "0.1 0.223607 0.9 2.2",
        "-0.21 16 10 1",
        "0,0 1,0 2,-1 3,-1 0",
        "3 2 3 1 1 1",
        "a_b_c a/b /a/b 3 a 4",
        "100 200 100 0",
        "100 100 100 0",
        "100 100 100 255",
        "100 252 100 0",
        "100 255 0",
    ]
