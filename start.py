"""Sets the course up in the folder .venv, and opens or tests it: the same on Linux, macOS and Windows.

python3 start.py          open the course in JupyterLab (on Windows: py -3 start.py, or a double click on start.bat)
python3 start.py test     all tests, every notebook executed and compared
python3 start.py setup    only set up; `setup test` with what the tests need

Words after `lab` go to `coursekit lab`. It is read by old Pythons too, so that they can be told what is needed.
"""

import os
import platform
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent
VENV = ROOT / ".venv"
NEEDED = (3, 10)
"""The oldest Python, which is Humble's."""
NEVER_IN_A_FOLDER = '"$`\\'
"""What runs as a command, or breaks, in the scripts that pip and venv write for a shell; Windows has no such scripts."""
NEWEST_ON_INTEL_MACS = (3, 13)
"""The newest Python for which Numba has a package on Macs that have no processor of Apple's."""


def refusal():
    """Why the course cannot be installed for this Python, and what to do; empty when it can."""
    found = f"{platform.python_version()} ({sys.executable})"
    if sys.version_info[:2] < NEEDED:
        return f"Python 3.10 or newer is needed, and this is {found}. Install one from https://www.python.org/downloads/"
    if sys.maxsize < 2**32:
        return f"A 64-bit Python is needed, and this one has 32: {found}. On python.org, take 'Windows installer (64-bit)'."
    if sys.platform == "darwin" and platform.machine() == "x86_64" and sys.version_info[:2] > NEWEST_ON_INTEL_MACS:
        return (
            f"Numba has no package for Macs with Intel's processor and Python 3.14, and this is {found}. "
            "Install Python 3.13 from https://www.python.org/downloads/ and type: python3.13 start.py"
        )
    if sys.platform == "win32" and "ARM" in platform.machine().upper() and "ARM" in sys.version:
        return (
            f"OpenCV has no package for Python on ARM, and this is {found}. Windows runs the other kind, too: "
            "on python.org, take 'Windows installer (64-bit)'."
        )
    wrong = [sign for sign in NEVER_IN_A_FOLDER if sign in str(ROOT)]
    if wrong and os.name == "posix":
        why = f"pip's scripts take {' and '.join(wrong)} for commands"
        return f"The course cannot be installed in {ROOT}: {why}. Rename the folder without it."
    return ""


def python_of(venv):
    """The interpreter of an environment."""
    return venv / "Scripts" / "python.exe" if sys.platform == "win32" else venv / "bin" / "python"


def what_to_install(extra=""):
    """pip's words for the course: from this folder as it is, so that `git pull` is all that an update needs.

    Python before 3.13 on Windows reads the path of such an installation in the code page, and finds no folder with an
    accent: there a copy is installed.
    """
    name = f".[{extra}]" if extra else "."
    copied = sys.platform == "win32" and sys.version_info < (3, 13) and not str(ROOT).isascii()
    return [name] if copied else ["-e", name]


def set_up(extra=""):
    """Install what is missing, and again after an update: the files .lab and .test in .venv say when that was."""
    stamp = VENV / (".test" if extra else ".lab")
    sources = [ROOT / "pyproject.toml", ROOT / "requirements.lock"]
    if stamp.exists() and all(stamp.stat().st_mtime >= one.stat().st_mtime for one in sources):
        must_run([str(python_of(VENV)), "-m", "coursekit.building.underlay"])  # an update may have brought new messages
        return
    if not python_of(VENV).exists():
        must_run([sys.executable, "-m", "venv", str(VENV)])
    quiet = ["-q", "--disable-pip-version-check"]
    must_run([str(python_of(VENV)), "-m", "pip", "install", *quiet, "-c", "requirements.lock", *what_to_install(extra)])
    # Where Python may not write what it has compiled, each notebook and each node would compile all of this again.
    must_run([str(python_of(VENV)), "-m", "compileall", "-q", "coursekit"])
    stamp.touch()
    (VENV / ".lab").touch()


def run(command, **extra):
    """The exit code of a command, which sees the variables given in `extra`; Ctrl-C is the command's."""
    with subprocess.Popen(command, cwd=str(ROOT), env=dict(os.environ, **extra)) as child:
        while True:
            try:
                return child.wait()
            except KeyboardInterrupt:
                pass


def must_run(command):
    """Run a command that has to succeed; else its exit code is ours."""
    code = run(command)
    if code:
        sys.exit(code)


def lab(words):
    """Open the course; the exit code of `coursekit lab`."""
    set_up()
    return run([str(python_of(VENV)), "-m", "coursekit.cli.coursekit", "lab", *words])


def test(words):
    """The tests, then the chapters; the exit code of the first that fails. JOBS says how many run side by side.

    Three are right for two cores, as many of the tests wait for a browser or a kernel.
    """
    set_up("test")
    side_by_side = ["-rs", "-n", os.environ.get("JOBS", "3"), "--dist", "loadfile", "--no-loadscope-reorder"]
    pytest = [str(python_of(VENV)), "-m", "pytest", *side_by_side]
    chapters = ["-p", "tests.notebooks.own_course", "--nbval", "--nbval-cell-timeout", "120", "notebooks"]
    return run([*pytest, *words]) or run([*pytest, *chapters], COURSEKIT_TIME="virtual")


def setup(words):
    """Only set up."""
    set_up("test" if "test" in words else "")
    return 0


def main(words):
    """Do what the command says; its exit code."""
    why = refusal()
    if why:
        print(why, file=sys.stderr)
        return 1
    name, *rest = words or ["lab"]
    commands = {"lab": lab, "test": test, "setup": setup}
    if name not in commands:
        print(f"There is no '{name}'.\n{__doc__}", file=sys.stderr)
        return 2
    return commands[name](rest)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
