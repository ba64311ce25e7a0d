"""A command in a session of its own, as `coursekit network robot` has one."""

import subprocess
import sys

from tests.needs import posix

INTERRUPTED = """
import signal, threading
from coursekit.cli.own_session import run_in
from coursekit.core.execution_context import thread_context
from coursekit.processes.session import Session

session, main = Session(), thread_context()

def listens():
    return any(graph.nodes for graph in list(session.graphs.values()))

def interrupt():
    while main.blocked_on is None or not listens():
        session.clock.sleep(0.01)
    signal.pthread_kill(threading.get_ident(), signal.SIGINT)

threading.Thread(target=interrupt).start()
run_in(session, ["topic", "echo", "/nobody", "std_msgs/msg/String"])
print("ended")
"""


@posix("there a thread cannot be sent a signal")
def test_ctrl_c_ends_it_also_when_another_thread_receives_the_signal():
    """The main thread blocks on a lock, and would not notice."""
    command = [sys.executable, "-c", INTERRUPTED]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60, check=False)
    assert done.stdout.endswith("ended\n"), done.stdout + done.stderr
