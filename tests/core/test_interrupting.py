"""An exception that is raised into a running thread breaks nothing that other threads need."""

import subprocess
import sys

PROGRAM = """
import _imp, importlib, threading
from coursekit.core.interrupting import raise_in_thread

class Stop(BaseException):
    pass

def work(begun):
    try:
        begun.set()
        while True:
            %s
    except Stop:
        pass

for _ in range(30):
    begun = threading.Event()
    thread = threading.Thread(target=work, args=[begun])
    thread.start()
    begun.wait()
    while not raise_in_thread(thread.ident, Stop):
        pass
    thread.join()
    assert not _imp.lock_held()
import colorsys
print("imports go on")
"""
LOCKS, IMPORTS = "importlib._bootstrap._get_module_lock('x')", "importlib._bootstrap._find_spec('sys', None)"


def outcome(loop):
    return subprocess.run([sys.executable, "-c", PROGRAM % loop], capture_output=True, text=True, timeout=60, check=False)


def test_the_import_lock_is_free_after_an_import_was_interrupted():
    for loop in (f"{IMPORTS}; sum(range(50))", f"{LOCKS}; sum(range(50))"):
        done = outcome(loop)
        assert done.stdout == "imports go on\n", done.stderr
