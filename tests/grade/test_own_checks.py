"""Exercises of a teacher's own are released, checked and graded like the course's."""

import csv
import json
import os
import subprocess
import sys
from dataclasses import replace

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import sandbox
from coursekit.grade.checking import check, judge
from coursekit.grade.copy import student_notebook
from coursekit.grade.exercise import find
from coursekit.grade.own_checks import BadChecks, read_checks
from coursekit.grade.template import write_template
from coursekit.grade.verdict import CheckFailed

from .handed import TOPICS, cheap_mark, grade, text, write

RIGHT = "def stopping_distance(speed, deceleration):\n    return speed * speed / deceleration / 2\n"
HALF = "def stopping_distance(speed, deceleration):\n    return speed / deceleration / 2\n"


NONE = "def stopping_distance(speed, deceleration):\n    speed / deceleration\n"
NAIVE = """
from coursekit.grade.exercise import exercise

@exercise("grip_drill.q1", "Grip", points=2)
def grip(work):
    got = work.function("stopping_distance")(2.0, 2.0)
    assert abs(got - 1.0) < 1e-6
"""


def handed_in(folder, name, answer):
    """A student's notebook with an answer."""
    nb = json.loads((folder / "gripper.ipynb").read_text())
    nb["cells"][3]["source"] = answer
    target = folder.parent / "handed_in" / name
    target.mkdir(parents=True)
    (target / "gripper.ipynb").write_text(json.dumps(student_notebook(nb)))


@pytest.mark.slow
@pytest.mark.skipif(sandbox.tier() != "bubblewrap", reason="NOT TESTED: no bubblewrap: apt-get install bubblewrap")
def test_a_template_is_released_and_graded_as_it_is(tmp_path, capsys):
    own, out = tmp_path / "my_course", tmp_path / "week2"
    assert main(["new", "gripper", "--folder", str(own)]) == 0
    assert main(["release", "--notebooks", str(own), "--out", str(out)]) == 0
    released = (out / "gripper.ipynb").read_text()
    assert "raise NotImplementedError()" in released and "2 * deceleration" not in released
    assert (out / "checks" / "gripper.py").is_file() and "checks/gripper.py" in capsys.readouterr().out
    for name, answer in {"ann": RIGHT, "ben": HALF, "eva": "raise NotImplementedError()"}.items():
        handed_in(own, name, answer)
    table = tmp_path / "grades.csv"
    command = ["grade", str(tmp_path / "handed_in"), "--notebooks", str(own), "--out", str(table), "--allow-root"]
    assert main(command) == 0
    with open(table, newline="", encoding="utf-8-sig") as file:
        rows = {row["student"]: row for row in csv.DictReader(file)}
    assert {name: float(row["gripper.q1"]) for name, row in rows.items()} == {"ann": 2, "ben": 0, "eva": 0}


def test_a_check_in_the_notebook_finds_the_checks_of_its_course(tmp_path, monkeypatch, capsys):
    write_template(tmp_path, "arm_drill")
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path))
    for answer, told in ((HALF, "0 of 2 points"), (RIGHT, "2 of 2 points")):
        names = {}
        exec(answer, names)
        monkeypatch.setattr("coursekit.grade.checking._variables", lambda names=names: names)
        try:
            check("arm_drill.q1")
        except CheckFailed:
            assert answer == HALF
        assert told in capsys.readouterr().out


def test_a_file_of_checks_that_was_changed_is_read_again(tmp_path):
    write_template(tmp_path, "wheel_drill")
    file = tmp_path / "checks" / "wheel_drill.py"
    read_checks(file.parent)
    assert find("wheel_drill.q1").points == 2
    file.write_text(file.read_text().replace("points=2", "points=5"))
    read_checks(file.parent)
    assert find("wheel_drill.q1").points == 5


@pytest.mark.parametrize("text", ["def broken(:\n", "\n\nimport nothing_of_this_name\n"], ids=["syntax", "import"])
def test_a_file_of_checks_that_cannot_be_run_is_told_with_its_line(tmp_path, text):
    (tmp_path / "broken.py").write_text(text)
    with pytest.raises(BadChecks, match=rf"checks/broken\.py:{len(text.splitlines())} cannot be run"):
        read_checks(tmp_path)


def test_what_is_there_is_not_written_over(tmp_path):
    write_template(tmp_path, "base_drill")
    with pytest.raises(FileExistsError, match=r"base_drill\.ipynb, base_drill\.py exists"):
        write_template(tmp_path, "base_drill")
    with pytest.raises(ValueError, match="letters"):
        write_template(tmp_path, "my chapter")


