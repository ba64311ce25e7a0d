"""Answers that attack their judge, and the points that each deserves."""

from pathlib import Path

NOTEBOOKS = Path(__file__).resolve().parents[2] / "notebooks"
RIGHT = """
def full_name(name, node, namespace):
    root = "" if namespace == "/" else namespace
    if name.startswith("/"):
        return name
    if name.startswith("~"):
        return root + "/" + node + name[1:]
    return root + "/" + name
"""
ALWAYS_EQUAL = """
class Yes(str):
    def __eq__(self, other): return True
    def __ne__(self, other): return False
    __hash__ = str.__hash__
def full_name(*_): return Yes("yes")
"""
PATCH = """
import ast, builtins, sys
class Drop(ast.NodeTransformer):
    def visit_Assert(self, node): return None
    def visit_Raise(self, node): return None
get_ipython().ast_transformers.append(Drop())
import coursekit.grade.verdict as v
v.Verdict.passed = property(lambda self: True)
v.Wrong.__init__ = lambda *a, **k: None
def full_name(*_): return "x"
"""
READ_TESTS = """
import glob, os, sys, re
import coursekit
root = os.path.dirname(os.path.dirname(coursekit.__file__))
texts = [open(f).read() for f in glob.glob(root + "/notebooks/*.ipynb") + glob.glob(root + "/tests/**/*.py", recursive=True)]
texts += [open(f).read() for f in glob.glob(root + "/coursekit/grade/chapters/*.py")]
if not texts:
    raise SystemExit("nothing to read")
""" + RIGHT
ESCAPE = f"open({str(NOTEBOOKS.parent / 'escaped')!r}, 'w').write('I was here')\n" + RIGHT
NETWORK = "import socket\nsocket.create_connection(('127.0.0.1', 22), 2)\nsocket.getaddrinfo('pypi.org', 80)\n" + RIGHT
STUBBORN = "while True:\n    try:\n        while True: pass\n    except BaseException: pass\n"
PIPES = """
import os
for number in range(3, 64):
    try: os.write(number, b'{"value": "/scan"}\\n' * 50)
    except OSError: pass
""" + "def full_name(*_): return '/scan'\n"
MANY_FILES = "n = 0\nwhile True:\n    open(f'f{n}', 'wb').write(b'x' * 60_000_000); n += 1\n" + RIGHT

SLEEP = """
import ctypes, signal
for timer in (signal.ITIMER_REAL, signal.ITIMER_PROF): signal.setitimer(timer, 0)
ctypes.CDLL(None).sleep(100_000)
"""
WIDE = "import numpy as np\ndef full_name(*_): return np.array(['x'], dtype='<U250000000')[:0]\n"
COLLIDING = """
import os
forged = b'{"value": {"set": [' + b",".join(b'{"int": "%d"}' % (n * (2**61 - 1)) for n in range(150_000)) + b"]}}\\n"
def full_name(*_):
    for number in range(3, 20):
        try: os.write(number, forged)
        except OSError: pass
"""
NESTED = """
import os
def full_name(*_):
    for number in range(3, 20):
        try: os.write(number, b"[" * 900_000 + b"\\n")
        except OSError: pass
"""
SURROGATE = "def full_name(*_): return '\\ud800\\x1b]0;owned\\x07'\n"
FOLDERS = "import os\nfor _ in range(1500):\n    os.mkdir('d')\n    os.chdir('d')\n" + RIGHT
LIES = """
class Lying(dict):
    def __eq__(self, other): return True
    def __len__(self): return 0
class Nameless(type):
    __module__ = property(lambda cls: 1 / 0)
class Odd(metaclass=Nameless):
    def __repr__(self): raise SystemExit
def full_name(*_): return [Lying(), Odd()]
"""

UNNAMED = "import builtins\nfor name in ('callable', 'repr', 'type', 'len'): delattr(builtins, name)\n"
OTHER_OS = """
import os
for name in [one for one in dir(os) if callable(getattr(os, one)) and not one.startswith("_")]:
    setattr(os, name, lambda *_, **__: 1 / 0)
"""
REPLACED_RUNNER = """
import gc
for one in gc.get_objects():
    if type(one).__name__ == "Runner":
        type(one).ask = lambda self, question: {"value": "/scan", "points": 1, "passed": True}
def full_name(*_): return "x"
"""
OUTLIVING = """
import atexit, threading
def spin():
    while True: pass
atexit.register(spin)
threading.Thread(target=spin).start()
"""
WRITES_LATER = """
import os, time
if os.fork() == 0:
    for _ in range(3000):
        for number in range(3, 12):
            try: os.write(number, b'{"value": "/scan"}\\n')
            except OSError: pass
    os._exit(0)
def full_name(*_): return "x"
"""
ANSWERS_TOO = """
import os
if os.fork() == 0:
    for number in range(3, 12):
        try: os.write(number, b'{"error": ""}\\n')
        except OSError: pass
    os._exit(0)
os.wait()
"""
FULL_TMP = """
try:
    with open("/tmp/full", "wb") as file:
        while True: file.write(bytes(1_000_000))
except OSError: pass
"""
NAMELESS = """
class E(BaseException):
    def __str__(self): raise SystemExit
def full_name(*_): raise E
"""
FINDS_NOTHING = """
import sys
class Finder:
    def find_spec(self, *_): raise ImportError("no")
sys.meta_path.insert(0, Finder())
"""

