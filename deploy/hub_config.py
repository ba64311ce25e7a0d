"""What a JupyterHub has to know to give each student the course. Any hub can load it: docs/hub.md says how.

Each student has a home, and in it a copy of the course, a session and a memory limit of their own. Nothing here opens a
port: students reach their servers through the hub's proxy.
"""

import os
import shutil
import sys

c = get_config()  # noqa: F821  JupyterHub gives it

SHARED = os.environ.get("COURSEKIT_SHARED", "/srv/coursekit")
"""What `coursekit hub-prepare` has filled."""
EXCHANGE = os.environ.get("COURSEKIT_EXCHANGE", "")
"""A course of nbgrader's exchange, such as /srv/nbgrader/exchange/ros2: for `hand_in()` and releases."""
PLACES = os.pathsep.join([os.path.dirname(sys.executable), "/opt/tljh/user/bin", os.environ.get("PATH", "")])

c.Spawner.cmd = [shutil.which("coursekit", path=PLACES) or "coursekit", "hub-lab", "--"]
c.Spawner.environment = {"COURSEKIT_SHARED": SHARED, **({"COURSEKIT_EXCHANGE": EXCHANGE} if EXCHANGE else {})}
c.Spawner.mem_limit = os.environ.get("COURSEKIT_MEMORY", "1500M")  # held to by systemd, containers and Kubernetes
c.Spawner.start_timeout = 180  # the first start copies the course
c.Spawner.http_timeout = 120
