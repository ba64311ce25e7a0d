"""Small matrices of compiled programs, boards of markers, and what two views tell: the answers are those of OpenCV."""

from __future__ import annotations

import pytest

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program


@pytest.fixture
def said(session, build, tmp_path):
    def lines(name):
        process = session.launch(make_process(session, build(name, program(f"{name}.cpp")), name=name, cwd=tmp_path))
        assert process.wait(20.0) == 0, process.output
        return process.output.splitlines()

    return lines


def test_small_matrices_compute_and_are_written_by_functions(said):
    assert said("small_matrices") == [
        "1[2, -7, 4][-2, 0, 3][-1, -2, -3][1, 2, 3][1, 2, 3][0.6, 0.8]",
        "[255, 0, 14]21",
        "0.005 -0.8 0 50000 451",
        "00[2, 3]",
        "[200, 250, 1][0, 250, 120][160, 120, 1][0, 160;",
        " 250, 120]",
        "[2, 4;",
        " 6, 8][-0.5, -1.5][1, 1, 1, 1]10",
        "1 500 250 4000 479",
        "[0.5, 2;",
        " 4.5, 8]30[1, 4][2][1, 0;",
        " 0, 3]",
        "[1, 2;",
        " 3, 4][2, 4][0, 0, 1]",
        "refused -215",
        "233[1, 2;",
        " 3, 4][1, 2;",
        " 3, 4]1",
        "3241099511627776",
    ]


def test_small_numbers_views_and_limits_count(said):
    assert said("small_numbers") == [
        "1 5e+07 1e+08 2e-16 1e+08 1e-36",
        "000 400 0 16",
        "120 160",
        "[  1,   2,   0,   0;",
        "   0,   1,   2,   0;",
        "   3,   0,   1,   2]110[  2,   2,   2]6",
        "[  1,   0,   0,   0;",
        "   0,   5,   0,   0;",
        "   3,   0,   5,   0][  1,   5,   5]",
        "2213",
        "1[-1, -1]1 0[2, 1] refused [1, 0]",
    ]


def test_a_board_of_markers_has_one_pose(said):
    assert said("boards") == [
        "[3 x 2]0.04 0.01 510[0, 0.089999996, 0;",
        " 0.039999999, 0.089999996, 0;",
        " 0.039999999, 0.049999997, 0;",
        " 0, 0.049999997, 0][0.14, 0, 0]",
        "[600 x 400]6 6",
        "100 -100 15 300 200",
        "0",
    ]


def test_two_views_shapes_and_numbers(said):
    assert said("two_views") == [
        "60 10 -100",
        "60 460 0",
        "[3 x 3]1",
        "128 128 109",
        "[3 x 3]-40 10",
        "2 -2[3 x 5 from (9, 8)]90",
        "160 20[0, 4]",
        "0.174578 0.000608363 0.00108439 3.57789e-06 1.84961e-10 -5.17329e-08 -1.24323e-10 ",
        "[3, 0, -2;",
        " 5, 4, 1][1, 2, 0;",
        " 0, 2, 1]1[2, 5]0",
        "[1.5, 1.5]71 2.5",
        "[  3,   3]2[2 x 2 from (3, 3)]44.5.4",
        "1 30 40 1203",
    ]
