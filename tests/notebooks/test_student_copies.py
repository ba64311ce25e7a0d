"""A student's copy of a chapter fails only at the stubs that they are to fill in."""

import json

import nbformat
import pytest

from coursekit.grade.copy import student_notebook

from .running import chapters, code_cells, run

pytestmark = [pytest.mark.timeout(600), pytest.mark.slow]


@pytest.mark.parametrize("chapter", chapters(), ids=lambda path: path.stem)
def test_a_student_s_copy_fails_only_at_the_stubs(chapter, tmp_path):
    copy = student_notebook(json.loads(chapter.read_text(encoding="utf-8")))
    notebook = nbformat.reads(json.dumps(copy), as_version=4)
    run(notebook, tmp_path, allow_errors=True, timeout=300)
    for cell in code_cells(notebook):
        errors = [output for output in cell.outputs if output.output_type == "error"]
        kind = cell.metadata.get("nbgrader", {})
        if errors:
            assert kind or "after-exercise" in cell.metadata.get("tags", []), (cell.source, errors[0]["evalue"])
            assert errors[0]["ename"] in ("NotImplementedError", "CheckFailed", "NameError"), errors[0]
        elif kind.get("locked"):
            pytest.fail(f"the check passes without a solution: {cell.source}")
