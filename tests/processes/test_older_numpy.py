"""The names of NumPy 1.21, which robots with Humble have, where a newer NumPy lacks them."""

import math
import subprocess
import sys

import numpy as np
import pytest

from coursekit.processes import older_numpy
from coursekit.processes.session import Session


@pytest.fixture
def session():
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session


@pytest.mark.usefixtures("session")
def test_numbers_and_types_have_their_older_names():
    assert np.Inf == np.infty == np.PINF == -np.NINF == math.inf and math.isnan(np.NaN)
    assert (np.float, np.int, np.complex, np.object, np.str) == (float, int, complex, object, str)
    assert np.float_ is np.float64 and np.unicode_ is np.str_ and np.math is math
    assert np.zeros(2, dtype=np.int).dtype == np.int_


@pytest.mark.usefixtures("session")
def test_functions_have_their_older_names():
    assert np.product([2, 3]) == 6 and np.cumproduct([2, 3]).tolist() == [2, 6]
    assert np.alltrue([1, 1]) and np.sometrue([0, 1]) and np.round_(1.26, 1) == 1.3
    assert np.trapz([1.0, 2.0]) == 1.5 and np.asscalar(np.array([3])) == 3
    assert np.in1d([[1, 2], [3, 4]], [2, 3]).tolist() == [False, True, True, False]
    assert np.msort([[2, 1], [0, 3]]).tolist() == [[0, 1], [2, 3]] and np.asfarray([1]).dtype == np.float64


@pytest.mark.usefixtures("session")
def test_names_can_be_imported_by_themselves():
    from numpy import infty

    assert infty == math.inf


@pytest.mark.usefixtures("session")
def test_what_numpy_never_had_is_still_absent_in_its_words():
    with pytest.raises(AttributeError, match="module 'numpy' has no attribute 'nothing_of_the_kind'"):
        _ = np.nothing_of_the_kind


def test_what_numpy_has_itself_is_left_alone(monkeypatch, session):
    monkeypatch.setattr(older_numpy, "NAMES", {**older_numpy.NAMES, "inf": lambda: 3})
    assert np.inf == math.inf


FIRST = """
from coursekit.processes.session import Session
with Session(virtual=True).use():
    import numpy
    print(numpy.NINF)
print(hasattr(numpy, "NINF"))
"""


@pytest.mark.skipif(np.lib.NumpyVersion(np.__version__) < "2.0.0", reason="this NumPy has the name itself")
def test_the_names_are_there_for_as_long_as_a_session():
    done = subprocess.run([sys.executable, "-c", FIRST], capture_output=True, encoding="utf-8")
    assert done.stdout.split() == ["-inf", "False"], done.stderr


@pytest.mark.filterwarnings("ignore:Conversion of an array:DeprecationWarning")
def test_an_array_of_one_element_is_a_number_for_float_and_math():
    """As on a robot: filters and controllers of programs take `x[2]` of a column for a number."""
    column = np.array([[0.0], [1.5]])
    assert float(column[1]) == 1.5 and math.cos(column[0]) == 1.0


PLAIN = """
import numpy
import rclpy
from numpy import NINF
print(numpy.NINF)
rclpy.init()
rclpy.create_node("n").destroy_node()
rclpy.shutdown()
print(numpy.NINF)
"""


@pytest.mark.parametrize("order", [("numpy", "rclpy"), ("rclpy", "numpy")])
def test_a_plain_script_finds_them_above_its_first_node(order):
    lines = PLAIN.replace("import numpy\nimport rclpy", "\n".join(f"import {name}" for name in order))
    done = subprocess.run([sys.executable, "-c", lines], capture_output=True, encoding="utf-8")
    assert done.stdout.split() == ["-inf", "-inf"], done.stderr
