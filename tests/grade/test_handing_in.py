"""What is handed in tells every change: a byte, a file, the order, a mark that was not earned."""

import io
import json
import random
import zipfile

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import events, report
from coursekit.grade.batch import _note_copies
from coursekit.grade.exercise import find
from coursekit.grade.handing_in import make_parcel, verify
from coursekit.grade.mark import Marked, mark
from coursekit.grade.parcel import digest_of, other_hands, pack_parcel, parcel_faults, read_parcel, traces
from coursekit.grade.sandbox import Limits
from coursekit.grade.submissions import Submission

from .test_attacks import RIGHT, cells


@pytest.fixture(scope="module")
def parcel(tmp_path_factory):
    """A parcel with a notebook, a picture and a log."""
    course = tmp_path_factory.mktemp("course")
    (course / "evidence").mkdir()
    picture = course / "evidence" / "VeraCourse_evidence_s2.png"
    picture.write_bytes(bytes(range(256)))
    made = {"picture": picture.name, "sha256": digest_of(picture.read_bytes())}
    events.note(course / ".coursekit" / "events.jsonl", "evidence", **made)
    (course / "evidence" / "private.png").write_bytes(b"mine")
    for points in (0, 1):
        events.note(course / ".coursekit" / "events.jsonl", "check", name="ch02.q1", points=points)
    (course / "names.ipynb").write_text(json.dumps(cells(RIGHT)))
    file, marked = make_parcel(course / "names.ipynb", course, "Vera Course", course)
    assert (file.name, marked.total()) == ("VeraCourse_names.zip", 1)
    return file


def test_a_parcel_as_it_was_made_has_no_faults(parcel, capsys):
    manifest, files = read_parcel(parcel.read_bytes())
    assert set(files) == {"names.ipynb", "events.jsonl", "evidence/VeraCourse_evidence_s2.png"}
    assert (manifest["points"], manifest["of"], manifest["student"]) == (1, 1, "Vera Course")
    assert verify(parcel)[0] == []
    assert main(["verify", str(parcel), "--no-run"]) == 0
    assert "Nothing was changed" in capsys.readouterr().out


def test_every_flipped_byte_is_found(parcel):
    data = parcel.read_bytes()
    places = {*range(60), *range(len(data) - 60, len(data)), *random.Random(1).sample(range(len(data)), 400)}
    for place in places:
        changed = bytearray(data)
        changed[place] ^= 1 << (place % 8)
        assert parcel_faults(bytes(changed)), place


def zipped(files):
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as packed:
        for name, content in files:
            packed.writestr(name, content)
    return made.getvalue()


def test_files_that_are_taken_out_put_in_changed_or_moved_are_found(parcel):
    with zipfile.ZipFile(parcel) as opened:
        files = [(name, opened.read(name)) for name in opened.namelist()]
    for number in range(len(files)):
        assert parcel_faults(zipped(files[:number] + files[number + 1 :]))
        name, content = files[number]
        assert parcel_faults(zipped([*files[:number], (name, content + b" "), *files[number + 1 :]]))
    assert parcel_faults(zipped([*files, ("more.txt", b"")])) == ["more.txt: was put in afterwards"]
    assert parcel_faults(zipped(files[::-1])) == ["the zip was packed anew"]


def test_events_that_are_changed_or_reordered_are_found(parcel):
    _, files = read_parcel(parcel.read_bytes())
    lines = files["events.jsonl"].decode().splitlines()
    assert events.faults(lines) == []
    assert "does not follow" in events.faults(lines[::-1])[0]
    assert "does not follow" in events.faults(lines[1:])[0]
    assert "was changed" in events.faults([lines[0], lines[1].replace('"points": 0', '"points": 1'), *lines[2:]])[0]


def test_a_picture_and_a_notebook_that_the_log_does_not_tell_of_are_found(parcel):
    manifest, files = read_parcel(parcel.read_bytes())
    facts = {name: value for name, value in manifest.items() if name not in ("files", "seal")}
    assert parcel_faults(pack_parcel(files, facts)) == []
    for name in ("evidence/VeraCourse_evidence_s2.png", "names.ipynb"):
        changed = pack_parcel({**files, name: b"another"}, facts)
        assert parcel_faults(changed) == [f"{name}: it was changed since events.jsonl tells of it"]
    more = pack_parcel({**files, "evidence/VeraCourse_evidence_s3.png": b"painted"}, facts)
    assert parcel_faults(more) == ["evidence/VeraCourse_evidence_s3.png: events.jsonl does not tell of it"]


