"""What sessions replace of Python is in one table, and is put back after the last session."""

import subprocess
import sys
from pathlib import Path

import pytest

from coursekit.processes.patching import Patch, always

ROOT = Path(__file__).parents[2]

FINGERPRINT = """
import builtins, contextlib, importlib, os, pkgutil, sys, types, queue, selectors, asyncio, signal, threading, time
import cv2, matplotlib.pyplot, matplotlib.backend_bases

MODULES = (
    "asyncio asyncio.events asyncio.base_events atexit builtins concurrent.futures.thread contextlib cv2 fcntl getpass "
    "importlib importlib.metadata io linecache logging matplotlib.pyplot matplotlib.backend_bases os os.path pty queue "
    "random select selectors signal socket subprocess sys tempfile termios threading time tty types uuid warnings"
).split()
CLASSES = (
    "threading.Thread threading.Condition threading.Event threading.Semaphore selectors.DefaultSelector "
    "matplotlib.backend_bases.FigureCanvasBase matplotlib._pylab_helpers.Gcf queue.Queue logging.Logger"
).split()
VOLATILE = {
    "last_exc", "last_type", "last_value", "last_traceback", "__warningregistry__", "path_importer_cache", "__builtins__"
}


def fingerprint():
    'Which object stands at every name of what could be replaced.'
    asyncio.get_event_loop_policy()  # made when it is asked for
    there = []
    for name in MODULES:
        with contextlib.suppress(ImportError):  # Windows has some, other systems others
            importlib.import_module(name)
            there.append(name)
    places = {name: pkgutil.resolve_name(name) for name in [*there, *CLASSES]}
    seen = {
        f"{place}.{name}": value
        for place, owner in places.items()
        for name, value in dict(vars(owner)).items()
        if name not in VOLATILE
    }
    seen |= {"meta_path": list(sys.meta_path), "path": list(sys.path), "argv": sys.argv, "class of sys": type(sys),
             "path_hooks": list(sys.path_hooks), "switch": sys.getswitchinterval(),
             "environment": dict(os.environ), "handlers": [signal.getsignal(number) for number in signal.valid_signals()]}
    return seen


def compare(before, after):
    def differs(name):
        one, other = before.get(name), after.get(name)
        if name in ("meta_path", "path_hooks", "path", "environment", "handlers", "switch"):
            return one != other
        return one is not other
    return sorted(name for name in before.keys() | after.keys() if differs(name))
"""

PROGRAMS = """
def program():
    import asyncio, atexit, threading, time
    atexit.register(print, "leaving")
    time.sleep(0.1)
    thread = threading.Thread(target=print, args=("thread",))
    thread.start(); thread.join()
    asyncio.run(asyncio.sleep(0.1))
    use_private_modules(current_process(), ["/nowhere/at/all"])
    time.monotonic()
"""


def in_fresh_interpreter(code):
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", cwd=ROOT)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("virtual", [True, False])
def test_after_the_last_session_every_name_is_as_it_was_found(virtual):
    said = in_fresh_interpreter(f"""{FINGERPRINT}
before = fingerprint()
from coursekit.processes.private_modules import use_private_modules
from coursekit.processes.process import current_process
from coursekit.processes.session import Session
{PROGRAMS}
after_import = compare(before, fingerprint())
with Session(virtual={virtual}).use() as session:
    process = session.start(program, name="p")
    assert process.wait(30) == 0, process.output
    during = compare(before, fingerprint())
print(len(during) > 20, after_import, compare(before, fingerprint()))
""")
    assert said == "True [] []\n"


def test_making_a_session_replaces_nothing():
    said = in_fresh_interpreter(f"""{FINGERPRINT}
from coursekit.processes.session import Session
before = fingerprint()
sessions = [Session(virtual=True), Session()]
print(compare(before, fingerprint()))
""")
    assert said == "[]\n"


def test_only_what_the_table_says_is_replaced():
    """Whatever differs while a program runs has a row, also what is not looked for by name."""
    said = in_fresh_interpreter(f"""{FINGERPRINT}
before = fingerprint()
from coursekit.processes.private_modules import use_private_modules
from coursekit.processes.process import current_process
from coursekit.processes.patching import HELD, patch_manager
from coursekit.processes.session import Session
{PROGRAMS}
with Session(virtual=True).use() as session:
    assert session.start(program, name="p").wait(30) == 0
    rows = {{row.target for row in patch_manager.table()}} | {{f"sys.{{HELD}}"}}
    print([name for name in compare(before, fingerprint()) if not names(name) & rows])
""".replace("from coursekit.processes.patching", NAMES + "from coursekit.processes.patching"))
    assert said == "[]\n"


