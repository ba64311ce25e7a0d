"""Settings of all tests: a busy computer is no failure, and sessions of tests and of the user never meet."""

import gc
import importlib
import os
import subprocess
import sys
import tempfile

import pytest
from hypothesis import settings

from tests import compiler_cache

# Property tests have no time limit of their own, and try the same examples every time; with COURSEKIT_FUZZ, new ones.
settings.register_profile("coursekit", deadline=None, derandomize="COURSEKIT_FUZZ" not in os.environ)
settings.load_profile("coursekit")

_sessions = tempfile.TemporaryDirectory(prefix="ck-")  # short: a Unix socket's path has room for 107 bytes
os.environ["COURSEKIT_RUNTIME_DIR"] = _sessions.name
os.environ["ROS_LOG_DIR"] = os.path.join(_sessions.name, "log")  # not among the user's own
os.environ.pop("ROS_DOMAIN_ID", None)  # the tests meet in domain 0, whatever the user has chosen

compiler_cache.use()

# Its first import sources ROS: not within a test that sets AMENT_PREFIX_PATH for a while, and takes it back.
importlib.import_module("ament_index_python")


def pytest_configure(config):
    """Each pytest that a test starts does without plugins that import for seconds what it never uses."""
    if hasattr(config, "workerinput") or not getattr(config.option, "numprocesses", None):  # but not those of xdist
        os.environ["PYTEST_ADDOPTS"] = "-p no:nbval -p no:hypothesispytest"


def pytest_sessionstart(session):
    """What all tests of C++ need is made before they begin, so that it takes none of them its time."""
    if getattr(session.config.option, "numprocesses", None) and not hasattr(session.config, "workerinput"):
        make_cpp_runtime()


LONG = (
    "tests/notebooks/test_taking", "tests/notebooks/",
    "tests/grade/test_class", "tests/browser/", "tests/grade/", "tests/packages/", "tests/tutorials/",
)  # fmt: skip
"""Files that take minutes with few tests, the longest first: begun last, one would keep a worker when all is done."""


def pytest_collection_modifyitems(items):
    """Begin with what takes long; `--no-loadscope-reorder` keeps to that."""
    items.sort(key=lambda item: next((at for at, start in enumerate(LONG) if item.nodeid.startswith(start)), len(LONG)))


def pytest_collection_finish(session):
    """Keep Python's garbage collection from going through all tests each time: they stay until the end."""
    gc.collect()
    gc.freeze()


ALONE = ("tests/notebooks/test_taking",)
"""Files whose tests share nothing, and take minutes each: workers take them one by one, tests of other files together."""


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Instead of `--dist loadfile`."""
    from xdist.scheduler import LoadFileScheduling

    class Scheduling(LoadFileScheduling):
        def _split_scope(self, nodeid):
            return nodeid if nodeid.startswith(ALONE) else super()._split_scope(nodeid)

    return Scheduling(config, log) if config.getvalue("dist") == "loadfile" else None


def make_cpp_runtime():
    """Compile the runtime of C++ programs, where there are tools for it and it is not there."""
    from coursekit.cpp.runtime import runtime_folder  # not before the settings above
    from coursekit.cpp.toolchain import NoToolchain, find_toolchain

    try:
        folder = runtime_folder(find_toolchain())
    except NoToolchain:
        return
    if not folder.is_dir():
        env = {name: value for name, value in os.environ.items() if name != "AMENT_PREFIX_PATH"}
        command = [sys.executable, "-m", "coursekit.cpp.runtime", str(folder)]
        done = subprocess.run(command, env=env, capture_output=True, encoding="utf-8")
        if done.returncode:
            print(done.stdout[-3000:], done.stderr[-3000:], sep="\n", file=sys.stderr)