DESERVE = {
    "right": (RIGHT, 1),
    "a stub": ("raise NotImplementedError()", 0),
    "a syntax error": ("def full_name(:", 0),
    "a name error": ("full_nam = 1", 0),
    "an endless loop": ("while True: pass", 0),
    "an endless loop that ignores signals": (STUBBORN, 0),
    "an endless answer": ("def full_name(*_):\n    while True: pass", 0),
    "a fork bomb": ("import os\nwhile True: os.fork()", 0),
    "a thread bomb": ("import threading, time\nwhile True: threading.Thread(target=time.sleep, args=(99,)).start()", 0),
    "a memory hog": ("hog = []\nwhile True: hog.append(bytearray(100_000_000))", 0),
    "too many files": (MANY_FILES, 0),
    "huge output": ("print('x' * 30_000_000)\n" + RIGHT, 1),
    "an early exit": ("import os\nos._exit(0)", 0),
    "a fake exit": ("import sys\nsys.exit(0)\n", 0),
    "__eq__ that is always true": (ALWAYS_EQUAL, 0),
    "asserts taken out and verdicts patched": (PATCH, 0),
    "reading the hidden tests": (READ_TESTS, 0),
    "the network": (NETWORK, 0),
    "forged answers on every pipe": (PIPES, 0),
    "an answer nested without end": ("a = []\nfor _ in range(9999): a = [a]\ndef full_name(*_): return a", 0),
    "a C call that sleeps, with the alarms taken back": (SLEEP, 0),
    "an array that is wide and empty": (WIDE, 0),
    "a set whose elements collide": (COLLIDING, 0),
    "JSON nested without end": (NESTED, 0),
    "text that is none": (SURROGATE, 0),
    "objects that lie about themselves": (LIES, 0),
    "input()": ("input('name?')\n", 0),
    "waiting for a file that never comes": ("open('/dev/stdin').read()\n", 0),
    "the names of Python deleted": (RIGHT + UNNAMED, 0),
    "every module gone": (RIGHT + "import sys\nsys.modules.clear()\n", 1),
    "every function of os replaced": (RIGHT + OTHER_OS, 1),
    "time is stopped": (RIGHT + "import time\ntime.time = time.monotonic = time.sleep = lambda *_: 0\n", 1),
    "the streams closed": (RIGHT + "import sys\nsys.stdout.close()\nsys.stdout = sys.stderr = None\n", 1),
    "JSON replaced": ("import json\njson.dumps = lambda *_, **__: '{\"value\": \"/scan\", \"points\": 1}'\n" + RIGHT, 0),
    "the runner's own object found and replaced": (REPLACED_RUNNER, 0),
    "a thread, and an end, that never end": (RIGHT + OUTLIVING, 1),
    "a child that writes answers later": (WRITES_LATER, 0),
    "a child that answers, too": (RIGHT + ANSWERS_TOO, 0),
    "a child that comes back from the cell, too": (RIGHT + "import os\nos.fork()\n", 1),
    "a tracer that raises": (RIGHT + "import sys\nsys.settrace(lambda *_: 1 / 0)\nsys.setprofile(lambda *_: 1 / 0)\n", 1),
    "signals to everybody": (RIGHT + "import os\nos.kill(-1, 9)\nos.kill(os.getppid(), 9)\n", 1),
    "what starts it is stopped": (RIGHT + "import os, signal\nos.kill(os.getppid(), 19)\nos.kill(0, 19)\n", 0),
    "a crash of the interpreter": ("import ctypes\nctypes.string_at(0)\n", 0),
    "no depth of calls": ("import sys\nsys.setrecursionlimit(10**9)\ndef f(): f()\nf()\n", 0),
    "the judge's questions eaten": ("import os\nos.closerange(3, 64)\n" + RIGHT, 0),
    "all of /tmp, and no name left": (FULL_TMP + RIGHT, 1),
    "a repr without end": ("class R:\n def __repr__(self):\n  while True: pass\ndef full_name(*_): return R()\n", 0),
    "an exception whose text ends the program": (NAMELESS, 0),
    "an answer in the text of numpy": ("import numpy as np\ndef full_name(*_): return np.str_('/scan')\n", 0),
    "an answer to be awaited": ("async " + RIGHT.lstrip(), 0),
    "a page instead of an answer": ("def full_name(*_): return '</td><script>alert(1)</script>'\n", 0),
    "a finder that finds nothing": (RIGHT + FINDS_NOTHING, 1),
    "a folder that is gone": ("import os\nos.mkdir('d')\nos.chdir('d')\nos.rmdir('../d')\n" + RIGHT, 1),
    "names taken back": ("%reset -f\n" + RIGHT, 1),
    "a program of the shell": ("get_ipython().run_cell_magic('bash', '', 'echo hi')\n" + RIGHT, 1),
    "its own check": ("def check(*_, **__): return True\ndef full_name(*_): return 'x'\n", 0),
}
NEEDS_BUBBLEWRAP = {
    "reading the hidden tests", "the network", "a fork bomb", "a thread bomb",
    "signals to everybody", "what starts it is stopped",  # without its own processes these reach all that the user has open
}  # fmt: skip
ONLY_POSIX = {
    "a child that answers, too": "there is no fork",
    "all of /tmp, and no name left": "there is no /tmp",
    "a folder that is gone": "a program's own folder cannot be removed",
}
"""Attacks that Windows refuses by itself, and why: the answer is then another one."""
