"""For every exercise two wrong answers fail, with words that help; other right ones and the solution earn all points."""

import importlib
import pkgutil

import nbformat
import pytest
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

from coursekit.grade.exercise import all_exercises

from . import wrong
from .running import chapters, course_environment

CHAPTERS = {path.stem[:2] if path.stem[0].isdigit() else path.stem[0].lower(): path for path in chapters()}
MODULES = [module.name for module in pkgutil.iter_modules(wrong.__path__)]

pytestmark = [pytest.mark.timeout(600), pytest.mark.slow]


def wrong_answers(module):
    return importlib.import_module(f"{wrong.__name__}.{module}").WRONG


def other_right_answers(module):
    return getattr(importlib.import_module(f"{wrong.__name__}.{module}"), "RIGHT", {})


def grading(cell):
    return cell.metadata.get("nbgrader", {})


def test_every_exercise_has_two_wrong_answers():
    known = {name for module in MODULES for name, texts in wrong_answers(module).items() if len(texts) >= 2}
    assert known == {name for name in all_exercises() if name.startswith(("ch0", "app"))}  # others are of a teacher's own


def verdict_of(cell):
    return "\n".join(output.data["text/plain"] for output in cell.outputs if output.output_type == "display_data")


@pytest.mark.parametrize("module", MODULES)
def test_wrong_answers_fail_with_help_and_the_solution_earns_all_points(module, tmp_path):
    notebook = nbformat.read(CHAPTERS[module.removeprefix("ch").removeprefix("app")], as_version=4)
    answers, others = wrong_answers(module), other_right_answers(module)
    (tmp_path / "ros2_ws" / "src").mkdir(parents=True)
    with course_environment(tmp_path):
        client = NotebookClient(
            notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}
        )
        with client.setup_kernel():
            for index, cell in enumerate(notebook.cells):
                if grading(cell).get("solution"):
                    name = grading(cell)["grade_id"].replace("-", ".")
                    fail_first(client, notebook.cells, index, answers.get(name, []))
                    pass_too(client, notebook.cells, index, others.get(name, []))
                client.execute_cell(cell, index)
                if grading(cell).get("grade"):
                    assert verdict_of(cell).startswith("✔"), verdict_of(cell)


def pass_too(client, cells, index, texts):
    """Run each text in the solution's place, and what follows it up to the check, which must take it."""
    name = grading(cells[index])["grade_id"]
    for text in texts:
        copies = [nbformat.from_dict(dict(cell)) for cell in cells[index:]]
        copies[0].source = text
        for offset, cell in enumerate(copies):
            client.execute_cell(cell, index + offset)
            if grading(cell).get("grade_id") == f"{name}-check":
                assert verdict_of(cell).startswith("✔"), (text, verdict_of(cell))
                break


def fail_first(client, cells, index, texts):
    """Run each wrong text in the solution's place, and what follows it up to the check, which must refuse it."""
    name = grading(cells[index])["grade_id"]
    for text in texts:
        copies = [nbformat.from_dict(dict(cell)) for cell in cells[index:]]
        copies[0].source = text
        for offset, cell in enumerate(copies):
            is_check = grading(cell).get("grade_id") == f"{name}-check"
            try:
                client.execute_cell(cell, index + offset)
            except CellExecutionError as error:
                if is_check:
                    assert error.ename == "CheckFailed", (text, str(error))
                    said = verdict_of(cell)
                    assert said.startswith("✘") and "expected:" in said, said
                    print(text[-300:], said, sep="\n")
                    break
                continue  # a wrong answer may break cells before the check
            assert not is_check, f"a wrong answer to {name} passes: {text}"
        else:
            pytest.fail(f"no check with the grade_id {name}-check stands below {name}")