@pytest.mark.parametrize(("answer", "blamed"), [
    (NONE, "check"), (HALF, "work"), (HALF.replace("speed /", "None /"), "work"),
    ("def stopping_distance(speed):\n    return speed\n", "work"), ("stopping_distance = 3\n", "work"),
])  # fmt: skip
def test_an_exception_of_the_check_is_not_told_as_the_student_s(tmp_path, answer, blamed):
    (tmp_path / "grip_drill.py").write_text(NAIVE)
    read_checks(tmp_path)
    names = {}
    exec(compile(answer, "/tmp/ipykernel_1/2.py", "exec"), names)
    verdict = judge(find("grip_drill.q1"), names, tmp_path)
    assert not verdict.passed and verdict.points == 0
    if blamed == "work":
        assert not verdict.fault and verdict.expected
        return
    assert "(grip_drill.py, line 7" in verdict.fault and "not to blame" in verdict.text() and not verdict.got
    assert "not judged" in verdict.text() and "not judged" in verdict.html() and "fault of the check" in verdict.html()


def test_a_check_that_stops_at_the_right_solution_stops_the_grader_and_is_named(tmp_path, capsys, monkeypatch):
    handed = tmp_path / "class"
    write(handed / "Ann" / TOPICS, text("q1", "q2"))

    def faulty(submission, *more):
        marked = cheap_mark(submission, *more)
        marked.verdicts[1] = replace(marked.verdicts[1], points=0, fault="NameError: x (c.py, line 7)")
        return marked

    monkeypatch.setattr("coursekit.grade.batch.mark", faulty)
    out = ["--out", str(tmp_path / "grades.csv")]
    assert main(["grade", str(handed), "--allow-root", "--unsafe", *out]) == 2
    said = capsys.readouterr().out
    assert "the check of ch02.q2 has a fault: NameError: x (c.py, line 7)." in said and "Mend the check first." in said


def test_a_check_s_own_fault_costs_nobody_points_and_the_teacher_is_told(tmp_path, capsys, monkeypatch):
    handed = tmp_path / "class"
    for name in ("Ann", "Ben"):
        write(handed / name / TOPICS, text("q1", "q2"))

    def faulty(submission, *more):
        marked = cheap_mark(submission, *more)
        if submission.student == "Ann":
            marked.verdicts[1] = replace(marked.verdicts[1], points=0, fault="TypeError: no (c.py, line 7)")
        return marked

    monkeypatch.setattr("coursekit.grade.batch.mark", faulty)
    status, rows_by_name = grade(handed)
    assert status == 1 and (rows_by_name["Ann"]["status"], rows_by_name["Ann"]["total"]) == ("not marked", "")
    assert rows_by_name["Ben"]["total"] == "3"
    said = capsys.readouterr().out
    assert "The check of ch02.q2 has a fault: TypeError: no (c.py, line 7). No mark yet: Ann." in said
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    assert grade(handed)[1]["Ann"]["total"] == "3", "nothing is kept of what a faulty check said"


PLAIN_SHELL = """
import json, sys
from IPython.core.interactiveshell import InteractiveShell
shell = InteractiveShell.instance()
for cell in json.load(open("claw.ipynb"))["cells"]:
    if cell["cell_type"] == "code":
        done = shell.run_cell("".join(cell["source"]))
        done.raise_error()
"""


def test_the_notebook_runs_in_a_kernel_that_is_not_ours(tmp_path):
    write_template(tmp_path, "claw")
    nb = json.loads((tmp_path / "claw.ipynb").read_text())
    assert len({cell["id"] for cell in nb["cells"]}) == len(nb["cells"])
    env = {name: value for name, value in os.environ.items() if not name.startswith("COURSEKIT")}
    env |= {"COURSEKIT_TIME": "virtual", "PYTHONUTF8": "1"}
    command = [sys.executable, "-c", PLAIN_SHELL]
    done = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, encoding="utf-8")
    assert done.returncode == 0 and "2 of 2 points" in done.stdout, done.stdout + done.stderr


def changed(folder, before, after):
    """The teacher's notebook with another text."""
    file = folder / "gripper.ipynb"
    text = file.read_text()
    assert before in text
    file.write_text(text.replace(before, after))


@pytest.fixture
def own(tmp_path):
    assert main(["new", "gripper", "--folder", str(tmp_path / "my_course")]) == 0
    return tmp_path / "my_course"


def released(own):
    return main(["release", "--notebooks", str(own), "--out", str(own.parent / "week2")])


def test_a_check_without_its_exercise_is_not_released(own):
    changed(own, "gripper.q1", "gripper.q7")
    with pytest.raises(SystemExit, match=r'gripper.ipynb has check\("gripper.q7"\), and there is no @exercise'):
        released(own)


def test_an_exercise_that_nobody_is_asked_for_is_told(own, capsys):
    file = own / "checks" / "gripper.py"
    file.write_text(file.read_text() + NAIVE.replace("grip_drill.q1", "gripper.q9"))
    assert released(own) == 0
    assert 'no notebook has check("gripper.q9")' in capsys.readouterr().err


def test_two_cells_of_one_name_are_not_released(own):
    nb = json.loads((own / "gripper.ipynb").read_text())
    nb["cells"].append(dict(next(cell for cell in nb["cells"] if "solution" in cell["metadata"].get("nbgrader", {}))))
    (own / "gripper.ipynb").write_text(json.dumps(nb))
    with pytest.raises(SystemExit, match="2 cells are called gripper-q1"):
        released(own)
