"""Detect whether compiled C++ programs are available: the course can be taken without a compiler."""

from __future__ import annotations

from coursekit.processes.executables import PackageNotFound, executables_of


def compiled(package: str) -> bool:
    """Whether a package has executables; a C++ package has them only after it was built with a compiler.

    >>> compiled("demo_nodes_py"), compiled("geometry_msgs"), compiled("no_such_package")
    (True, False, False)
    """
    try:
        return bool(executables_of(package))
    except PackageNotFound:
        return False


__all__ = ["compiled"]
