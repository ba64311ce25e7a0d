"""`coursekit grade --review` as a teacher runs it, with a cheap way to mark: what is tested is the marking by hand."""

import contextlib
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

from coursekit.grade.bundle import pack_bundle

from .handed import TOPICS, text, write

PICTURE = b"\x89PNG\r\n\x1a\n" + bytes.fromhex(
    "0000000d49484452000000010000000108060000001f15c4890000000d49444154789c6360606060000000050001a5f645400000000049454e44ae426082"
)
_CHEAPLY = """
import sys
from unittest import mock
from coursekit.cli.coursekit import main
from tests.grade.handed import cheap_mark
with mock.patch("coursekit.grade.batch.mark", cheap_mark):
    sys.exit(main(sys.argv[1:]))
"""


def make_class(folder: Path) -> None:
    """Ann handed in a sealed file with a picture; Ben and a student with an odd name, notebooks; Bo nothing."""
    write(folder.parent / "roster.txt", "Ann Lee\nBen Ito\nBo Ahn\nCem <b>Kaya\n")
    facts = {"student": "Ann Lee", "notebook": TOPICS, "time": "2026-11-23 08:00:00 +0000"}
    files = {TOPICS: text("q1", "q2").encode(), "evidence/AnnLee_evidence_s2.png": PICTURE, "evidence/x.png": b"<svg>"}
    write(folder / "Ann Lee" / "AnnLee_02_topics.zip", pack_bundle(files, facts))
    for name in ("Ben Ito", "Cem <b>Kaya"):
        write(folder / name / TOPICS, text("q1", own="<script>document.title = 'mine'</script>"))


@contextlib.contextmanager
def reviewing(folder: Path, *words: str):
    """Run it; the address, until the context ends with Ctrl-C."""
    command = [sys.executable, "-c", _CHEAPLY, "grade", str(folder), "--allow-root", "--unsafe", "--review"]
    env = {**os.environ, "BROWSER": "true", "PYTHONUNBUFFERED": "1"}
    out = ["--out", str(folder.parent / "grades.csv"), "--roster", str(folder.parent / "roster.txt")]
    root = Path(__file__).resolve().parents[2]
    child = subprocess.Popen([*command, *out, *words], cwd=root, env=env, stdout=subprocess.PIPE, encoding="utf-8",
                             preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler))  # fmt: skip
    try:
        said = ""
        while not (match := re.search(r"Mark by hand at (\S+)", said)):
            line = child.stdout.readline()
            assert line, f"it ended: {said}"
            said += line
        yield match[1]
    finally:
        child.send_signal(signal.SIGINT)
        child.communicate(timeout=60)
    assert child.returncode == 0
