"""`python -m coursekit.packages.gtest_program PROGRAM WORDS...`: a test in C++ as a process of a session, like any node."""

from __future__ import annotations

import sys
from pathlib import Path

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session


def main(words: list[str]) -> int:
    """Run it to its end; return its exit code."""
    program = Path(words[0])
    with (session := Session(virtual=False)).use():
        process = session.launch(make_process(session, program, words[1:], name=program.name))
        code = process.wait()
        print(process.output, end="", flush=True)
    return int(code or 0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
