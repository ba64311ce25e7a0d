"""The pictures that the chapters' texts show: each is shown, described for those who do not see it, and safe to open."""

import re
from xml.etree import ElementTree

import pytest

from coursekit.grade.editions import languages, pictures_of, read

from .running import NOTEBOOKS, chapters

PICTURES = sorted((NOTEBOOKS / "images").iterdir())
SVG = "{http://www.w3.org/2000/svg}"


def test_every_picture_is_shown_by_a_chapter_and_every_lesson_has_one():
    shown = {chapter: pictures_of(read(chapter), NOTEBOOKS) for chapter in chapters()}
    assert {picture for pictures in shown.values() for picture in pictures} == set(PICTURES)
    assert [chapter.stem for chapter, pictures in shown.items() if not pictures] == ["A_commands", "D_your_own_ubuntu"]


@pytest.mark.parametrize("language", languages(NOTEBOOKS))
def test_a_picture_is_described_and_explained_in_words(language):
    for chapter in chapters():
        for cell in read(chapter, language)["cells"]:
            text = "".join(cell["source"])
            for words, rest in re.findall(r"!\[([^\]]*)\]\(images/[\w.-]+\)(.*)", text, re.S):
                assert len(words) > 20 and len(rest.strip()) > 80, text


@pytest.mark.parametrize("picture", PICTURES, ids=lambda one: one.stem)
def test_a_picture_runs_nothing_loads_nothing_and_has_a_title(picture):
    root = ElementTree.parse(picture).getroot()
    assert root.tag == f"{SVG}svg" and root.get("viewBox") == f"0 0 {root.get('width')} {root.get('height')}"
    assert root.findtext(f"{SVG}title")
    for part in root.iter():
        assert part.tag.removeprefix(SVG) not in ("script", "image", "foreignObject", "style", "a")
        assert not any(name.startswith("on") or name.endswith("href") for name in part.attrib)
