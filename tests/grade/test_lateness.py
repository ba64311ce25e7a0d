"""When it was handed in, by whose clock, what that costs; and which version counts."""

import time

import pytest

from coursekit.grade.bundle import pack_bundle
from coursekit.grade.lateness import Policy, read_policy
from coursekit.grade.roster import Person, Roster

from .handed import NOON, TOPICS, by_name, cheap_mark, collected, grade, text, write, zipped

DUE = time.strftime("%Y-%m-%dT%H:%M", time.localtime(NOON))
HOUR, DAY = 3600, 86400


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A class's folder; marks are cheap."""
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    (tmp_path / "class").mkdir()
    return tmp_path / "class"


def sealed(when, *done):
    said = time.strftime("%Y-%m-%d %H:%M:%S +0000", time.gmtime(when))
    return pack_bundle({TOPICS: text(*done).encode()}, {"student": "Ann Lee", "notebook": TOPICS, "time": said})


def test_the_seal_goes_before_the_platform_and_the_platform_before_the_file(folder):
    stamp = time.strftime("%Y-%m-%d-%H-%M-%S", time.localtime(NOON + HOUR))
    write(folder / "AnnLee_02_topics.zip", sealed(NOON - 60, "q1"), NOON + DAY)
    write(folder / f"w_ben_attempt_{stamp}_{TOPICS}", text("q1"), NOON + DAY)
    write(folder / "cem.zip", zipped({TOPICS: (text("q1"), NOON + 2 * HOUR)}, NOON + DAY))
    write(folder / "dai" / TOPICS, text("q1"), NOON - HOUR)
    rows_by_name = grade(folder, "--due", DUE)[1]
    said = {name: (row["minutes_late"], row["time_from"], row["status"]) for name, row in rows_by_name.items()}
    assert said == {
        "Ann Lee": ("0", "the time that hand_in sealed", "graded"),
        "ben": ("60", "the platform's time", "late"),
        "cem": ("120", "the file's time in the zip", "late"),
        "dai": ("0", "the file's time", "graded"),
    }
    assert "sealed in time, but the file is of" in rows_by_name["Ann Lee"]["notes"]


def test_the_time_in_the_platform_s_list_counts_where_its_names_tell_none(folder, tmp_path):
    head = "Full name,Identifier,Last modified (submission)\n"
    (tmp_path / "moodle.csv").write_text(head + '"Lee, Ann",Participant 7,"Monday, 23 November 2026, 2:00 PM"\n')
    write(folder / "Lee Ann_7_assignsubmission_file_" / TOPICS, text("q1"), NOON + DAY)
    row = grade(folder, "--due", DUE, "--roster", tmp_path / "moodle.csv")[1]["Ann Lee"]
    assert (row["minutes_late"], row["time_from"]) == ("120", "the time in the platform's list")


@pytest.mark.parametrize(("count", "points", "late"), [("newest", "3", "60"), ("in-time", "1", "0")])
def test_the_newest_counts_or_the_last_before_the_deadline(folder, count, points, late):
    write(folder / "Ann Lee.ipynb", text("q1"), NOON - HOUR)
    write(folder / "Ann Lee" / TOPICS, text("q1", "q2"), NOON + HOUR)
    row = grade(folder, "--due", DUE, "--count", count)[1]["Ann Lee"]
    assert (row["points"], row["minutes_late"]) == (points, late)
    assert row["attempts"].count(" | ") == 1 and "counts; not" in row["notes"]


def test_who_was_never_in_time_is_late_with_what_there_is(folder):
    write(folder / "Ann Lee" / TOPICS, text("q1"), NOON + HOUR)
    assert grade(folder, "--due", DUE, "--count", "in-time")[1]["Ann Lee"]["minutes_late"] == "60"


def test_a_file_of_the_future_is_told(folder):
    write(folder / "Ann Lee" / TOPICS, text("q1"), NOON + 40 * DAY)
    write(folder / "Ben Ito" / TOPICS, text("q1"), NOON)
    rows_by_name = grade(folder, "--due", DUE)[1]
    assert "yet to come: was that computer's clock wrong?" in rows_by_name["Ann Lee"]["notes"]
    assert "yet to come" not in rows_by_name["Ben Ito"]["notes"]


def test_canvas_says_late_and_that_is_believed(folder):
    write(folder / f"leeann_LATE_1_2_{TOPICS}", text("q1"), NOON - HOUR)
    row = grade(folder, "--due", DUE)[1]["leeann"]
    assert row["status"] == "late" and "the platform says" in row["notes"]


POLICY = """due = {due}:00
grace_minutes = 30
percent_per_day = 10
floor_percent = 75
[extensions]
"a02" = {later}:00
"cem@uni.example" = 2
"""


