"""`ament_copyright`, `ament_flake8` and `ament_pep257` in a terminal: what they tell, and their exit codes."""

import importlib.metadata
import importlib.util
import os
import xml.etree.ElementTree as ElementTree

import pytest

from coursekit.cli.linter_commands import copyright_notices, flake8, pep257

SAID = """node.py:1:4: E225 missing whitespace around operator
x =1
   ^
node.py:2:4: E225 missing whitespace around operator
y =2
   ^
node.py:3:1: F401 'os' imported but unused
import os
^
"""
REPORT = """
node.py:1:4: E225 missing whitespace around operator
x =1
   ^

node.py:2:4: E225 missing whitespace around operator
y =2
   ^

node.py:3:1: F401 'os' imported but unused
import os
^

2     E225 missing whitespace around operator
1     F401 'os' imported but unused

1 files checked
3 errors

'E'-type errors: 2
'F'-type errors: 1

Checked files:

* node.py
"""


@pytest.fixture
def linter(tmp_path, monkeypatch):
    """A folder with a node, and what the installed linter of a name says of it; it notes its arguments."""
    (tmp_path / "node.py").write_text("x =1\ny =2\nimport os\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path / "site"))
    monkeypatch.setenv("PYTHONPATH", str(tmp_path / "site"))

    def install(name, said, code):
        package = tmp_path / "site" / name
        package.mkdir(parents=True)
        (package / "__init__.py").touch()
        notes = f"open({str(tmp_path / 'told')!r}, 'w').write(' '.join(sys.argv[1:]))"
        (package / "__main__.py").write_text(f"import sys\n{notes}\nprint({said!r}, end='')\nsys.exit({code})\n")
        return tmp_path / "told"

    return install


def test_flake8_s_findings_are_told_counted_and_sorted(linter, capsys):
    linter("flake8", SAID, 1)
    assert flake8(["node.py"]) == 1
    assert capsys.readouterr().out == REPORT


def test_clean_files_have_no_problems(linter, capsys):
    told = linter("flake8", "", 0)
    assert flake8(["--linelength", "79", "--exclude", "old.py", "--", "node.py"]) == 0
    assert capsys.readouterr().out == "\n1 files checked\nNo problems found\n\nChecked files:\n\n* node.py\n"
    words = "--extend-exclude=build,install,log,old.py --max-line-length=79 node.py"
    assert told.read_text().endswith(f"ament_flake8.ini {words}")


def test_a_code_is_counted_with_the_words_of_its_first_file(linter, capsys, tmp_path):
    linter("flake8", "z.py:1:1: E302 expected 2 blank lines, found 0\na.py:1:1: E302 expected 2 blank lines, found 1\n", 1)
    assert flake8(["node.py"]) == 1
    assert "\n2     E302 expected 2 blank lines, found 1\n" in capsys.readouterr().out


def test_ignored_folders_are_not_looked_into(linter, capsys, tmp_path):
    told = linter("flake8", "", 0)
    (tmp_path / "old" / "deep").mkdir(parents=True)
    (tmp_path / "old" / "AMENT_IGNORE").touch()
    (tmp_path / "old" / "deep" / "x.py").touch()
    assert flake8(["old"]) == 0
    assert "\n0 files checked\n" in capsys.readouterr().out and told.read_text().endswith("build,install,log,old old")


def test_pep257_counts_its_errors(linter, capsys):
    linter("pydocstyle", "node.py:1 at module level:\n        D400: First line should end with a period\n", 1)
    assert pep257(["node.py"]) == 1
    said = capsys.readouterr()
    assert said.out == "checking node.py\n"
    assert said.err == "node.py:1 at module level: D400: First line should end with a period\n1 errors\n"


ROS = "D100,D101,D102,D103,D104,D105,D106,D107,D203,D212,D404"


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ([], f"--ignore={ROS}"),
        (["--add-ignore", "D400"], f"--ignore={ROS},D400"),
        (["--add-select", "D404"], f"--ignore={ROS.removesuffix(',D404')}"),
        (["--ignore", "D100", "D101"], "--ignore=D100,D101"),
        (["--select", "D403"], "--select=D403"),
        (["--convention", "google", "--add-ignore", "D100"], "--convention=google --add-ignore=D100"),
    ],
)
def test_pep257_looks_for_the_codes_that_are_asked_for(linter, capsys, words, told):
    noted = linter("pydocstyle", "", 0)
    assert pep257([*words, "--", "node.py"]) == 0
    assert noted.read_text() == f"{told} node.py"
    assert capsys.readouterr().out == "checking node.py\nNo problems found\n"


