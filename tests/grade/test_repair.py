"""What was handed in, beside what was handed out."""

import json

import pytest

from coursekit.grade import sandbox
from coursekit.grade.copy import student_notebook
from coursekit.grade.exercise import all_exercises
from coursekit.grade.mark import Marked, mark
from coursekit.grade.repair import repair
from coursekit.grade.similar import shingles, similar
from coursekit.grade.submissions import Submission
from tests.grade.solutions import NOTEBOOKS

SOURCE = json.loads((NOTEBOOKS / "00_start_here.ipynb").read_text())


def test_stubs_that_nobody_touched_are_known():
    handed_in = student_notebook(SOURCE)
    assert repair(SOURCE, handed_in).begun == {"ch00.q1": False, "ch00.q2": False, "ch00.q3": False}
    cell = next(
        candidate
        for candidate in handed_in["cells"]
        if candidate["metadata"].get("nbgrader", {}).get("grade_id") == "ch00-q2"
    )
    cell["source"] = 'presses = [("up", 0.5)]'
    assert repair(SOURCE, handed_in).begun == {"ch00.q1": False, "ch00.q2": True, "ch00.q3": False}


def _steps(*cells):
    """What is run of a chapter with these code cells: the texts, each with its tags."""
    code_cells = [
        {"cell_type": "code", "metadata": {"tags": tags}, "source": source, "outputs": []} for source, tags in cells
    ]
    return [step.source for step in repair({"cells": code_cells}, {"cells": code_cells}).steps]


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
    at = next(k for k, cell in enumerate(handed_in["cells"]) if "ch00-q1" in str(cell["metadata"]))
    handed_in["cells"].insert(at, {"cell_type": "code", "metadata": {}, "source": 'me = "Ada L"', "outputs": []})
    assert repair(SOURCE, handed_in).begun["ch00.q1"]


def test_a_notebook_as_it_was_handed_out_earns_nothing(tmp_path):
    (tmp_path / "ana").mkdir()
    (tmp_path / "ana" / "00_start_here.ipynb").write_text(json.dumps(student_notebook(SOURCE)))
    exercises = {name: exercise for name, exercise in all_exercises().items() if name.startswith("ch00")}
    marked = mark(Submission("ana", tmp_path / "ana"), {"00_start_here.ipynb": SOURCE}, exercises, sandbox.Limits())
    assert marked.total() == 0
    assert {verdict.got for verdict in marked.verdicts} == {"the cell as it was handed out"}


def _marked(name, *cells):
    """Somebody whose first exercises of chapter 6 are these, and the others as they were handed out."""
    source = json.loads((NOTEBOOKS / "06_urdf_and_robot_states.ipynb").read_text(encoding="utf-8"))
    theirs = student_notebook(source)
    own = iter(cells)
    for cell in theirs["cells"]:
        if cell["metadata"].get("nbgrader", {}).get("solution"):
            cell["source"] = next(own, cell["source"])
    return Marked(name, "", answers=repair(source, theirs).answers())


def test_what_was_given_is_no_work_that_is_alike():
    """Two who did little, each in their way, have hundreds of words of the course's stubs in common."""
    marks = [_marked("ann", "parts = ['base_link', 'wheel']"), _marked("ben", "parts = list('abc')\nprint(parts)")]
    assert similar(marks) == [] and not shingles(_marked("cem").answers)
    long = "\n".join(f"def f{n}(a, b):\n    return a + b * {n} - {n + 1}" for n in range(9))
    copied = long.replace("(a, b)", "(one, other)").replace("a + b", "one + other")
    assert [pair[:2] for pair in similar([_marked("ann", long), _marked("ben", copied)])] == [("ann", "ben")]


def test_however_many_cells_have_one_name_the_notes_stay_short():
    """Thousands of doubled cells once made more notes than an examination may tell: there was no mark at all."""
    theirs = student_notebook(SOURCE)
    named = {"nbgrader": {"grade_id": "x" * 500}}
    doubled = [cell for cell in theirs["cells"] if cell["metadata"].get("nbgrader", {}).get("solution")]
    theirs["cells"] += [{"cell_type": "code", "metadata": named, "source": "1"}] * 9000 + doubled * 3000
    theirs["cells"].append({**doubled[0], "cell_type": "y" * 9000})
    notes = repair(SOURCE, theirs).notes
    assert 1 < len(notes) < 9 and max(map(len, notes)) < 200