def test_grace_percent_floor_and_extensions(folder, tmp_path):
    later = time.strftime("%Y-%m-%dT%H:%M", time.localtime(NOON + 5 * DAY))
    (tmp_path / "policy.toml").write_text(POLICY.format(due=DUE, later=later))
    (tmp_path / "roster.csv").write_text("name,id,email\nAnn,a01,\nBen,a02,\nCem,a03,cem@uni.example\nDai,a04,\nEva,a05,\n")
    for name, after in (("Ann", 20 * 60), ("Ben", 5 * DAY), ("Cem", 3 * DAY - 60), ("Dai", 1.5 * DAY), ("Eva", 30 * DAY)):
        write(folder / name / TOPICS, text("q1", "q2", "q3"), NOON + after)
    rows_by_name = grade(folder, "--roster", tmp_path / "roster.csv", "--policy", tmp_path / "policy.toml")[1]
    assert {name: (row["percent_off"], row["total"]) for name, row in rows_by_name.items()} == {
        "Ann": ("0", "5"), "Ben": ("0", "5"), "Cem": ("10", "4.5"), "Dai": ("20", "4"), "Eva": ("25", "3.75"),
    }  # fmt: skip
    assert {row["points"] for row in rows_by_name.values()} == {"5"}
    page = (tmp_path / "grades" / f"{rows_by_name['Eva']['key']}.html").read_text()
    assert "after 25 % taken off for being late" in page and "by the file&#x27;s time" in page


@pytest.mark.parametrize(
    ("policy", "told"),
    [("graze = 3", "'graze' is not known. There are: due, grace_minutes"), ("percent_per_day = '10'", "has to be a number"),
     ("[extensions]\nZoe = 3", "'Zoe' is no student"), ("due = 'soon'", "no time. Write it as"), ("due = ", "policy.toml"),
     ("count = 'best'", "'newest' or 'in-time'"), ("grace_minutes = -1", "0 or more"), ("grace_minutes = nan", "0 or more"),
     ("percent_per_day = nan", "0 to 100"), ("floor_percent = 150", "0 to 100"), ("grace_minutes = true", "0 or more"),
     ("[extensions]\nAnn = nan", "'Ann' cannot have nan days more"), ("[extensions]\nAnn = '²'", "'²' is no time")],
)  # fmt: skip
def test_a_policy_that_is_not_understood_is_refused(tmp_path, policy, told):
    (tmp_path / "policy.toml").write_text(policy)
    with pytest.raises(ValueError, match=told):
        read_policy(tmp_path / "policy.toml", Roster(["Ann"]))


def test_which_deadline_counts_is_told_where_two_are_given(folder, tmp_path, capsys):
    policy = write(tmp_path / "policy.toml", "due = 2026-11-20T12:00\ncount = 'in-time'\n[extensions]\nAnn = 1\n")
    words = ("--policy", policy, "--due", "2026-11-22T12:00", "--count", "newest")
    write(folder / "Ann.ipynb", text("q1"), NOON)
    assert grade(folder, *words)[1]["Ann"]["minutes_late"] == "0"
    said = capsys.readouterr().out
    assert f"! The deadline 2026-11-22 12:00 of --due counts; not that of {policy}, 2026-11-20 12:00. Its other" in said
    assert f"! 'newest' of --count counts; not 'in-time' of {policy}." in said
    for alone in (words[:2], words[2:]):
        grade(folder, *alone)
        assert " counts" not in capsys.readouterr().out.replace(str(tmp_path), "")


def test_a_day_without_a_time_ends_at_midnight_not_before(folder, tmp_path, capsys):
    write(folder / "Ann.ipynb", text("q1"), NOON)
    policy = write(tmp_path / "policy.toml", "due = 2026-11-23\n")
    for words in (("--due", "2026-11-23"), ("--policy", policy)):
        assert grade(folder, *words)[1]["Ann"]["status"] == "graded"
    with pytest.raises(SystemExit):
        grade(folder, "--due", "Monday")
    assert "'Monday' is no time. Write it as 2026-11-30T23:59." in capsys.readouterr().err


def test_extensions_can_be_a_table(tmp_path):
    (tmp_path / "more.csv").write_text("student;due\nAnn;2\nBen;2026-12-01 10:00\n")
    policy = read_policy(tmp_path / "more.csv", Roster([Person("Ann", id="1"), Person("Ben", id="2")]))
    assert policy.days_more == {"1": 2.0} and list(policy.extensions) == ["2"]


def test_days_begin_with_the_first_minute():
    assert [Policy(percent_per_day=10).percent_off(minutes) for minutes in (0, 0.1, 1440, 1441)] == [0, 10, 10, 20]


def test_times_in_zips_are_kept(folder, tmp_path):
    write(
        folder / "Ann.zip", zipped({f"a/{TOPICS}": (text("q1"), NOON - DAY), f"b/{TOPICS}": (text("q2"), NOON)}), NOON + DAY
    )
    (piece, other) = by_name(collected(folder, tmp_path / "s"))["Ann"].pieces()
    assert (round(piece.when), round(other.when)) == (round(NOON - DAY), round(NOON))
