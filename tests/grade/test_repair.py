"""What was handed in, beside what was handed out."""

import json

import pytest

from coursekit.grade import sandbox
from coursekit.grade.copy import student_notebook
from coursekit.grade.exercise import all_exercises
from coursekit.grade.mark import mark
from coursekit.grade.repair import repair
from coursekit.grade.submissions import Submission
from tests.grade.solutions import NOTEBOOKS

SOURCE = json.loads((NOTEBOOKS / "00_start_here.ipynb").read_text())


def test_stubs_that_nobody_touched_are_known():
    handed_in = student_notebook(SOURCE)
    assert repair(SOURCE, handed_in).begun == {"ch00.q1": False, "ch00.q2": False, "ch00.q3": False}
    cell = next(one for one in handed_in["cells"] if one["metadata"].get("nbgrader", {}).get("grade_id") == "ch00-q2")
    cell["source"] = 'presses = [("up", 0.5)]'
    assert repair(SOURCE, handed_in).begun == {"ch00.q1": False, "ch00.q2": True, "ch00.q3": False}


def _steps(*cells):
    """What is run of a chapter with these code cells: the texts, each with its tags."""
    made = [{"cell_type": "code", "metadata": {"tags": tags}, "source": source, "outputs": []} for source, tags in cells]
    return [step.source for step in repair({"cells": made}, {"cells": made}).steps]


def test_marking_leaves_out_the_cells_that_are_tagged_and_runs_all_lines_of_the_others():
    mixed = "names = []\nwait(0.1)\nprint(\"(\", terminal)\n%ros2 topic list"
    left_out = ("%ros2 run a b &", ["live"]), ("x = 1", ["cpp", "live"])
    assert _steps((mixed, []), *left_out, ("y = 2", ["cpp"])) == [mixed, "y = 2"]


def test_tags_of_a_student_s_copy_decide_nothing():
    course = {"cells": [{"cell_type": "code", "metadata": {}, "source": "speed = 2.0", "outputs": []}]}
    theirs = {"cells": [{**course["cells"][0], "metadata": {"tags": ["live"]}}]}
    assert [step.source for step in repair(course, theirs).steps] == ["speed = 2.0"]


COMMANDS = ("run", "launch", "topic", "node", "service", "param", "action")
FUNCTIONS = ("wait", "graph", "frames", "terminal", "progress", "evidence", "hand_in")
STARTS_OR_WATCHES = (*(f"%ros2 {command}" for command in COMMANDS), *(f"{function}(" for function in FUNCTIONS))


@pytest.mark.parametrize("file", sorted(NOTEBOOKS.glob("*.ipynb")), ids=lambda file: file.stem)
def test_every_cell_of_a_chapter_that_starts_or_watches_programs_is_tagged(file):
    code = [cell for cell in json.loads(file.read_text())["cells"] if cell["cell_type"] == "code"]
    given = [cell for cell in code if not cell["metadata"].get("nbgrader")]
    untagged = ["".join(cell["source"]) for cell in given if "live" not in cell["metadata"].get("tags", [])]
    lines = [line for text in untagged for line in text.splitlines() if not line.endswith(" --show-args")]
    assert not [line for line in lines if line.startswith(STARTS_OR_WATCHES)]


def test_an_answer_in_a_cell_of_ones_own_counts_as_begun():
    handed_in = student_notebook(SOURCE)
    at = next(k for k, one in enumerate(handed_in["cells"]) if "ch00-q1" in str(one["metadata"]))
    handed_in["cells"].insert(at, {"cell_type": "code", "metadata": {}, "source": 'me = "Ada L"', "outputs": []})
    assert repair(SOURCE, handed_in).begun["ch00.q1"]


def test_a_notebook_as_it_was_handed_out_earns_nothing(tmp_path):
    (tmp_path / "ana").mkdir()
    (tmp_path / "ana" / "00_start_here.ipynb").write_text(json.dumps(student_notebook(SOURCE)))
    exercises = {name: one for name, one in all_exercises().items() if name.startswith("ch00")}
    marked = mark(Submission("ana", tmp_path / "ana"), {"00_start_here.ipynb": SOURCE}, exercises, sandbox.Limits())
    assert marked.total() == 0
    assert {verdict.got for verdict in marked.verdicts} == {"the cell as it was handed out"}
