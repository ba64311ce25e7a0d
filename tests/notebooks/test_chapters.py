"""How a chapter is written: its exercises, its first cell, its length."""

import pytest

from .running import ONLY_TO_READ, chapters, code_cells, exercises_of, read


@pytest.fixture(params=chapters(), ids=lambda path: path.stem)
def chapter(request):
    return request.param


def test_every_exercise_of_a_chapter_is_checked_in_it(chapter):
    sources = [cell.source for cell in code_cells(read(chapter))]
    checked = {source.split('"')[1] for source in sources if source.startswith("check(")}
    assert checked == set(exercises_of(chapter)) and (len(checked) >= 3 or chapter.stem in ONLY_TO_READ)


def test_a_chapter_begins_with_what_every_kernel_of_the_lab_has_anyway(chapter):
    """So nothing is missing after a restart, whichever cell is run first."""
    assert code_cells(read(chapter))[0].source == "from coursekit.lab import *\n\nreset()"


@pytest.mark.parametrize("section", ["Break it", "On a real robot", "Practice", "What is called what"])
@pytest.mark.parametrize("lesson", [path for path in chapters() if path.stem[0] == "0"], ids=lambda path: path.stem)
def test_a_lesson_has_its_sections(lesson, section):
    texts = [cell.source for cell in read(lesson).cells if cell.cell_type == "markdown"]
    assert any(line.startswith(f"## {section}") for text in texts for line in text.splitlines())


def test_a_package_is_made_in_the_workspace_also_after_a_restart(chapter):
    for cell in code_cells(read(chapter)):
        above, command, _ = cell.source.partition("%ros2 pkg create")
        there = "%cd -q {workspace()}" in above or "--destination-directory {workspace()}/src" in cell.source
        assert not command or there, cell.source


def test_the_magic_of_a_whole_cell_is_its_first_line(chapter):
    for cell in code_cells(read(chapter)):
        assert not any(line.startswith("%%") for line in cell.source.splitlines()[1:]), cell.source


def test_a_chapter_is_short_to_read_and_every_section_is_compared(chapter):
    notebook = read(chapter)
    section, compared = "", {}
    for cell in notebook.cells:
        if cell.cell_type == "markdown" and cell.source.startswith("## "):
            section = cell.source.splitlines()[0]
            compared.setdefault(section, None)
        elif cell.cell_type == "code" and cell.source.strip():
            assert len(cell.source.splitlines()) <= 15, cell.source
            compared[section] = bool(compared.get(section)) or bool(cell.outputs)
    compared.pop("", None)  # the lines above the first section
    assert not [name for name, done in compared.items() if done is False]


def test_files_of_the_workspace_are_added_to_by_write_which_keeps_its_parts(chapter):
    """What a cell appends by itself is lost when the cell that begins the file is run again."""
    for cell in code_cells(read(chapter)):
        assert '"a")' not in cell.source, cell.source
