"""A test of ctest's leaves a result whatever happens to it."""

import os
import sys
from xml.etree.ElementTree import parse

import pytest

from coursekit.packages.run_test import main

GOOD = '<testsuite tests="1"><testcase classname="Bad.a" name="x"/><testcase classname="pkg.b" name="y"/></testsuite>'


@pytest.fixture
def run(tmp_path):
    """run("python code", "--word", ...): the code, and the result's counts and text."""

    def go(code: str, *words: str):
        result = tmp_path / "results" / "it.gtest.xml"
        script = f"import os, sys; result = sys.argv[1]\n{code}"
        ended = main([str(result), "--package-name", "pkg", *words, "--command", sys.executable, "-c", script, str(result)])
        return ended, parse(result).getroot()

    return go


def counts(root):
    return {name: int(root.get(name, 0)) for name in ("failures", "errors", "skipped") if int(root.get(name, 0))}


@pytest.mark.parametrize(
    ("code", "words", "ended", "expected"),
    [
        ("", [], 1, {"errors": 1}),
        ("", ["--generate-result-on-success"], 0, {}),
        ("sys.exit(3)", ["--generate-result-on-success"], 3, {"errors": 1}),
        ("os.unlink(result)", [], 1, {"errors": 1}),
        ("sys.exit(77)", ["--skip-return-code", "77"], 77, {"skipped": 1}),
        ("sys.exit(5)", ["--skip-test"], 0, {"skipped": 1}),
    ],
)
def test_without_a_result_of_its_own_one_is_written(run, code, words, ended, expected):
    code, root = run(code, *words)
    assert (code, counts(root)) == (ended, expected)
    assert root.find("testcase").get("name") == "it.gtest.missing_result"


def test_a_result_of_its_own_stays_and_has_the_package_s_name(run):
    code, root = run(f"open(result, 'w').write({GOOD!r}); sys.exit(1)")
    assert code == 1 and [case.get("classname") for case in root] == ["pkg.Bad.a", "pkg.b"]


def test_words_of_the_command_are_its_own(tmp_path):
    code = "import sys; sys.exit(sys.argv[1:] != ['--ros-args', '-p', 'a:=1', '--', '--env'])"
    command = [sys.executable, "-c", code, "--ros-args", "-p", "a:=1", "--", "--env"]
    assert main([str(tmp_path / "it.xml"), "--generate-result-on-success", "--command", *command]) == 0


def test_its_environment_is_what_was_asked_for(run, tmp_path, monkeypatch):
    monkeypatch.setenv("PLACES", "/first")
    kept = tmp_path / "out" / "said.txt"
    words = ["--output-file", str(kept), "--env", "WORD=a=b", "--append-env", "PLACES=/second"]
    run("print(os.environ['WORD'], os.environ['PLACES'])", *words)
    assert kept.read_text().split() == ["a=b", os.pathsep.join(["/first", "/second"])]


def test_a_command_that_is_not_there_is_an_error(tmp_path, capsys):
    result = tmp_path / "it.xml"
    assert main([str(result), "--package-name", "pkg", "--command", str(tmp_path / "nobody")]) == 1
    assert counts(parse(result).getroot()) == {"errors": 1} and "nobody" in capsys.readouterr().out
