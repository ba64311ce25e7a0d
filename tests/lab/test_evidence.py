"""Evidence and handing in, in a kernel without a browser."""

import json

import nbformat
import pytest

from coursekit.grade.bundle import bundle_faults, read_bundle
from coursekit.grade.student_name import kept_name
from coursekit.lab.handing_in import _expect_saved, _notebook, evidence

from ..notebooks.running import run

CELLS = [
    "from coursekit.lab import *",
    "%ros2 run demo_nodes_py talker &",
    "wait(2.1)",
    'evidence("s1", graph(), terminal("talker"), by="Vera de la Course")',
    'evidence("s1_2.pdf", "my own words")',
    'me = "x"\n### nothing\nprint(evidence("s1_3", turtlesim_window.__name__))',
]


@pytest.fixture
def book(tmp_path):
    """Runs cells as a notebook that lies saved in the course's folder."""

    def book(*texts):
        notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in texts])
        nbformat.write(notebook, tmp_path / "mine.ipynb")
        return notebook

    return book


@pytest.mark.timeout(240)
def test_evidence_is_written_and_handed_in(book, tmp_path):
    check = nbformat.v4.new_code_cell('check("ch00.q1")')
    notebook = book(*CELLS, 'me = "Vera Course"', check.source, 'done = hand_in("mine.ipynb")\nprint(done)')
    run(notebook, tmp_path)
    pictures = {file.name: file.read_bytes() for file in (tmp_path / "evidence").iterdir()}
    assert set(pictures) == {f"VeraDeLaCourse_evidence_{name}" for name in ("s1.png", "s1_2.pdf", "s1_3.png")}
    assert pictures["VeraDeLaCourse_evidence_s1.png"].startswith(b"\x89PNG")
    assert pictures["VeraDeLaCourse_evidence_s1_2.pdf"].startswith(b"%PDF")
    text = notebook.cells[-1].outputs[0]["text"]
    assert text.startswith("Hand in: VeraDeLaCourse_mine.zip (1 of 1 points in a clean run)"), text
    data = (tmp_path / "VeraDeLaCourse_mine.zip").read_bytes()
    manifest, files = read_bundle(data)
    assert bundle_faults(data) == [] and manifest["student"] == "Vera de la Course"
    assert [json.loads(line)["event"] for line in files["events.jsonl"].decode().splitlines()] == [
        "evidence", "evidence", "evidence", "check", "hand_in",
    ]  # fmt: skip


SOLVED = ["from coursekit.lab import *", 'me = "Vera Curse"', 'check("ch00.q1")', 'me = "Vera Course"', 'check("ch00.q1")']
LATER = ["from coursekit.lab import *", 'evidence("s1", "words")', 'evidence("s1", "words", by="Ann Lee")']


@pytest.mark.timeout(240)
def test_after_a_restart_evidence_knows_the_name_of_exercise_1(book, tmp_path):
    run(book(*SOLVED), tmp_path / "course", student="")
    run(book(*LATER), tmp_path / "course", student="")
    pictures = {file.name for file in (tmp_path / "course/evidence").iterdir()}
    assert pictures == {"VeraCourse_evidence_s1.png", "AnnLee_evidence_s1.png"}
    run(book(*SOLVED), tmp_path / "course", student="")
    assert kept_name(tmp_path / "course/.coursekit") == "Ann Lee"


def test_a_notebook_that_is_not_saved_is_not_handed_in(tmp_path, monkeypatch):
    cells = [nbformat.v4.new_code_cell("a = 1", id="one"), nbformat.v4.new_code_cell("hand_in()", id="two")]
    file = tmp_path / "mine.ipynb"
    nbformat.write(nbformat.v4.new_notebook(cells=cells), file)
    for ran in ({"one": "a = 2", "two": "hand_in()"}, {"one": "a = 1", "new": "hand_in()"}):
        monkeypatch.setattr("coursekit.lab.handing_in.last_runs", lambda ran=ran: ran)
        with pytest.raises(RuntimeError, match=r"press Ctrl\+S"):
            _expect_saved(file)
    for ran in ({}, {"one": "a = 1 ", "two": "hand_in()"}, {"deleted": "b", "two": "hand_in()"}):
        monkeypatch.setattr("coursekit.lab.handing_in.last_runs", lambda ran=ran: ran)
        _expect_saved(file)


def test_the_notebook_is_found_or_those_that_there_are_are_named(tmp_path, monkeypatch):
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("JPY_SESSION_NAME", raising=False)
    (tmp_path / "a.ipynb").touch()
    assert _notebook("").name == "a.ipynb"
    (tmp_path / "b.ipynb").touch()
    with pytest.raises(FileNotFoundError, match="There are: a.ipynb, b.ipynb"):
        _notebook("")
    monkeypatch.setenv("JPY_SESSION_NAME", "b.ipynb")
    assert _notebook("").name == "b.ipynb" and _notebook("a.ipynb").name == "a.ipynb"


def test_wrong_names_of_evidence_and_nobody_s_name_are_told(tmp_path, monkeypatch):
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path))
    with pytest.raises(ValueError, match="Give the name"):
        evidence("picture", "text")
    with pytest.raises(ValueError, match="Whose is it"):
        evidence("s1", "text")
    with pytest.raises(ValueError, match='by="Vera -"'):
        evidence("s1", "text", by="Vera")
