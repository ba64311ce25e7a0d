"""The course to read: pages of every chapter in every language, a search, and no solution anywhere."""

import json

import pytest

from coursekit.building import web
from coursekit.grade.copy import student_notebook
from coursekit.grade.editions import chapters, notebooks_folder, read

SOURCES = chapters(notebooks_folder())


def code(source, text="", **metadata):
    outputs = [{"output_type": "stream", "name": "stdout", "text": [text]}] if text else []
    return {"cell_type": "code", "source": [source], "metadata": metadata, "outputs": outputs, "execution_count": 1}


def outputs_of(*cells):
    return [len(cell["outputs"]) for cell in web.web_notebook({"cells": list(cells), "metadata": {}})["cells"]]


def test_outputs_stay_but_for_those_of_answers_and_those_that_show_one():
    answer = code("### BEGIN SOLUTION\nfloat64 radius\n### END SOLUTION", "done", nbgrader={"solution": True})
    assert outputs_of(answer, code("look()", "a sphere\n"), code("show()", "first\n  float64 radius\n")) == [0, 1, 0]


def test_pictures_and_texts_stand_for_widgets():
    data = {web.WIDGET: {"model_id": "1"}, "image/png": "...", "text/plain": ["viewer"]}
    cell = {**code("view"), "outputs": [{"output_type": "execute_result", "metadata": {}, "data": data}]}
    output = web.web_notebook({"cells": [cell], "metadata": {}})["cells"][0]["outputs"][0]
    assert set(output["data"]) == {"image/png", "text/plain"} and web.WIDGET in data, "the chapter itself keeps it"


@pytest.mark.parametrize("chapter", SOURCES, ids=lambda path: path.stem)
def test_no_line_of_a_solution_is_on_a_page(chapter):
    notebook = read(chapter)
    secret = {line for line in web._lines(notebook) - web._lines(student_notebook(notebook)) if "SOLUTION" not in line}
    page = web.web_notebook(notebook)
    shown = {line.strip() for text in _texts(page) for line in text.splitlines()}
    assert not secret & shown and "SOLUTION" not in json.dumps(page)


def _texts(notebook):
    for cell in notebook["cells"]:
        yield "".join(cell["source"])
        for output in cell.get("outputs", []):
            yield "".join(output.get("text", ""))
            yield from ("".join(text) for kind, text in output.get("data", {}).items() if kind.startswith("text/"))


def test_a_folder_has_to_be_named(capsys):
    assert web.main([]) == 2 and "Name a folder" in capsys.readouterr().err


def test_the_pages_are_built_without_a_warning_and_can_be_searched(tmp_path):
    pytest.importorskip("myst_nb", reason='NOT TESTED: the pages need pip install "coursekit[docs]" (`make web` does that)')
    assert web.main([str(tmp_path)]) == 0
    for language in ("", "es"):
        pages = {path.stem for path in (tmp_path / language).glob("*.html")}
        assert {path.stem for path in SOURCES} <= pages and {"index", "search"} <= pages
        assert "costmap" in (tmp_path / language / "searchindex.js").read_text()
    assert 'href="es/index.html"' in (tmp_path / "index.html").read_text()
    assert 'href="../index.html"' in (tmp_path / "es" / "index.html").read_text()
    assert "<img" in (tmp_path / "08_maps_and_slam.html").read_text()
