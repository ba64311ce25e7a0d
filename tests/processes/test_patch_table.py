"""The table of patches is whole, and its document says the same."""

from pathlib import Path

from coursekit.processes.patching import GROUPS, KERNEL
from tests.processes.patch_table import DOCUMENT, document, rows

ROOT = Path(__file__).parents[2]


def test_each_row_names_a_test_that_there_is_and_a_group():
    for row in rows():
        assert (ROOT / row.test).is_file(), row
        assert row.group in (*GROUPS, KERNEL) and row.reason and row.versions


def test_the_document_is_current():
    assert DOCUMENT.read_text(encoding="utf-8") == document(), "write it anew: python -m tests.processes.patch_table"


def test_no_target_has_two_rows():
    targets = [row.target for row in rows()]
    assert len(targets) == len(set(targets))
