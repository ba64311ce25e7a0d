"""Modules may be imported again beside what they have patched: pytest's pytester forgets those of each test."""

import subprocess
import sys
import textwrap

import pytest

PROGRAM = """
    import sys

    def open_and_print(word):
        from coursekit.processes.session import Session

        session = Session(virtual=True)
        session.open()
        process = session.start(lambda: print(word, *sys.argv[1:]), name="speaker", argv=[word])
        assert (process.wait(), process.output) == (0, f"{word} {word}\\n"), process.output
        return session

    before = type(sys), list(sys.argv)
    first = open_and_print("one")
    forgotten = [name for name in sys.modules if name.startswith(FORGOTTEN)]
    assert forgotten
    for name in forgotten:
        del sys.modules[name]
    second = open_and_print("two")
    second.close()
    first.close()
    assert (type(sys), list(sys.argv)) == before
    print("restored")
"""


@pytest.mark.parametrize("forgotten", ["coursekit.", "coursekit.processes.patches", "coursekit.processes.streams"])
def test_sessions_open_and_close_though_modules_were_forgotten(forgotten):
    program = textwrap.dedent(PROGRAM).replace("FORGOTTEN", repr(forgotten))
    done = subprocess.run([sys.executable, "-c", program, "a word"], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout) == (0, "restored\n"), done.stderr
