"""Whatever students write, and whatever they call their files, harms no table, no terminal and no other student."""

import json

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as some

from coursekit.grade.recognising import Recogniser, parse_notebook
from coursekit.grade.sanitizing import cell, lines, name_of_files, shown
from tests.needs import posix

from .handed import SOURCES, TOPICS, collected, notebook, text, write


@settings(max_examples=150)
@given(some.text(max_size=60))
def test_no_text_of_a_student_s_is_a_formula_or_moves_a_terminal(said):
    for shown_text in (shown(said), cell(said), lines(said)):
        assert not [
            character
            for character in shown_text
            if (ord(character) < 32 and character != "\n") or character in "\x7f\u202a\u202b\u202e\u2066\u2069\u200f"
        ]
        shown_text.encode("utf-8")
    for separator in ';,"|\t':
        for part in cell(said).split(separator):
            assert not part.lstrip(" '\u00a0").startswith(("=", "+", "-", "@")) or part.lstrip(" \u00a0").startswith("'"), (
                part
            )


@settings(max_examples=150)
@given(some.text(max_size=40), some.text(max_size=40))
def test_names_of_files_are_plain_and_differ(one, other):
    name = name_of_files(one)
    assert name.isascii() and len(name) < 60 and name == name.casefold() and not set('/\\:*?"<>|. ') & set(name)
    assert (name == name_of_files(other)) == (one == other)


words = some.sampled_from(["cell_type", "source", "metadata", "nbgrader", "grade_id", "coursekit", "given", "copy"])
values = some.recursive(
    some.none() | some.booleans() | some.integers() | some.floats() | some.text(max_size=8),
    lambda inner: some.lists(inner, max_size=3) | some.dictionaries(words, inner, max_size=4),
    max_leaves=12,
)


@settings(max_examples=150)
@given(some.lists(values, max_size=5), values)
def test_any_json_with_cells_can_be_recognised(cells, metadata):
    data = json.dumps({"cells": cells, "metadata": metadata}).encode()
    Recogniser(SOURCES).recognise(parse_notebook(data, "x.ipynb"))
    known = notebook("q1")
    known["cells"] += cells
    known["metadata"] = metadata
    recognised = Recogniser(SOURCES).recognise(parse_notebook(json.dumps(known).encode(), "x.ipynb"))
    assert recognised.chapter == TOPICS and "ch02.q1" in recognised.begun


@posix("most of these are no names there")
@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(some.lists(some.text(some.characters(exclude_characters="\0/", exclude_categories=["Cs"]), min_size=1, max_size=30),
                  min_size=1, max_size=6))  # fmt: skip
def test_whatever_students_call_their_files_each_gets_a_row(tmp_path_factory, names):
    base = tmp_path_factory.mktemp("names")
    written = 0
    for name in names:
        try:
            write(base / "class" / name / f"{name}.ipynb", text("q1"))
            written += not name.startswith(".") and name not in ("__MACOSX",)
        except (OSError, ValueError):  # a name that this file system does not take
            continue
    if written:
        collection = collected(base / "class", base / "s")
        assert 1 <= len(collection.handed) + len(collection.whose) <= written
        assert len({handed.key for handed in collection.handed}) == len(collection.handed)
