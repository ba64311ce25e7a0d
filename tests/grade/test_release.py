"""What students get holds nothing of a solution, and nbgrader takes it."""

import ast
import json
import re
import zipfile
from pathlib import Path

import nbformat
import pytest
from nbgrader.nbgraderformat.v3 import MetadataValidatorV3

from coursekit.cli.coursekit import main
from coursekit.grade.release import released

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
    found = (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef) and len(node.body) > 2)
    return {re.sub(r"'[^']*'", "", ast.dump(node)) for node in found}


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_a_release_has_no_solution_by_marker_text_or_structure(file):
    source = json.loads(file.read_text())
    made = released(source)
    text = json.dumps(made)
    assert "BEGIN SOLUTION" not in text and "BEGIN HIDDEN" not in text
    elsewhere = json.dumps([SOLUTION.sub("", "".join(cell["source"])) for cell in source["cells"]])
    lines = [json.dumps(line)[1:-1] for line in solutions(source)]
    assert not [line for line in lines if line in text and line not in elsewhere]
    blocks = [block for cell in source["cells"] for block in SOLUTION.findall("".join(cell["source"]))]
    own = {one for block in blocks for one in structures(block)}
    open_ = {one for cell in source["cells"] for one in structures(SOLUTION.sub("", "".join(cell["source"])))}
    given = {one for cell in made["cells"] for one in structures("".join(cell["source"]))}
    assert not (own - open_) & given
    assert all(not cell.get("outputs") for cell in made["cells"])


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_nbgrader_takes_the_metadata(file):
    for made in (json.loads(file.read_text()), released(json.loads(file.read_text()))):
        notebook = nbformat.from_dict(made)
        nbformat.validate(notebook)
        MetadataValidatorV3().validate_nb(notebook)


def test_the_command_writes_folder_zip_and_page(tmp_path, capsys):
    assert main(["release", "02", "03", "--out", str(tmp_path / "week2")]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[:4] == ["02_topics.ipynb", "03_services.ipynb", "week2.zip", "page.html"]
    assert "--wheel ADDRESS" in said[4] and "teachers.md" in said[5]
    with zipfile.ZipFile(tmp_path / "week2" / "week2.zip") as packed:
        assert packed.namelist() == ["week2/02_topics.ipynb", "week2/03_services.ipynb"]
    assert "<td>02_topics</td><td>4</td><td>7</td>" in (tmp_path / "week2" / "page.html").read_text()
    assert "pip install ADDRESS-OF-THE-WHEEL" in (tmp_path / "week2" / "page.html").read_text()
    address = "https://uni.example/coursekit.whl?a=1&b=2"
    assert main(["release", "02", "--out", str(tmp_path / "week3"), "--wheel", address]) == 0
    page = (tmp_path / "week3" / "page.html").read_text()
    assert page.count("pip install https://uni.example/coursekit.whl?a=1&amp;b=2") == 2 and "ros-env\\Scripts\\pip" in page
    with pytest.raises(SystemExit, match="No chapter begins with 77"):
        main(["release", "77", "--out", str(tmp_path)])
