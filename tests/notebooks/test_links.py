"""Links in the chapters lead to other chapters, in both editions, and to documentation."""

import re

import pytest

from coursekit.grade.editions import languages, read

from .running import NOTEBOOKS, chapters

LINK = re.compile(r"(?<!`)\[[^\]\n]+\]\(([^)\s]+)\)")
CODE = re.compile(r"```.*?```|`[^`\n]*`", re.S)
EACH = pytest.mark.parametrize("chapter", chapters(), ids=lambda one: one.stem)


def links(chapter, language):
    cells = (cell for cell in read(chapter, language)["cells"] if cell["cell_type"] == "markdown")
    texts = (CODE.sub("`code`", "".join(cell["source"])) for cell in cells)
    return [link for text in texts for link in LINK.findall(text)]


@EACH
def test_links_lead_to_chapters_and_to_documentation(chapter):
    targets = links(chapter, "en")
    near = [link for link in targets if not link.startswith("https://")]
    assert near and all((NOTEBOOKS / link).is_file() and link != chapter.name for link in near), targets
    assert len(near) < len(targets) or chapter.stem == "10_a_real_robot", "what to read on"


@EACH
@pytest.mark.parametrize("language", languages(NOTEBOOKS)[1:])
def test_a_translation_has_the_same_links(chapter, language):
    assert sorted(links(chapter, language)) == sorted(links(chapter, "en"))
