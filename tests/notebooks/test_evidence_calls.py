"""The practice assignments make the pictures that they ask for, under the names that the original course uses."""

import json
import re

import pytest

from .running import ONLY_TO_READ, chapters

PRACTICES = [path for path in chapters() if path.stem[0].isdigit() and path.stem not in ONLY_TO_READ]


@pytest.mark.parametrize("chapter", PRACTICES, ids=lambda path: path.stem)
def test_a_practice_makes_the_evidence_that_it_names(chapter):
    cells = json.loads(chapter.read_text(encoding="utf-8"))["cells"]
    kinds = ("markdown", "code")
    texts = {kind: "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == kind) for kind in kinds}
    number = int(chapter.stem[:2])
    asked = set(re.findall(rf"(?:_evidence|`\.\.\.)_s({number}(?:_\d)?)\b", texts["markdown"]))
    evidence_numbers = set(re.findall(r'^evidence\("s(\d+(?:_\d)?)', texts["code"], re.M))
    assert evidence_numbers and asked | {min(evidence_numbers)} <= evidence_numbers
    assert {number_text.partition("_")[0] for number_text in evidence_numbers} == {str(number)}
    assert "```python\nevidence" not in texts["markdown"]
