"""Names of SciPy 1.8, which a robot with Humble has, for programs that meet a newer SciPy here.

SciPy has moved its windows to `scipy.signal.windows`, spells out the names of its integrals, and is no longer a second
place for NumPy's functions.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

import numpy as np

from .import_hooks import is_loaded
from .older_names import Name, adding
from .patching import IMPORTS, Change, Patch, patch_manager

_WINDOWS = (
    "barthann", "bartlett", "blackman", "blackmanharris", "bohman", "boxcar", "chebwin", "cosine", "exponential", "flattop",
    "gaussian", "general_gaussian", "hamming", "hann", "kaiser", "nuttall", "parzen", "triang", "tukey",
)  # fmt: skip
_OF_COMPLEX_NUMBERS = ("sqrt", "log", "log2", "log10", "logn", "power", "arccos", "arcsin", "arctanh")
"""Functions whose results are complex outside of their real range: `scipy.sqrt(-1)` is 1j."""
_OF_NUMPY = ("kron", "tri", "triu", "tril")


def _integrals(module: Any) -> Iterator[Name]:
    yield module, "trapz", module.trapezoid
    yield module, "cumtrapz", module.cumulative_trapezoid
    yield module, "simps", lambda y, x=None, dx=1.0, axis=-1, even="avg": module.simpson(y, x=x, dx=dx, axis=axis)


def _windows(module: Any) -> Iterator[Name]:
    return ((module, name, getattr(module.windows, name)) for name in _WINDOWS)


def _matrices(module: Any) -> Iterator[Name]:
    yield module, "pinv2", lambda a, cond=None, rcond=None, **named: module.pinv(a, rtol=cond or rcond, **named)
    yield from ((module, name, getattr(np, name)) for name in _OF_NUMPY)


def _sparse(module: Any) -> Iterator[Name]:
    yield module.spmatrix, "A", property(lambda self: self.toarray())


_MODULES: dict[str, Callable[[Any], Iterator[Name]]] = {
    "scipy.integrate": _integrals, "scipy.linalg": _matrices, "scipy.signal": _windows, "scipy.sparse": _sparse,
}  # fmt: skip
"""Modules, and what each gets when it is imported."""


def _also_numpy(real: Callable[[str], Any]) -> Callable[[str], Any]:
    """Return SciPy's `__getattr__`, which knows what NumPy has, too: `scipy.pi`, `from scipy import array`."""

    def find(name: str) -> Any:
        if name in _OF_COMPLEX_NUMBERS:
            return getattr(np.lib.scimath, name)
        if name in ("rand", "randn"):
            return getattr(np.random, name)
        found = None if name.startswith("_") else getattr(np, name, None)
        return real(name) if found is None or isinstance(found, ModuleType) else found

    return find


_TEST, _REASON = "tests/processes/test_older_scipy.py", "programs for Humble's SciPy 1.8 find its names"


def _change(module: str, names: Callable[[Any], Iterator[Name]]) -> Change:
    return Change(f"{module} (older names)", adding(lambda: names(sys.modules[module])), _REASON, _TEST, IMPORTS)


_CHANGES: dict[str, Patch] = {
    "scipy": Patch("scipy.__getattr__", _also_numpy, _REASON, _TEST, IMPORTS),
    **{module: _change(module, names) for module, names in _MODULES.items()},
}


def install() -> None:
    """Give SciPy's loaded modules the names that they lack."""
    patch_manager.lend(*(change for module, change in _CHANGES.items() if is_loaded(module)), at_once=True)


def patches() -> list[Patch]:
    """Return the patches."""
    return list(_CHANGES.values())
