"""The linters that packages' own tests call look at what Humble's look at."""

from pathlib import Path

import pytest
from ament_copyright.main import main

NOTICE = "# Copyright 2020 Vera Course\n"


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package whose sources have their notice, and a setup.py that has none."""
    for name, text in {"package.xml": "<package/>", "setup.py": "x = 1\n", "a/node.py": NOTICE, "a/__init__.py": ""}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_setup_py_beside_package_xml_needs_no_notice(package, capsys):
    assert main([".", "a"]) == 0
    assert capsys.readouterr().out == "No errors, checked 2 files\n"


def test_setup_py_elsewhere_needs_one(package, capsys):
    (package / "a" / "setup.py").write_text("x = 1\n")
    assert main(argv=["."]) == 1
    said = capsys.readouterr()
    assert said.err == f"{Path('a/setup.py')}: could not find copyright notice\n"
    assert said.out == "1 errors, checked 3 files\n"


@pytest.mark.parametrize("folder", ["_build", ".hidden", "ignored"])
def test_hidden_and_ignored_folders_are_not_looked_into(package, folder):
    (package / folder / "deep").mkdir(parents=True)
    (package / folder / "deep" / "x.py").write_text("x = 1\n")
    assert main(argv=["."]) == int(folder == "ignored")
    (package / folder / "AMENT_IGNORE").touch()
    assert main(argv=["."]) == 0


def test_a_file_that_is_named_is_looked_at(package):
    assert main(["setup.py"]) == 1 and main(["a/node.py"]) == 0
