"""What a teacher stumbled over who had only README and docs/teachers.md."""

import io
import subprocess
import sys

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import marking_progress
from coursekit.grade.checking import judge_work
from coursekit.grade.exercise import find
from coursekit.grade.handing_back import beside_the_platform_s
from coursekit.grade.handing_out import expect_numbers
from coursekit.grade.lateness import late_by
from coursekit.grade.outputs import expect_node
from coursekit.grade.overview import overview
from coursekit.grade.page_style import STYLE
from coursekit.grade.plan import Seen
from coursekit.grade.report import page
from coursekit.grade.roster import Roster
from coursekit.grade.verdict import Verdict, Wrong
from coursekit.grade.work import Work
from tests.needs import posix

from .handed import TOPICS, grade, lines, text, write
from .test_identifying import LISTS


def test_marks_of_7_in_an_assignment_of_100_are_told_before_they_are_uploaded(folder, capsys):
    (folder.parent / "moodle.csv").write_text(_with_maximum("100.00"), encoding="utf-8")
    grade(folder, "--roster", folder.parent / "moodle.csv", "--for", "moodle")
    assert "the assignment's maximum grade is 100.00, and these marks are of 7 points" in capsys.readouterr().out
    (folder.parent / "moodle.csv").write_text(_with_maximum("7.00"), encoding="utf-8")
    grade(folder, "--roster", folder.parent / "moodle.csv", "--for", "moodle")
    assert "maximum grade" not in capsys.readouterr().out


def _with_maximum(most):
    head, *rows = LISTS["moodle.csv"].splitlines()
    return "\n".join([f"{head},Maximum grade", *(f"{row},{most}" for row in rows)]) + "\n"


@pytest.mark.parametrize(("most", "told"), [("", False), ("-", False), ("14", False), ("14,00", False), ("10", True)])
def test_a_maximum_that_is_no_number_is_left_alone(most, told):
    assert bool(beside_the_platform_s(14.0, [most])) == told


def test_a_dash_in_the_platform_s_own_column_stays_a_dash(folder):
    head, *rows = LISTS["moodle.csv"].splitlines()
    table = "\n".join([f"{head},Last modified (grade)", *(f"{row},-" for row in rows)])
    (folder.parent / "moodle.csv").write_text(table, encoding="utf-8")
    grade(folder, "--roster", folder.parent / "moodle.csv", "--for", "moodle")
    assert lines(folder.parent / "grades.moodle.csv")[1][-1] == "-"


def test_whoever_has_no_number_is_counted(tmp_path):
    (tmp_path / "names.txt").write_text("Ann Lee\nBen Ito\nEva Sol\nJo Ray\n")
    with pytest.raises(ValueError, match=r"Ann Lee, Ben Ito, Eva Sol and 1 more have none"):
        expect_numbers(Roster.read(tmp_path / "names.txt"))
    (tmp_path / "names.txt").write_text("Ann Lee\n")
    with pytest.raises(ValueError, match=r"Ann Lee has none"):
        expect_numbers(Roster.read(tmp_path / "names.txt"))


