"""After `warm()` nothing is compiled in the middle of a drive: a robot drives on while SLAM waits for a compiler."""

import subprocess
import sys

NEW = """
import sys
from coursekit.slam.precompile import warm
from tests.slam.test_slam import FULL, Drive

def forms():
    modules = [module for name, module in sys.modules.items() if name.startswith("coursekit.slam")]
    loops = {one for module in modules for one in vars(module).values() if hasattr(one, "py_func")}
    return {f"{one.py_func.__module__}.{one.py_func.__name__}": len(one.signatures) for one in loops}

warm()
before = forms()
drive = Drive(FULL, 360)
assert drive.slam.loops and len(before) > 15
print(*(name for name, count in forms().items() if count != before.get(name)))
"""


def test_a_drive_with_loops_compiles_nothing_new():
    """In a program of its own: here other tests have compiled all already."""
    done = subprocess.run([sys.executable, "-c", NEW], capture_output=True, encoding="utf-8", timeout=100)
    assert done.returncode == 0, done.stderr
    assert not done.stdout.split()