NAMES = """
def names(place):
    'What a row may call the place: a class is known by the name of the module that has it, or by its own.'
    alias = {"meta_path": "sys.meta_path (first)", "path": "sys.path", "argv": "sys.argv", "switch": "sys.setswitchinterval",
             "class of sys": "sys.argv", "sys._real_argv": "sys.argv", "handlers": "signal.signal",
             "environment": "os.environ", "sys.meta_path": "sys.meta_path (first)"}
    owner, _, name = place.rpartition(".")
    found = {place, alias.get(place)}
    with contextlib.suppress(Exception):
        kind = pkgutil.resolve_name(owner)
        found.add(f"{kind.__module__}.{kind.__qualname__}.{name}")
    return found

"""


def test_what_others_put_in_its_place_stays(monkeypatch):
    import string

    monkeypatch.setattr(string, "digits", "0123")
    patch = Patch("string.digits", always("9"), "an example", __file__)
    patch.put()
    string.digits = "mine"
    patch.take_back()
    assert string.digits == "mine"


def test_patches_stay_until_the_last_session_closes():
    said = in_fresh_interpreter("""
import threading
from coursekit.processes.session import Session
real, seen = threading.Lock, []
look = lambda: seen.append(threading.Lock is real)
with Session(virtual=True).use():
    with Session(virtual=True).use():
        look()
    look()
    with Session().use():
        look()
look()
with Session().use():
    look()
print(seen)
""")
    assert said == "[False, False, False, True, True]\n"


def test_a_stream_that_was_put_aside_by_others_comes_back_bare():
    """Who redirects stdout in a session and puts it back after the session's end puts back a proxy: it still writes."""
    said = in_fresh_interpreter("""
import contextlib, io, sys
from coursekit.processes.session import Session
real, aside = sys.stdout, contextlib.redirect_stdout(io.StringIO())
use = Session().use()
use.__enter__()
aside.__enter__()
use.__exit__(None, None, None)
aside.__exit__(None, None, None)
print("is heard")
with Session().use():
    pass
print(sys.stdout is real)
""")
    assert said == "is heard\nTrue\n"


@pytest.mark.parametrize("ended", [True, False])
def test_handlers_of_rclpy_go_with_its_shutdown_or_with_the_session(ended):
    said = in_fresh_interpreter(f"""
import signal
import rclpy
from coursekit.processes.session import Session
handlers = lambda: [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]
before = handlers()
for _ in range(2):
    with Session(virtual=True).use():
        context = None if {ended} else rclpy.Context()
        rclpy.init(context=context)
        rclpy.signals.install_signal_handlers()
        assert handlers() != before
        if {ended}:
            rclpy.shutdown()
            assert handlers() == before
    print(handlers() == before)
""")
    assert said == "True\nTrue\n"


def test_a_plain_script_is_told_where_packages_are():
    said = in_fresh_interpreter("""
import rclpy
try:
    import moveit_configs_utils
except ModuleNotFoundError as error:
    print(error)
""")
    assert said.startswith("No module named 'moveit_configs_utils': ") and "; " in said


def test_locks_and_threads_of_an_ended_program_go_on_without_its_session():
    said = in_fresh_interpreter("""
import queue, threading, time
from coursekit.processes.session import Session
kept = []
def program():
    def work():
        time.sleep(1.0)
    thread = threading.Thread(target=work)
    thread.start(); thread.join()
    kept.extend([threading.Lock(), threading.RLock(), threading.Condition(), queue.Queue(), queue.SimpleQueue(), thread])
with Session(virtual=True).use() as session:
    assert session.start(program, name="p").wait(30) == 0
lock, rlock, condition, fifo, simple, thread = kept
with lock, rlock, rlock, condition:
    assert not lock.acquire(False) and not condition.wait(0.01)
other = threading.Thread(target=fifo.put, args=(1,))
other.start(); other.join()
simple.put(2)
print(fifo.get(), simple.get(), thread.is_alive(), thread.join())
""")
    assert said == "1 2 False None\n"


def test_a_program_that_cannot_be_ended_does_not_print_as_the_interpreter():
    said = in_fresh_interpreter("""
import threading
from coursekit.processes.session import Session
go, printed = threading.Event(), threading.Event()
def stubborn():
    while True:
        try:
            while not go.is_set():
                pass
            print("still here")
            printed.set()
            return
        except BaseException:
            pass
with Session().use() as session:
    process = session.start(stubborn, name="p")
    session.clock.sleep(0.1)
    process.kill()
    process.wait(60)
    assert process.abandoned
go.set()
printed.wait(10)
""")
    assert said == ""
