"""Names of NumPy 1.21, which a robot with Humble has, for programs that meet a newer NumPy here.

NumPy has dropped them since: `np.float` and its like with 1.24, `np.Inf` and others with 2.0, `np.trapz` with 2.4. NumPy
asks its `__getattr__` for names that it lacks only, so what a version still has is its own.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

from .patching import IMPORTS, Patch, patch_manager

_SAME = {
    "Inf": "inf", "Infinity": "inf", "infty": "inf", "PINF": "inf", "NaN": "nan",
    "float_": "float64", "longfloat": "longdouble", "complex_": "complex128", "cfloat": "complex128",
    "singlecomplex": "complex64", "string_": "bytes_", "unicode_": "str_", "bool8": "bool_", "int0": "intp",
    "uint0": "uintp",
    "mat": "asmatrix", "product": "prod", "cumproduct": "cumprod", "alltrue": "all", "sometrue": "any", "round_": "round",
    "trapz": "trapezoid", "row_stack": "vstack",
}  # fmt: skip
"""Older name, and the name that NumPy has for the same thing."""


def _numpy(name: str) -> Any:
    import numpy

    return getattr(numpy, name)


def _in1d(ar1: Any, ar2: Any, *options: Any, **named: Any) -> Any:
    """Say of each element of `ar1`, in one row, whether it is in `ar2`."""
    return _numpy("isin")(_numpy("ravel")(ar1), ar2, *options, **named)


def _asfarray(a: Any, dtype: Any = float) -> Any:
    """Return `a` as an array of floats."""
    return _numpy("asarray")(a, dtype=dtype)


NAMES: dict[str, Callable[[], Any]] = {
    **{older: partial(_numpy, name) for older, name in _SAME.items()},
    **{kind.__name__: partial(lambda kind: kind, kind) for kind in (int, float, complex, object, str)},
    "NINF": lambda: -math.inf,
    "math": lambda: math,
    "in1d": lambda: _in1d,
    "asfarray": lambda: _asfarray,
    "asscalar": lambda: lambda a: a.item(),
    "msort": lambda: lambda a: _numpy("sort")(a, axis=0),
}
"""Older name, and what returns its value."""


def _also_older(real: Callable[[str], Any]) -> Callable[[str], Any]:
    """Return NumPy's `__getattr__` with the older names."""
    return lambda name: NAMES[name]() if name in NAMES else real(name)


_TEST = "tests/processes/test_older_numpy.py"
_PATCH = Patch("numpy.__getattr__", _also_older, "programs for Humble's NumPy 1.21 find its names", _TEST, IMPORTS)


def install() -> None:
    """Give NumPy the names that it lacks."""
    patch_manager.lend(_PATCH, at_once=True)


def patches() -> list[Patch]:
    """Return the patch."""
    return [_PATCH]
