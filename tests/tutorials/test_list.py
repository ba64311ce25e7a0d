"""docs/tutorials.md names tests that exist, and every test of this folder is named there."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
LIST = (ROOT / "docs" / "tutorials.md").read_text(encoding="utf-8")
ROWS = [line for line in LIST.splitlines() if line.startswith("| ") and not line.startswith("| page")]


def defined(path):
    """The tests that a file defines."""
    return set(re.findall(r"^def (test_\w+)", path.read_text(encoding="utf-8"), re.M))


OURS = {name for path in HERE.glob("test_*.py") if path.name != "test_list.py" for name in defined(path)}
NAMED = sorted(set(re.findall(r"`(tests/[\w/.:]+|test_\w+)`", LIST)))


@pytest.mark.parametrize("name", NAMED)
def test_a_named_test_exists(name):
    path, _, function = name.partition("::")
    if not path.startswith("tests/"):
        assert path in OURS
    else:
        assert (ROOT / path).exists() and (not function or function in defined(ROOT / path))


def test_every_page_that_runs_has_its_test():
    assert len(ROWS) > 50
    for row in ROWS:
        _, page, printed, tests, _ = (cell.strip() for cell in row.split("|"))
        assert page and printed and (tests or printed.startswith("no")), row


def test_every_test_of_this_folder_stands_in_the_list():
    assert set(NAMED) >= OURS
