"""The table of all replacements in Python and its libraries, each with its reason and its test.

Patches of libraries are added when the library is imported (`coursekit.view.highgui`, `coursekit.view.plots`). The
document docs/patches.md is generated from this table: `python -m tests.processes.patch_table`.
"""

from __future__ import annotations

from . import (
    atexit_hooks,
    clocks,
    console_keys,
    import_hooks,
    keyboard,
    locks,
    private_modules,
    selecting,
    streams,
    threads,
)
from .patching import IMPORTS, PRIVATE, VIRTUAL, Change, Patch, always, patch_manager
from .pickling import with_own_modules

_HERE = "tests/processes/test_"
_STREAMS, _THREADS, _PROCESS = f"{_HERE}streams.py", f"{_HERE}threads.py", f"{_HERE}process.py"
_KEYBOARD, _SESSION, _ATEXIT = f"{_HERE}keyboard.py", f"{_HERE}session.py", f"{_HERE}atexit_hooks.py"
_MODULES, _SELECTING, _IMPORTS = f"{_HERE}private_modules.py", f"{_HERE}selecting.py", f"{_HERE}import_hooks.py"
_OWN_CLOCK = "on the virtual clock a program reads the session's time"
_ASYNCIO = "asyncio waits by the session's clock"
_LOCK = "a program that waits for a lock lets the others run"
_KEYS = "a program that wants single keys gets those that are typed to its process"

TABLE: tuple[Patch, ...] = (
    Change("sys.meta_path (first)", import_hooks.watch_imports, "OpenCV and pyplot are patched when a program imports them",
           _IMPORTS, IMPORTS),
    Change("sys.meta_path (last)", import_hooks.tell_elsewhere, "a ROS package that is not here is told with the reason",
           f"{_HERE}unavailable_packages.py", IMPORTS),
    Change("sys.setswitchinterval", threads.switch_often, "with Python's 5 ms hand-offs between threads are slow",
           f"{_HERE}patches.py", IMPORTS),
    Patch("sys.stdout", streams.proxy_of("stdout"), "each process has its own output", _STREAMS, bare=streams.bare),
    Patch("sys.stderr", streams.proxy_of("stderr"), "each process has its own output", _STREAMS, bare=streams.bare),
    Patch("sys.stdin", streams.proxy_of("stdin"), "each process has its own input", _STREAMS, bare=streams.bare),
    Change("sys.argv", streams.own_arguments, "each process has its own arguments", _SESSION),
    Patch("os.environ", streams.Environ, "each process has its own environment", _SESSION, bare=streams.bare),
    Patch("time.sleep", always(streams.sleep), "a process sleeps on the session's clock; Ctrl-C ends it", _SESSION),
    Patch("signal.signal", always(streams.set_handler), "a process handles its own signals", _PROCESS),
    Patch("signal.getsignal", always(streams.handler_of), "a process handles its own signals", _PROCESS),
    Patch("builtins.input", streams.input_of, "a process reads what is typed to it", _STREAMS),
    Patch("select.select", always(keyboard.select_), _KEYS, _KEYBOARD),
    Patch("fcntl.fcntl", always(keyboard.fcntl_), _KEYS, _KEYBOARD),
    *(Patch(f"{module}.{name}", always(function), _KEYS, _KEYBOARD)
      for module in ("termios", "tty")
      for name, function in (("tcgetattr", keyboard.tcgetattr), ("tcsetattr", keyboard.tcsetattr))),
    *(Patch(f"msvcrt.{function.__name__}", always(function), f"{_KEYS}, on Windows", f"{_HERE}console_keys.py",
            only_on="win32")
      for function in console_keys.FUNCTIONS),
    Patch("atexit.register", always(atexit_hooks.register), "what a program registers runs when it ends", _ATEXIT),
    Patch("atexit.unregister", always(atexit_hooks.unregister), "what a program registers runs when it ends", _ATEXIT),
    Patch("selectors.DefaultSelector.select", selecting.patient, _ASYNCIO, _SELECTING),
    Patch("asyncio.windows_events.IocpProactor.select", selecting.patient, f"{_ASYNCIO}, on Windows", _SELECTING,
          only_on="win32"),
    Patch("threading.Thread.start", always(threads.start), "a thread belongs to the process that starts it", _THREADS),
    Patch("threading.Thread.join", always(threads.join), "Ctrl-C ends the wait for a thread", _THREADS),
    Patch("threading.Thread.is_alive", always(threads.is_alive), "a greenlet is a thread to its program", _THREADS),
    Patch("threading.Condition.wait", always(locks.condition_wait), "events, queues and futures use the session's clock",
          _THREADS),
    Patch("threading.current_thread", always(threads.current_thread), "a greenlet is a thread to its program", _THREADS,
          VIRTUAL),
    Patch("threading.Lock", always(locks.VirtualLock), _LOCK, _THREADS, VIRTUAL),
    Patch("threading.RLock", always(locks.VirtualRLock), _LOCK, _THREADS, VIRTUAL),
    Patch("queue.SimpleQueue", always(locks.PythonQueue), "the one written in C blocks all greenlets", _THREADS, VIRTUAL),
    *(Patch(f"time.{name}", clocks.clock_reader(name), _OWN_CLOCK, _THREADS, VIRTUAL) for name in clocks.CLOCKS),
    Patch("threading._time", always(clocks.monotonic), "a copy of time.monotonic that threading keeps", _THREADS, VIRTUAL),
    Patch("queue.time", always(clocks.monotonic), "a copy of time.monotonic that queue keeps", _THREADS, VIRTUAL),
    Patch("builtins.__import__", always(private_modules.import_), "two runs of a program share no globals", _MODULES,
          PRIVATE),
    *(Patch(f"{module}.import_module", always(private_modules.import_module), "two runs of a program share no globals",
            _MODULES, PRIVATE)
      for module in ("importlib", "importlib.metadata")),
    *(Patch(f"pickle.{name}", with_own_modules, "a program pickles its own classes", f"{_HERE}pickling.py", PRIVATE)
      for name in ("dump", "dumps", "load", "loads")),
    Change("sys.path", private_modules.own_path, "packages of a process's workspace can be imported", _MODULES,
           PRIVATE),
)

patch_manager.register(*TABLE)
patch_manager.on_open.append(import_hooks.lend_to_imported)
