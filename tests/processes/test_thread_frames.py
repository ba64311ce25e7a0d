"""While Python lists the threads' frames no garbage is collected: a finalizer could make every thread stand still."""

from __future__ import annotations

import gc
import subprocess
import sys

import pytest

from coursekit.processes.thread_frames import thread_frames

STANDS_STILL = """
import gc, sys, threading, time
from coursekit.processes.thread_frames import thread_frames

class Slow:
    def __init__(self):
        self.me = self

    def __del__(self):
        time.sleep(0)  # another thread may run

def start_threads():  # a new thread needs the lock that Python holds
    while True:
        thread = threading.Thread(target=int)
        thread.start()
        thread.join()

threading.Thread(target=start_threads, daemon=True).start()
gc.set_threshold(1, 1, 1)
for _ in range(2000):
    Slow()
    thread_frames()
print("done")
"""


@pytest.mark.parametrize("collects", [True, False])
def test_garbage_is_collected_before_and_after_but_not_meanwhile(monkeypatch, collects):
    seen = []
    monkeypatch.setattr(sys, "_current_frames", lambda: seen.append(gc.isenabled()) or {})
    was = gc.isenabled()
    (gc.enable if collects else gc.disable)()
    try:
        assert thread_frames() == {} and seen == [False] and gc.isenabled() is collects
    finally:
        (gc.enable if was else gc.disable)()


def test_threads_that_begin_and_finalizers_do_not_stop_each_other():
    done = subprocess.run([sys.executable, "-c", STANDS_STILL], capture_output=True, text=True, timeout=60, check=False)
    assert done.stdout == "done\n", done.stderr
