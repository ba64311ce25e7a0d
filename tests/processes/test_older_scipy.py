"""The names of SciPy 1.8, which robots with Humble have, where a newer SciPy lacks them."""

import subprocess
import sys

import pytest

pytest.importorskip("scipy")

OF_HUMBLE = """
from coursekit.processes.session import Session
with Session(virtual=True).use():
    import scipy, scipy.linalg, scipy.sparse
    from scipy import array, pi
    from scipy.integrate import cumtrapz, simps, trapz
    from scipy.signal import gaussian, hann
    print(trapz([0, 1, 2]), simps([0, 1, 4], [0, 1, 2]).round(3), cumtrapz([0, 2, 4], initial=0).tolist())
    print(hann(3).tolist(), len(gaussian(5, std=1)), array([pi]).round(2).tolist(), scipy.cos(0.0))
    print(scipy.linalg.pinv2([[2.0]]).tolist(), scipy.linalg.triu([[1, 2], [3, 4]]).tolist())
    print(scipy.sparse.csr_matrix([[3]]).A)
print(hasattr(scipy, "pi"), hasattr(scipy.signal, "hann"), hasattr(scipy.sparse.csr_matrix, "A"))
"""


def run(lines):
    done = subprocess.run([sys.executable, "-W", "error", "-c", lines], capture_output=True, encoding="utf-8")
    assert done.stderr == ""
    return done.stdout.splitlines()


def test_programs_find_humbles_names_for_as_long_as_a_session():
    assert run(OF_HUMBLE) == [
        "2.0 2.667 [0.0, 1.0, 4.0]",
        "[0.0, 1.0, 0.0] 5 [3.14] 1.0",
        "[[0.5]] [[1, 2], [0, 4]]",
        "[[3]]",
        "False False False",
    ]


def test_what_was_imported_before_the_session_has_them_too():
    first = "import scipy.signal\n" + OF_HUMBLE.split("    from scipy import array")[0]
    assert run(first + "    print(scipy.signal.boxcar(2).tolist(), scipy.zeros(1).tolist())\n") == ["[1.0, 1.0] [0.0]"]


@pytest.mark.parametrize("order", [("scipy.signal", "rclpy"), ("rclpy", "scipy.signal")])
def test_a_plain_script_finds_them_above_its_first_node(order):
    lines = "\n".join(f"import {name}" for name in order)
    assert run(f"{lines}\nprint(scipy.signal.hann(3).tolist(), scipy.e.__round__(2))") == ["[0.0, 1.0, 0.0] 2.72"]


def test_what_scipy_never_had_is_absent_in_its_words():
    lines = "import rclpy, scipy\nprint(hasattr(scipy, 'nothing_of_the_kind'), hasattr(scipy, '_core'))\nscipy.nothing"
    done = subprocess.run([sys.executable, "-c", lines], capture_output=True, encoding="utf-8")
    assert done.stdout.split() == ["False", "False"] and "has no attribute 'nothing'" in done.stderr


def test_submodules_are_scipys_own():
    assert run("import rclpy, scipy\nprint(scipy.fft.__name__, scipy.linalg.__name__)") == ["scipy.fft scipy.linalg"]


def test_roots_and_logarithms_of_negative_numbers_are_complex():
    assert run("import rclpy, scipy\nprint(scipy.sqrt(-1), scipy.log(-1).imag.round(2))") == ["1j 3.14"]
