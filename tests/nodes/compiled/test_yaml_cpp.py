"""yaml-cpp's names where the system has no yaml-cpp: nodes, texts that are read and written."""

from __future__ import annotations

import pytest

from coursekit.nodes.compiled.frames import Unpacker
from coursekit.nodes.compiled.yaml_nodes import MOST, nodes
from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program

ROBOT = """# A robot.
name: mouse
speed: 0.25
on: yes
code: 0x10
none: ~
wheels:
  - {side: left, radius: 0.1}
  - side: right
    radius: 0.2
limits: &limits
  low: 1
  high: 2.5
gains: [1, 2.5, 3e-2]
spots: [[1, 2], [3, 4]]
same: *limits
"""
GROWING = "a: &a [1]\n" + "".join(
    f"{name}: &{name} [{', '.join(['*' + before] * 30)}]\n" for before, name in zip("abcdef", "bcdefg", strict=True)
)
"""Each line stands for thirty of the one before."""
READ = """mouse20.2511610071
left0.1 right0.2 low=1 high=2.5 3141
yaml-cpp: error at line 2, column 7: bad conversion
invalid node; first invalid key: "no"
yaml-cpp: error at line 2, column 7: operator[] call on a scalar (key: "x")
yaml-cpp: error at line 14, column 8: bad conversion
bad file: /no/such/file.yaml
""".splitlines()
WRITTEN = """name: "robot: one"
pose:
  x: 2
  up: true
list:
  - 1
  - two
321two
waypoints:
  - x: 0.5
    on: true
  - x: 1.25
    on: true
gains: [1, 2, 3]
none: ~
text: "5"
1
1.25[a, {b: c}]
# what a robot may do
speed: 0.5  # m/s
spot: [1, 2]  # in m
wheels:  # left first
  - one
  - two  # of two
  # lines
# nothing""".splitlines()


def test_nodes_are_read_changed_and_written(session, build, tmp_path):
    (tmp_path / "robot.yaml").write_text(ROBOT)
    path = build("yaml_cpp", program("yaml_cpp.cpp"))
    process = session.launch(make_process(session, path, name="yaml_cpp", cwd=tmp_path))
    assert process.wait(20.0) == 0, process.output
    lines = process.output.splitlines()
    assert lines[:7] == READ
    assert lines[7].startswith("yaml-cpp: error at line 1, column 9: ")
    assert lines[8] == "21!!oddinf931"
    assert lines[9:] == WRITTEN


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("a: b: c", "mapping values are not allowed here"),
        ("&a [*a]", "deep"),
        (GROWING, str(MOST)),
        ("[" * 5000, "deep"),
    ],
)
def test_texts_that_are_none_or_grow_without_end_are_refused_in_words(text, why):
    frame = Unpacker(nodes(text))
    assert frame.integer() == -1
    frame.integer(), frame.integer()
    assert why in frame.text()
