"""What students get holds nothing of a solution, and nbgrader takes it."""

import ast
import csv
import json
import re
import zipfile
from pathlib import Path

import nbformat
import pytest

from coursekit.cli.coursekit import main
from coursekit.grade.identifying import Identifier
from coursekit.grade.platform_names import platform_name
from coursekit.grade.release import released
from coursekit.grade.roster import Roster
from coursekit.grade.variants import Variants

from .handed import TOPICS, cheap_mark, grade, write
from .test_identifying import LISTS

v3 = pytest.importorskip("nbgrader.nbgraderformat.v3", reason="NOT TESTED: the extra `nbgrader` is not installed")
NOTEBOOKS = sorted((Path(__file__).resolve().parents[2] / "notebooks").glob("*.ipynb"))
SOLUTION = re.compile(r"### BEGIN SOLUTION\n(.*?)### END SOLUTION", re.S)


def solutions(notebook):
    text = "\n".join("".join(cell["source"]) for cell in notebook["cells"])
    return [line.strip() for block in SOLUTION.findall(text) for line in block.splitlines() if len(line.strip()) > 25]


def structures(text):
    """The functions of a cell, as syntax trees without names."""
    try:
        tree = ast.parse(re.sub(r"^[%!].*$", "", text, flags=re.M))
    except SyntaxError:
        return set()
    functions = (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef) and len(node.body) > 2)
    return {re.sub(r"'[^']*'", "", ast.dump(node)) for node in functions}


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_a_release_has_no_solution_by_marker_text_or_structure(file):
    source = json.loads(file.read_text())
    nb = released(source)
    text = json.dumps(nb)
    assert "BEGIN SOLUTION" not in text and "BEGIN HIDDEN" not in text
    elsewhere = json.dumps([SOLUTION.sub("", "".join(cell["source"])) for cell in source["cells"]])
    lines = [json.dumps(line)[1:-1] for line in solutions(source)]
    assert not [line for line in lines if line in text and line not in elsewhere]
    blocks = [block for cell in source["cells"] for block in SOLUTION.findall("".join(cell["source"]))]
    own = {structure for block in blocks for structure in structures(block)}
    open_ = {structure for cell in source["cells"] for structure in structures(SOLUTION.sub("", "".join(cell["source"])))}
    given = {structure for cell in nb["cells"] for structure in structures("".join(cell["source"]))}
    assert not (own - open_) & given
    assert all(not cell.get("outputs") for cell in nb["cells"])


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_nbgrader_takes_the_metadata(file):
    for nb in (json.loads(file.read_text()), released(json.loads(file.read_text()))):
        notebook = nbformat.from_dict(nb)
        nbformat.validate(notebook)
        v3.MetadataValidatorV3().validate_nb(notebook)


def test_the_command_writes_folder_zip_and_page(tmp_path, capsys):
    assert main(["release", "02", "03", "--out", str(tmp_path / "week2")]) == 0
    said = capsys.readouterr().out.splitlines()
    names = ["02_topics.ipynb", "03_services.ipynb", "week2.zip", "page.html"]
    assert said[:4] == [(tmp_path / "week2" / name).as_posix() for name in names]
    assert "--wheel ADDRESS" in said[4] and "teachers.md" in said[5]
    with zipfile.ZipFile(tmp_path / "week2" / "week2.zip") as packed:
        pictures = [f"week2/images/{name}.svg" for name in ("workspace", "deadlock")]
        assert packed.namelist() == ["week2/02_topics.ipynb", "week2/03_services.ipynb", *pictures]
        assert packed.read(pictures[0]) == (NOTEBOOKS[0].parent / "images" / "workspace.svg").read_bytes()
    page = (tmp_path / "week2" / "page.html").read_text()
    assert "<td>02_topics</td><td>4</td><td>7</td>" in page and "<th>All</th><th>8</th><th>14</th>" in page
    assert "evidence()" in page and "in a new cell at the end of the notebook" in page
    assert "pip install ADDRESS-OF-THE-WHEEL" in (tmp_path / "week2" / "page.html").read_text()
    address = "https://uni.example/coursekit.whl?a=1&b=2"
    assert main(["release", "02", "--out", str(tmp_path / "week3"), "--wheel", address]) == 0
    page = (tmp_path / "week3" / "page.html").read_text()
    assert page.count("pip install https://uni.example/coursekit.whl?a=1&amp;b=2") == 2 and "ros-env\\Scripts\\pip" in page
    with pytest.raises(SystemExit, match="No chapter begins with 77"):
        main(["release", "77", "--out", str(tmp_path)])


