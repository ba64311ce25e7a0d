"""What was handed in, beside what was handed out."""

import json

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
