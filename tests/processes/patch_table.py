"""`python -m tests.processes.patch_table`: write docs/patches.md, the table of all that sessions replace of Python's."""

from __future__ import annotations

from pathlib import Path

from rclpy import signals

from coursekit.jupyter import kernel
from coursekit.lab import help_text, shell_lines
from coursekit.processes import older_numpy, older_scipy, patches, worker_processes
from coursekit.processes.patching import Patch
from coursekit.view import highgui, plots

DOCUMENT = Path(__file__).parents[2] / "docs" / "patches.md"
HEAD = """# What coursekit replaces in the interpreter

Many programs run in one interpreter here, and each expects to be alone: with its own output, arguments, environment,
signals, threads and time. So some names of Python and of libraries lead elsewhere while sessions are open. This is the
whole list. It is made from the tables in the code by `python -m tests.processes.patch_table`; do not edit it.

- Importing coursekit and making a `Session` replace nothing. `session.use()`, `session.start()` and the first node of an
  interpreter do; `session.close()` takes back what no other session needs.
- After the last session every name is as it was found (`tests/processes/test_patches.py` compares them in a fresh
  interpreter). What another library has put in a place meanwhile stays there.
- Code outside of a session's processes gets Python's own behaviour through a replacement. On the virtual clock the code that
  opened the session counts as inside; in a kernel, only the cell that runs.
- Two things last longer: a kernel's patches stay as long as the kernel, and nothing is taken back while the thread of a
  program that could not be ended still runs, because its output would be taken for the interpreter's.
- `import rclpy` alone puts the finders of `sys.meta_path` in place, so that a plain script is told of missing packages, and
  gives NumPy, SciPy, Matplotlib and OpenCV the names of Humble's versions, which a script may say above its first node.
- "In place with" says what brings a patch: any session, one with processes, one on the virtual clock, one whose processes
  have modules of their own, or a kernel.

| Target | In place with | Why | Python | Test |
|---|---|---|---|---|
"""


def rows() -> list[Patch]:
    """All patches of all rooms."""
    rooms = (signals, older_numpy, older_scipy, highgui, plots, worker_processes, kernel, shell_lines, help_text)
    return [*patches.TABLE, *(patch for room in rooms for patch in room.patches())]


def document() -> str:
    """The text of docs/patches.md."""
    return HEAD + "".join(
        f"| `{row.target}` | {row.group} | {row.reason} | {row.versions} | `{row.test}` |\n" for row in rows()
    )


if __name__ == "__main__":
    DOCUMENT.write_text(document(), encoding="utf-8")