def test_pep257_leaves_out_what_is_excluded_and_what_is_hidden(linter, capsys, tmp_path):
    linter("pydocstyle", "", 0)
    for folder in (".hidden", "_build", "test"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "test_it.py").touch()
    assert pep257(["--exclude", "node.py", "--", ".", "test"]) == 0
    said = [line for line in capsys.readouterr().out.splitlines() if "site" not in line]
    files = [os.path.join(".", "test", "test_it.py"), os.path.join("test", "test_it.py")]
    assert said == [*(f"checking {file}" for file in files), "No problems found"]


@pytest.mark.parametrize(("run", "name"), [(flake8, "flake8"), (pep257, "pydocstyle")])
def test_a_linter_that_is_missing_is_told(run, name, monkeypatch, capsys):
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    assert run([]) == 1
    assert capsys.readouterr().err == f"{name} is not installed: `pip install {name}` brings it\n"


def test_files_without_a_notice_are_named(tmp_path, monkeypatch, capsys):
    (tmp_path / "node.py").write_text("x = 1\n")
    monkeypatch.chdir(tmp_path)
    assert copyright_notices([]) == 1
    assert capsys.readouterr().err == "node.py: could not find copyright notice\n1 errors, checked 1 files\n"


def test_results_are_those_that_colcon_counts(linter, capsys, tmp_path):
    linter("flake8", SAID, 1)
    linter("pydocstyle", "node.py:2 at module level:\n        D400: First line should end with a period\n", 1)
    file = tmp_path / "linted" / "x.xunit.xml"
    assert flake8(["--xunit-file", str(file), "node.py"]) == 1
    suite = ElementTree.parse(file).getroot()
    assert (suite.get("name"), suite.get("tests"), suite.get("failures")) == ("linted.x", "3", "3")
    first = suite.find("testcase")
    why = first.find("failure").get("message")
    assert (first.get("name"), why) == ("E225 (node.py:1:4)", "missing whitespace around operator:\nx =1\n")
    assert pep257(["--xunit-file", str(file), "node.py"]) == 1
    assert [case.get("name") for case in ElementTree.parse(file).iter("testcase")] == ["D400 (node.py:2)"]
    assert copyright_notices(["--xunit-file", str(file), "node.py"]) == 1
    assert [failure.get("message") for failure in ElementTree.parse(file).iter("failure")] == [
        "could not find copyright notice"
    ]


@pytest.mark.parametrize(("run", "name"), [(flake8, "flake8"), (pep257, "pydocstyle")])
def test_a_linter_that_is_missing_leaves_a_result_that_says_so(run, name, monkeypatch, tmp_path):
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    file = tmp_path / "x.xunit.xml"
    assert run(["--xunit-file", str(file)]) == 0
    suite = ElementTree.parse(file).getroot()
    assert (suite.get("tests"), suite.get("skipped")) == ("1", "1")
    assert suite.find("testcase/skipped").get("message") == f"{name} is not installed: `pip install {name}` brings it"


def test_they_are_commands():
    commands = {
        entry_point.name: entry_point.value for entry_point in importlib.metadata.entry_points(group="console_scripts")
    }
    for name, function in (("copyright", "copyright_notices"), ("flake8", "flake8"), ("pep257", "pep257")):
        assert commands[f"ament_{name}"] == f"coursekit.cli.linter_commands:{function}"