@posix("a pipe that closed is another error there")
def test_who_reads_only_the_first_lines_sees_no_traceback():
    program = "import sys; from coursekit.cli.coursekit import main; sys.exit(main())"
    ours = [sys.executable, "-c", program, "teachers"]
    process = subprocess.Popen(ours, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.close()
    assert b"Traceback" not in process.stderr.read() and process.wait() != 0
    process.stderr.close()


def test_marking_says_at_once_what_it_begins_with(tmp_path, monkeypatch):
    told = io.StringIO()
    monkeypatch.setattr(marking_progress.sys, "stderr", told)
    now = iter((0.0, 5.0, 6.0, 40.0, 41.0))
    monkeypatch.setattr(marking_progress.time, "monotonic", lambda: next(now))
    shown = marking_progress.Bar()
    shown.say("Marking the course's own solutions first: 02_topics.")
    for done in (1, 2, 3, 4):
        shown(done, 9, "Ann")
    assert told.getvalue().splitlines() == [
        "Marking the course's own solutions first: 02_topics.",
        "1 of 9 notebooks marked, about 40 s left",
        "3 of 9 notebooks marked, about 80 s left",
    ]


def test_the_solutions_are_announced_once_while_they_are_marked(folder, capfd):
    for expected in (1, 0):
        write(folder / "Ito Ben_102_assignsubmission_file_" / TOPICS, text("q3"))
        grade(folder, "--roster", folder.parent / "moodle.csv")
        assert capfd.readouterr().err.count("Marking the course's own solutions first: 02_topics") == expected


@pytest.mark.parametrize(("minutes", "said"), [(1, "1 min"), (59.2, "59 min"), (1411, "23 h 31 min"), (2880, "2 days"),
                                               (1440 * 3 + 61, "3 days 1 h"), (0.2, "1 min")])  # fmt: skip
def test_lateness_is_told_as_people_say_it(minutes, said):
    assert late_by(minutes) == said


def test_long_lines_of_code_are_not_cut_at_the_page_s_edge():
    assert "white-space:pre-wrap" in _style(page(_record()))


def test_the_class_s_picture_is_dark_on_a_dark_page():
    overview_page = overview([_record()])
    assert '<img class="drawn" src="histogram.png"' in overview_page
    assert "img.drawn{filter:invert" in STYLE.partition("prefers-color-scheme:dark")[2]


def _style(text):
    return text.partition("\npre{")[2].partition("}")[0]


def _record():
    from coursekit.grade.person_submission import PersonSubmission
    from coursekit.grade.record import Record
    from coursekit.grade.roster import Person

    return Record(PersonSubmission(Person("Ann Lee"), "Ann Lee"), {TOPICS: [Verdict("ch02.q1", "Names", 0, 1)]})


def test_what_is_typed_looks_so_in_a_verdict():
    told = Verdict("a", "b", 0, 1, "the type that `ros2 topic info /rosout` prints", hint="`a < b` and `c").html()
    assert "<code>ros2 topic info /rosout</code>" in told and "<code>a &lt; b</code> and `c" in told


def test_what_a_student_wrote_is_shown_as_it_is():
    assert "`x`" in Verdict("a", "b", 0, 1, "e", gave="`x`", got="`y`").html()


def test_a_program_that_died_is_not_asked_for_its_node_s_name():
    died = 'Traceback (most recent call last):\n  File "/w/a.py", line 2\n    x = (\nSyntaxError: invalid syntax\n'
    with pytest.raises(Wrong) as error:
        expect_node(Seen(outputs=[died], exit_codes=[1]), "/a")
    assert "ended with that error" in error.value.cause
    with pytest.raises(Wrong) as error:
        expect_node(Seen(outputs=["hello\n"], exit_codes=[None]), "/a")
    assert "node's name and namespace right" in error.value.cause


def test_release_says_where_what_it_wrote_lies(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    main(["release", "02", "--out", "week2"])
    assert capsys.readouterr().out.splitlines()[:3] == ["week2/02_topics.ipynb", "week2/week2.zip", "week2/page.html"]


class _Listened(Work):
    """Work whose listener logs what was published, in these words."""

    def __init__(self, **variables):
        super().__init__(variables, None)

    def built(self, *names):
        """It is."""

    def try_out(self, *commands, publish=(), **plan):
        output = "".join(f"[INFO] [1.0] [py_subscriber_node]: heard: {said['data']}\n" for _, _, _, said in publish)
        told = {"/rosout": ["rcl_interfaces/msg/Log"]}
        seen = Seen(outputs=[output], exit_codes=[None], nodes=["/py_subscriber_node"], topics=told)
        seen.subscriptions["/py_str_topic"] = [{"node": "/py_subscriber_node", "type": "std_msgs/msg/String"}]
        return seen


@pytest.mark.parametrize(
    ("exercise", "variables", "cause"),
    [
        ("ch02.q2", {}, "logged with other words"),
        ("ch01.q1", {"rosout_type": "std_msgs/msg/String", "rosout_publishers": 2}, "another topic's type"),
        ("ch01.q1", {"rosout_type": "Log", "rosout_publishers": 2}, "in full"),
    ],
)
def test_the_likely_cause_fits_what_was_seen(exercise, variables, cause):
    assert cause in judge_work(find(exercise), _Listened(**variables)).cause
