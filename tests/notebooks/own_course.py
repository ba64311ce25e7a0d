"""A pytest plugin for `--nbval`: the chapters run in a course folder of their own, not in the checkout.

Its name has spaces, an accent, a comma and brackets, as folders of students have.
"""

import asyncio
import contextlib
import os
import tempfile
from pathlib import Path

from nbval.plugin import IPyNbFile

from coursekit.cpp.toolchain import NoToolchain, find_toolchain
from coursekit.packages.prepare_cpp import prepared_toolchain
from tests import compiler_cache
from tests.needs import ON_WINDOWS

from .alike import compare_alike
from .running import clock_of, name_student, read

compiler_cache.use()
_folder = tempfile.TemporaryDirectory(prefix="ROS course, día (1) ")


def pytest_configure(config):
    course = Path(_folder.name).resolve()
    (course / "ros2_ws" / "src").mkdir(parents=True, exist_ok=True)
    name_student(course)
    compare_alike(ON_WINDOWS)
    os.environ |= {"COURSEKIT_COURSE": str(course), "COURSEKIT_WORKSPACE": str(course / "ros2_ws")}
    os.environ |= {"COLUMNS": "120", "TZ": "UTC"}
    os.environ["COURSEKIT_RUNTIME_DIR"] = str(course)  # no terminal of the user's reaches these sessions
    if compiles():
        asyncio.run(prepared_toolchain())  # now, or a chapter's first build would say how long it took


def pytest_collectstart(collector):
    """A chapter's kernel starts when its cells are about to run, on the clock that the chapter asks for."""
    if isinstance(collector, IPyNbFile):
        begin, clock = collector.setup, clock_of(read(collector.path))

        def setup():
            with use_clock(clock):
                begin()

        collector.setup = setup


@contextlib.contextmanager
def use_clock(clock):
    """Have kernels that start here run on this clock, where the chapters are not to run on the wall clock anyway."""
    before = os.environ.get("COURSEKIT_TIME")
    if before:
        os.environ["COURSEKIT_TIME"] = clock
    yield
    if before:
        os.environ["COURSEKIT_TIME"] = before


def compiles():
    """Whether C++ is compiled here."""
    try:
        find_toolchain()
    except NoToolchain:
        return False
    return not ON_WINDOWS


def pytest_collection_modifyitems(items):
    """Without a compiler the cells of C++ print something else, and what comes behind them happens at other times."""
    after = set()
    for item in items if not compiles() else ():
        if "cpp" in getattr(item, "cell", {}).get("metadata", {}).get("tags", []):
            after.add(item.parent)
        if item.parent in after:
            item.options["check"] = False
