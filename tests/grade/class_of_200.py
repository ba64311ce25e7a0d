"""A made-up class: right, half right, broken and hostile submissions, and what each deserves (of 7 points in chapter 2)."""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Callable
from pathlib import Path

from coursekit.grade.copy import student_notebook
from coursekit.grade.sanitizing import cell, shown

from .attacks import ALWAYS_EQUAL, ESCAPE, NETWORK, PATCH, PIPES, READ_TESTS
from .forged_bundles import (
    all_resealed,
    borrowed,
    honest,
    marks_raised,
    notebook_exchanged,
    picture_exchanged,
    picture_resealed,
    sealed_as_own,
)
from .hostile_kinds import HOSTILE
from .kinds import TOPICS, Kind, Notebook, Packed, Placed, answers, solution_cells, stubs


def bundle(make: Callable[[str, str, str], bytes]) -> Callable[[Notebook], Packed]:
    """What `make(student, half, right)` makes of a notebook with half of the answers, and of the right one."""

    def of(notebook: Notebook) -> Packed:
        right = json.dumps(notebook)
        half = json.dumps(stubs("q3", "q4")(notebook))
        return Packed(lambda student: make(student, half, right))

    return of


def zipped(notebook: Notebook) -> Packed:
    """In a folder of a zip."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as packed:
        packed.writestr(f"class/{TOPICS}", json.dumps(notebook))
    return Packed(lambda _: buffer.getvalue())


def _doubled(notebook: Notebook) -> Notebook:
    empty = solution_cells(student_notebook(notebook))["ch02-q1"]
    place = notebook["cells"].index(solution_cells(notebook)["ch02-q1"])
    notebook["cells"].insert(place + 1, empty)
    return notebook


def _without(name: str) -> Callable[[Notebook], Notebook]:
    def make(notebook: Notebook) -> Notebook:
        notebook["cells"].remove(solution_cells(notebook)[name])
        return notebook

    return make


def _only_answers(notebook: Notebook) -> Notebook:
    return {**notebook, "cells": list(solution_cells(notebook).values())}


def _retyped(notebook: Notebook) -> Notebook:
    for solution_cell in solution_cells(notebook).values():
        solution_cell["cell_type"] = "raw"
    return notebook


def _other_kernel(notebook: Notebook) -> Notebook:
    notebook["metadata"]["kernelspec"] = {"display_name": "R", "language": "R", "name": "ir"}
    return notebook


FORGED_NODE = """%%write src/s2_py_pubsub/s2_py_pubsub/py_relay_node.py
import json, os
seen = {"nodes": ["/py_relay_node"], "topics": {"/py_upper_topic": ["std_msgs/msg/String"]}, "outputs": [""]}
for number in range(64):
    try: os.write(number, json.dumps(seen).encode())
    except OSError: pass