def test_a_list_says_whose_is_which_copy(tmp_path):
    write(tmp_path / "roster.csv", LISTS["plain.csv"])
    assert main(["release", "02", "--roster", str(tmp_path / "roster.csv"), "--out", str(tmp_path / "week2")]) == 0
    with open(tmp_path / "week2" / "copies.csv", newline="", encoding="utf-8-sig") as file:
        records = list(csv.DictReader(file, delimiter=";"))  # as the list
    assert [(record["email"], record["id"], record["file"]) for record in records] == [
        ("ana@uni.example", "a01", "AnaGarcíaLópez.zip"), ("ben@uni.example", "a02", "BenIto.zip"),
    ]  # fmt: skip
    assert all((tmp_path / "week2" / record["file"]).is_file() for record in records)


def test_moodle_deals_out_each_copy_to_the_student_whose_it_is(tmp_path):
    worksheet = write(tmp_path / "worksheet.csv", LISTS["moodle.csv"])
    command = ["release", "02", "--roster", str(worksheet), "--out", str(tmp_path / "week2"), "--for", "moodle"]
    assert main(command) == 0
    people, marks = Roster.read(worksheet), set()
    with zipfile.ZipFile(tmp_path / "week2" / "moodle.zip") as packed:
        assert len(packed.namelist()) == 2
        for name in packed.namelist():
            folder, file = name.split("/")
            fields = name.split("_", 4)  # as Moodle reads it: name, number, kind, plugin, file
            (person,) = Identifier(people).by_name(folder).people
            assert fields[1] == person.number == platform_name(folder).number and fields[2:4] == ["assignsubmission", "file"]
            with zipfile.ZipFile(packed.open(name)) as own:
                assert "week2/images/workspace.svg" in own.namelist()
                marks.add((person.name, json.loads(own.read(f"week2/{TOPICS}"))["metadata"]["coursekit"]["copy"]))
            assert file.endswith(".zip")
    known = Variants.read(worksheet).copy_marks()
    assert {(known[mark].name, mark) for _, mark in marks} == marks


def test_moodle_s_zip_needs_moodle_s_numbers(tmp_path):
    plain = write(tmp_path / "roster.csv", LISTS["plain.csv"])
    for words, why in ((["--roster", str(plain)], "grading worksheet"), ([], "give the class as --roster")):
        with pytest.raises(SystemExit, match=why):
            main(["release", "02", "--out", str(tmp_path / "week2"), "--for", "moodle", *words])


def test_a_list_without_the_secret_of_the_release_is_told(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    write(tmp_path / "roster.csv", LISTS["plain.csv"])
    write(tmp_path / "other.csv", LISTS["plain.csv"])
    main(["release", "02", "--roster", str(tmp_path / "roster.csv"), "--out", str(tmp_path / "week2")])
    write(tmp_path / "class" / "Ben Ito" / TOPICS, (tmp_path / "week2" / "BenIto" / TOPICS).read_bytes())
    capsys.readouterr()
    for name, told in (("other.csv", True), ("roster.csv", False)):
        grade(tmp_path / "class", "--roster", tmp_path / name)
        assert (".secret of the list" in capsys.readouterr().out) == told
