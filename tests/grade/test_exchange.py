"""A teacher hands out and collects through a folder of the server, laid out as nbgrader's exchange."""

import json
import os
import stat

import pytest

from coursekit.cli.coursekit import main
from coursekit.cli.hub import fetch_releases
from coursekit.grade import exchange
from coursekit.grade.copy import Course
from coursekit.grade.editions import notebooks_folder
from coursekit.grade.roster import Person, Roster
from tests.needs import posix

from .handed import TOPICS, by_name, collected, text, write

pytestmark = posix("no JupyterHub runs there, for whose students this folder is")
CLASS = Roster([Person("Ben Ito", id="ben"), Person("Ann Lee", email="ann@uni.example")])


@pytest.fixture
def server(tmp_path, monkeypatch):
    """The exchange of a course on a server."""
    place = tmp_path / "exchange" / "ros2"
    monkeypatch.setenv(exchange.VARIABLE, str(place))
    monkeypatch.chdir(tmp_path)
    return place


@pytest.fixture
def course(tmp_path):
    """A student's copy of the course, as it was first given."""
    Course(tmp_path / "course").update(notebooks_folder())
    return tmp_path / "course"


def released(server, *words):
    assert main(["release", "02", "--exchange", str(server), "--out", "week2", *words]) == 0


def facts(file):
    return json.loads(file.read_text())["metadata"]["coursekit"]


def rights(folder):
    return oct(stat.S_IMODE(folder.stat().st_mode))


def test_what_is_handed_out_everybody_can_read_and_what_is_handed_in_nobody_can_list(server, capsys):
    released(server)
    assert "week2: students have it when their server starts next." in capsys.readouterr().out
    assert [release.name for release in exchange.releases(server)] == ["week2"]
    assert os.access(server / "outbound" / "week2" / TOPICS, os.R_OK)
    assert (rights(server / "outbound" / "week2"), rights(server / "inbound")) == ("0o2755", "0o2733")
    assert "BEGIN SOLUTION" not in (server / "outbound" / "week2" / TOPICS).read_text()


def test_a_release_replaces_an_untouched_chapter_and_stays_beside_one_with_work(server, course):
    released(server)
    assert fetch_releases(course) == [f"{TOPICS}: updated (you had not changed it)"]
    assert facts(course / TOPICS)["handed_out"] == "week2"
    assert fetch_releases(course) == []  # each time the server starts
    work = text("q1")
    (course / TOPICS).write_text(work)
    corrected = server / "outbound" / "week2" / TOPICS
    corrected.write_text(corrected.read_text().replace("## ", "## Corrected: ", 1))
    assert "you have worked on it, so it stays" in fetch_releases(course)[0]
    assert (course / TOPICS).read_text() == work
    assert "## Corrected: " in (course / "02_topics.new.ipynb").read_text()


def test_a_new_edition_of_the_course_leaves_a_release_alone(server, course):
    released(server)
    fetch_releases(course)
    before = (course / TOPICS).read_bytes()
    Course(course).update(notebooks_folder())
    assert (course / TOPICS).read_bytes() == before


def test_without_an_exchange_nothing_is_fetched(course, monkeypatch):
    monkeypatch.delenv(exchange.VARIABLE, raising=False)
    assert fetch_releases(course) == []
    monkeypatch.setenv(exchange.VARIABLE, str(course / "none"))
    assert fetch_releases(course) == []


def test_a_release_for_everybody_has_no_copies_of_single_students(server, tmp_path):
    (tmp_path / "roster.txt").write_text("Ben Ito\n")
    with pytest.raises(SystemExit, match="everybody gets the same"):
        main(["release", "02", "--exchange", str(server), "--roster", str(tmp_path / "roster.txt")])


def test_what_students_put_there_is_collected_as_theirs_and_the_newest_counts(server, tmp_path):
    released(server)
    for user, done in (("ben", ("q1",)), ("ben", ("q1", "q2")), ("ann", ("q3",))):
        exchange.hand_in(server, user, "week2", [write(tmp_path / TOPICS, text(*done))])
    collection = collected(server / "inbound", tmp_path / "scratch", roster=CLASS)
    assert not collection.questions
    assert {name: (len(handed.pieces()), set(handed.chosen)) for name, handed in by_name(collection).items()} == {
        "Ben Ito": (2, {TOPICS}),
        "Ann Lee": (1, {TOPICS}),
    }
    chosen = by_name(collection)["Ben Ito"].chosen[TOPICS]
    assert chosen.known.begun == ("ch02.q1", "ch02.q2")
    assert chosen.when_from == "the platform's time"


def test_what_a_student_puts_there_appears_whole_or_not_at_all(server, tmp_path, monkeypatch):
    released(server)
    sent = write(tmp_path / TOPICS, text("q1"))

    def full(*_words, **_more):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(exchange, "write_whole", full)
    with pytest.raises(OSError, match="No space left"):
        exchange.hand_in(server, "ben", "week2", [sent])
    assert list((server / "inbound").iterdir()) == []


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="NOT TESTED: only root can be two users")
def test_work_under_another_user_s_name_is_not_read_and_that_is_told(server, tmp_path):
    released(server)
    place = exchange.hand_in(server, "daemon", "week2", [write(tmp_path / TOPICS, text("q1"))])
    collection = collected(server / "inbound", tmp_path / "scratch", roster=Roster([Person("Dae Mon", id="daemon")]))
    (handed,) = collection.handed
    assert not handed.chosen
    assert any("it names daemon, but root put it there" in note for note in handed.notes), handed.notes
    os.chown(place, 1, 1)
    collection = collected(server / "inbound", tmp_path / "scratch", roster=Roster([Person("Dae Mon", id="daemon")]))
    assert set(collection.handed[0].chosen) == {TOPICS}