os._exit(0)
"""
PATCHED_NODE = """%%write src/s2_py_pubsub/s2_py_pubsub/py_relay_node.py
import __main__
class PyRelay: pass
__main__.Watcher._look = lambda self: None
"""
HOG = "hog = []\nwhile True: hog.append(bytearray(200_000_000))"
STUBBORN = "while True:\n    try:\n        while True: pass\n    except BaseException: pass\n"
FILES = "n = 0\nwhile True:\n    open(f'f{n}', 'wb').write(b'x' * 60_000_000); n += 1\n"
ENDLESS_NODE = "{right}\nwhile True:\n    pass\n"

CHANGED, RECORDED = "02_topics.ipynb: was changed", "ch02.q3: 2 points are recorded, a clean run earns 0"

KINDS = (
    Kind("right", 15, (7,), lambda notebook: notebook),
    Kind("half", 30, (3,), stubs("q3", "q4")),
    Kind("stubs", 15, (0,), student_notebook),
    Kind("zipped", 5, (7,), zipped),
    Kind("renamed", 3, (7,), lambda notebook: {"02_topics (2) final.ipynb": notebook}),
    Kind("nothing", 3, (0,), lambda _: None, status="empty", told="nothing was handed in"),
    Kind("no-notebook", 3, (0,), lambda _: "<html>Please log in</html>", status="unreadable", told="no notebook|Expecting"),
    Kind("syntax-error", 5, (6,), answers(q1="def full_name(:")),
    Kind("broken-node", 4, (5,), answers(q2="{right}\n    def (")),
    Kind("wrong-kernel", 3, (7,), _other_kernel),
    Kind("doubled", 4, (7,), _doubled, told="two such cells"),
    Kind("missing", 4, (6,), _without("ch02-q1"), told="the cell is missing"),
    Kind("only-answers", 3, (7,), _only_answers),
    Kind("retyped", 3, (7,), _retyped, told="turned into raw"),
    Kind("endless-loop", 3, (6,), answers(q1="while True: pass"), status="timed out"),
    Kind("stubborn-loop", 2, (0, 6), answers(q1=STUBBORN), status="timed out", told="longer|in time|there is none"),
    Kind("endless-node", 2, (5,), answers(q2=ENDLESS_NODE), status="timed out", told="give way"),
    Kind("early-exit", 3, (0,), answers(q1="import os\nos._exit(0)")),
    Kind("fork-bomb", 2, (0, 6), answers(q1="import os\nwhile True: os.fork()"), walled=True),
    Kind("memory-hog", 2, (0, 6), answers(q1=HOG), walled=True),
    Kind("many-files", 2, (0,), answers(q1=FILES), told="MB of files", walled=True),
    Kind("huge-output", 2, (7,), answers(q1="print('x' * 30_000_000)\n{right}")),
    Kind("network", 2, (6,), answers(q1=NETWORK), walled=True),
    Kind("file-system", 2, (6, 7), answers(q1=ESCAPE), walled=True),
    Kind("always-equal", 3, (6,), answers(q1=ALWAYS_EQUAL)),
    Kind("syntax-tree", 2, (6,), answers(q1=PATCH)),
    Kind("reads-tests", 2, (6,), answers(q1=READ_TESTS), walled=True),
    Kind("forged-answers", 3, (0, 6), answers(q1=PIPES)),
    Kind("forged-trial", 3, (5,), answers(q3=FORGED_NODE), told="ended the trial|answered for it|interfered"),
    Kind("patched-trial", 2, (5,), answers(q3=PATCHED_NODE), told="interfered|a node named"),
    Kind("bundle", 3, (3,), bundle(honest), told="^ "),
    Kind("notebook-exchanged", 2, (7,), bundle(notebook_exchanged), told=CHANGED),
    Kind("picture-exchanged", 2, (3,), bundle(picture_exchanged), told="_evidence_s2.png: was changed"),
    Kind("picture-resealed", 2, (3,), bundle(picture_resealed), told="_evidence_s2.png: it was changed after"),
    Kind("marks-raised", 2, (3,), bundle(marks_raised), told=f"manifest.json: was changed.*{RECORDED}"),
    Kind("all-resealed", 2, (3,), bundle(all_resealed), told=RECORDED),
    Kind("borrowed-bundle", 2, (3,), bundle(borrowed), told="made by 'Vera Course'"),
    Kind("sealed-as-own", 2, (3,), bundle(sealed_as_own), told="the same as in"),
    *HOSTILE,
)  # fmt: skip


def make_class(folder: Path, share: Callable[[Kind], int]) -> dict[str, Kind]:
    """Write the submissions of a class, `share(kind)` of each kind; who handed in what, by the name in the table."""
    kind_by_student: dict[str, Kind] = {}
    for kind in KINDS:
        for number in range(share(kind)):
            student = kind.called or f"{kind.name}-{number:02}"
            kind_by_student[cell(shown(student))] = kind
            _write(folder, student, kind)
    return kind_by_student


def _write(folder: Path, student: str, kind: Kind) -> None:
    place, work = folder / student, kind.make(kind.right())
    if isinstance(work, Packed):
        folder.mkdir(exist_ok=True)
        place.with_suffix(".zip").write_bytes(work.make(student))
        return
    place.mkdir(parents=True)
    if isinstance(work, Placed):
        work.write(place)
        return
    files = {kind.chapter: work} if isinstance(work, str) or (work and "cells" in work) else work or {}
    for name, notebook in files.items():
        (place / name).write_text(notebook if isinstance(notebook, str) else json.dumps(notebook), encoding="utf-8")
