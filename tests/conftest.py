"""Settings of all tests: a busy computer is no failure, and sessions of tests and of the user never meet."""

import importlib
import os
import tempfile

from hypothesis import settings

# Property tests have no time limit of their own, and try the same examples every time; with COURSEKIT_FUZZ, new ones.
settings.register_profile("coursekit", deadline=None, derandomize="COURSEKIT_FUZZ" not in os.environ)
settings.load_profile("coursekit")

_sessions = tempfile.TemporaryDirectory(prefix="ck-")  # short: a Unix socket's path has room for 107 bytes
os.environ["COURSEKIT_RUNTIME_DIR"] = _sessions.name
os.environ["ROS_LOG_DIR"] = os.path.join(_sessions.name, "log")  # not among the user's own

# Its first import sources ROS: not within a test that sets AMENT_PREFIX_PATH for a while, and takes it back.
importlib.import_module("ament_index_python")
