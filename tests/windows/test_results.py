"""What pytest writes about a piece is told with each failure and the reasons of what was skipped."""

import subprocess
import sys

import pytest

from tests.windows import pieces, results, wine

TESTS = """
import pytest
def test_right(): pass
def test_wrong(): assert False
@pytest.fixture
def broken(): raise OSError
def test_begun(broken): pass
@pytest.mark.parametrize("n", range(3))
def test_left(n): pytest.skip("Windows: it has none")
@pytest.mark.skipif(True, reason="slow here")
def test_also(): pass
"""


@pytest.fixture
def ran(tmp_path, monkeypatch):
    """A piece that pytest has run."""
    monkeypatch.setattr(results, "FOLDER", tmp_path)
    results.forget(["some room"])
    (tmp_path / "test_some.py").write_text(TESTS, encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", f"--junitxml={results.file_of('some room')}"]
    subprocess.run([*command, "test_some.py"], cwd=tmp_path, stdout=subprocess.DEVNULL, check=False)
    return results.read("some room")


def test_each_test_is_counted_once_and_reasons_together(ran):
    assert (ran.passed, ran.failed) == (1, ("test_some::test_begun", "test_some::test_wrong"))
    assert ran.skipped == {"Windows: it has none": 3, "slow here": 1}
    assert "1 of 7 passed, 2 failed, 4 skipped" in str(ran) and "3 skipped: Windows: it has none" in str(ran)


def test_a_piece_that_was_ended_is_not_told_by_what_an_earlier_run_wrote(ran):
    results.forget(["some room"])
    assert results.table(["some room"]).endswith(results.NOT_ENDED)


def test_every_chapter_and_every_folder_of_tests_is_a_piece():
    names = [piece.name for piece in pieces.everything()]
    wanted = {"chapter 0", "chapter 9", "chapter D", "JupyterLab", "core", "cli, slow", "docstrings", "files"}
    assert wanted <= set(names)
    assert not {"benchmarks", "browser", "fixtures"} & set(names)


def test_each_notebook_is_a_chapter_by_its_number_or_letter():
    files = {path for name in pieces.EVERY_CHAPTER for path in pieces.chapter(name).paths}
    assert files == {f"notebooks/{path.name}" for path in (wine.ROOT / "notebooks").glob("*.ipynb")}
    assert [piece.name for piece in pieces.named(["chapter 10", "chapter 1"])] == ["chapter 10", "chapter 1"]


def test_a_piece_that_there_is_not_is_told_with_those_that_there_are():
    assert [piece.name for piece in pieces.named(["cli", "chapter 8"])] == ["cli", "chapter 8"]
    with pytest.raises(SystemExit, match=r"There is no piece chapter 77; there are: chapter 0, .*cli"):
        pieces.named(["chapter 77"])
