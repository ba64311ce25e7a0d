"""Examples in docstrings find what their readers have in a notebook.

Those of ROS packages have a `node`. Those of the lab are cells: `%ros2` runs in them, and they know the lab's names.
"""

import contextlib
import doctest
import os
from pathlib import Path

import pytest
from _pytest.doctest import DoctestItem

COURSEKIT = Path(__file__).parents[1] / "coursekit"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    """Run an example in the surroundings of its readers, on the virtual clock."""
    if not isinstance(item, DoctestItem):
        return (yield)
    with _surroundings(item):
        return (yield)


def _surroundings(item):
    if COURSEKIT / "ros" in item.path.parents and "node" in _source(item).lower():
        return _with_node(item)
    if COURSEKIT / "lab" in item.path.parents and any(line.startswith("%") for line in _source(item).splitlines()):
        return _as_cells(item)
    return contextlib.nullcontext()


def _source(item):
    return "".join(example.source for example in item.dtest.examples)


@contextlib.contextmanager
def _with_node(item):
    """A session with a node that needs no making."""
    import rclpy  # not before conftest.py has chosen the sessions' folder

    from coursekit.processes.session import Session

    with Session(virtual=True).use():
        rclpy.init()
        item.dtest.globs |= {"rclpy": rclpy, "node": rclpy.create_node("robot")}
        try:
            yield
        finally:
            rclpy.try_shutdown()


@contextlib.contextmanager
def _as_cells(item):
    """A session of a notebook in a workspace of its own: IPython reads the lines, which know the lab's names and magics."""
    from IPython.core.interactiveshell import InteractiveShell
    from traitlets.config import Config

    import coursekit.lab as lab
    from coursekit.lab.magics import CourseMagics
    from coursekit.lab.panel import end_panels
    from coursekit.processes.session import Session

    shell = InteractiveShell(config=Config(HistoryManager={"enabled": False}))
    shell.register_magics(CourseMagics)
    for example in item.dtest.examples:
        example.source = shell.input_transformer_manager.transform_cell(example.source)
        example.options[doctest.ELLIPSIS] = True  # "..." in what they show stands for anything
    names = {name: getattr(lab, name) for name in lab.__all__} | {"get_ipython": lambda: shell}
    item.dtest.globs.update(names | item.dtest.globs)
    with pytest.MonkeyPatch.context() as patch, Session(virtual=True).use():
        patch.setitem(os.environ, "COURSEKIT_WORKSPACE", str(item.config._tmp_path_factory.mktemp("course") / "ros2_ws"))
        try:
            yield
        finally:
            end_panels()
