"""The page for teachers: it is in what is installed, and what it shows works."""

import re
from pathlib import Path

import pytest

from coursekit.cli.coursekit import main
from coursekit.cli.grading import teachers_page
from coursekit.grade.identifying import Identifier
from coursekit.grade.lateness import read_policy
from coursekit.grade.roster import Person, Roster
from coursekit.grade.statuses import STATUSES

from .handed import WALLS

PAGE = Path(__file__).resolve().parents[2] / "docs" / "teachers.md"
TEXT = PAGE.read_text(encoding="utf-8")
BEN = Person("Ben Ito", id="a02345", email="ben@uni.example", family="Ito", given="Ben", login="ben")


def test_the_command_prints_it(capsys):
    assert teachers_page() == PAGE and main(["teachers"]) == 0
    assert capsys.readouterr().out.strip() == TEXT.strip()


def test_its_policy_can_be_read(tmp_path):
    (block,) = re.findall(r"```toml\n(.*?)```", TEXT, re.S)
    (tmp_path / "policy.toml").write_text(block)
    policy = read_policy(tmp_path / "policy.toml", Roster([BEN, Person("Ann Lee", id="a01234")]))
    assert policy.percent_per_day == 10 and policy.days_more == {"a02345": 3.0} and list(policy.extensions) == ["a01234"]


def test_the_names_that_it_shows_are_known_and_every_status_stands_there():
    names = re.findall(r"`([^`]*(?:assignsubmission|_14_15_|attempt| - )[^`]*)`", TEXT)
    assert len(names) == 4
    assert all(Identifier(Roster([BEN, "Ann Lee"])).by_name(name).people == (BEN,) for name in names)
    assert all(status in TEXT for status in STATUSES)


def test_every_word_of_a_command_that_it_shows_is_one(capsys):
    for command in ("lab", "release", "grade", "verify"):
        with pytest.raises(SystemExit):
            main([command, "--help"])
    known = set(re.findall(r"--[a-z][a-z-]*", capsys.readouterr().out))
    own = "\n".join(line for line in TEXT.splitlines() if not line.startswith(("dask ", "sbatch ")))
    assert set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", own)) <= known


@WALLS
def test_a_table_without_an_ending_is_refused(tmp_path):
    with pytest.raises(SystemExit, match=r"ends in .csv"):
        main(["grade", "--allow-root", str(tmp_path), "--out", str(tmp_path / "grades")])