def test_another_s_parcel_is_told(parcel, tmp_path, capsys):
    data = parcel.read_bytes()
    assert other_hands(data, "course_vera_1234") == []
    assert other_hands(data, "bob") == ["it was made by 'Vera Course' and handed in as 'bob'"]
    (tmp_path / "BobBuilder_names.zip").write_bytes(data)
    assert main(["verify", str(tmp_path / "BobBuilder_names.zip"), "--no-run"]) == 1
    assert "made by 'Vera Course'" in capsys.readouterr().out
    manifest, files = read_parcel(data)
    facts = {name: value for name, value in manifest.items() if name not in ("files", "seal")}
    renamed = pack_parcel(files, {**facts, "student": "Bob Builder"})
    assert other_hands(renamed, "bob") == ["evidence/VeraCourse_evidence_s2.png: the name is not that of 'Bob Builder'"]


def test_a_forged_mark_with_a_right_seal_is_found_by_running_it_again(parcel, tmp_path, capsys):
    manifest, files = read_parcel(parcel.read_bytes())
    files["names.ipynb"] = json.dumps(cells("raise NotImplementedError()")).encode()
    lines = [json.loads(line) for line in files["events.jsonl"].decode().splitlines()]
    lines[-1]["sha256"] = digest_of(files["names.ipynb"])
    lines[-1]["digest"] = events.digest({name: value for name, value in lines[-1].items() if name != "digest"})
    files["events.jsonl"] = "\n".join(json.dumps(line) for line in lines).encode()
    facts = {name: value for name, value in manifest.items() if name not in ("files", "seal")}
    forged = tmp_path / "vera, forged.zip"
    forged.write_bytes(pack_parcel(files, facts))
    assert parcel_faults(forged.read_bytes()) == []
    assert main(["verify", str(forged)]) == 1
    said = capsys.readouterr().out
    assert "ch02.q1: 1 points are recorded, a clean run earns 0" in said and "its cells are not those" in said


def test_a_parcel_is_a_submission_and_its_faults_are_told_to_the_teacher(parcel, tmp_path):
    with zipfile.ZipFile(parcel) as opened:
        files = [(name, opened.read(name) + b"!" * name.endswith(".png")) for name in opened.namelist()]
    changed = tmp_path / "vera.zip"
    changed.write_bytes(zipped(files))
    marked = mark(Submission("vera", changed), {"names.ipynb": cells("")}, {"ch02.q1": find("ch02.q1")}, Limits())
    assert marked.total() == 1 and "evidence/VeraCourse_evidence_s2.png: was changed" in marked.concerns
    assert not marked.notes and "was changed" not in report.page(marked) + json.dumps(report.gradescope(marked))


def test_a_parcel_counts_in_a_student_s_folder_too_and_its_marks_are_compared(parcel, tmp_path):
    manifest, files = read_parcel(parcel.read_bytes())
    facts = {name: value for name, value in manifest.items() if name not in ("files", "seal")}
    folder = tmp_path / "vera"
    folder.mkdir()
    (folder / "handed in.zip").write_bytes(pack_parcel(files, {**facts, "points": 9}))
    marked = mark(Submission("vera", folder), {"names.ipynb": cells("")}, {"ch02.q1": find("ch02.q1")}, Limits())
    assert marked.total() == 1 and len(marked.traces) == 5
    assert marked.concerns == ["9 points are recorded in all, a clean run earns 1"]


def test_the_class_s_copies_of_one_picture_or_log_are_told_to_all_who_have_them(parcel):
    marks = [Marked(name, "", traces=traces(parcel.read_bytes())) for name in ("vera", "bob")]
    marks.append(Marked("cem", "", traces={"0": "line 1 of events.jsonl"}))
    _note_copies(marks)
    what = "evidence/VeraCourse_evidence_s2.png, line 1 of events.jsonl, line 2 of events.jsonl"
    assert [one.concerns for one in marks] == [[f"the same as in bob's: {what}"], [f"the same as in vera's: {what}"], []]


def test_what_is_no_parcel_is_said(tmp_path):
    (tmp_path / "x.zip").write_bytes(b"PK")
    faults, marked = verify(tmp_path / "x.zip")
    assert "no parcel made by hand_in()" in faults[0] and marked is None
    with pytest.raises(SystemExit, match="There is no file"):
        main(["verify", str(tmp_path / "y.zip")])
