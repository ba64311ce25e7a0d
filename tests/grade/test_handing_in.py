"""What is handed in tells every change: a byte, a file, the order, a mark that was not earned."""

import io
import json
import random
import zipfile

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import events, report
from coursekit.grade.bundle import bundle_faults, digest_of, note_copies, other_hands, pack_bundle, read_bundle
from coursekit.grade.exercise import find
from coursekit.grade.handing_in import make_bundle, verify
from coursekit.grade.mark import mark
from coursekit.grade.sandbox import Limits
from coursekit.grade.submissions import Submission

from .attacks import RIGHT
from .forged_bundles import resealed
from .test_attacks import cells


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """A course with one chapter, which has one exercise."""
    folder = tmp_path_factory.mktemp("notebooks")
    (folder / "names.ipynb").write_text(json.dumps(cells("")))
    return folder


def verified(file, course, *words):
    """`coursekit verify` with the chapters of that course."""
    return main(["verify", str(file), "--notebooks", str(course), *words])


@pytest.fixture(scope="module")
def bundle(course, tmp_path_factory):
    """A bundle with a notebook, a picture and a log."""
    notebooks, course = course, tmp_path_factory.mktemp("course")
    (course / "evidence").mkdir()
    picture = course / "evidence" / "VeraCourse_evidence_s2.png"
    picture.write_bytes(bytes(range(256)))
    evidence = {"picture": picture.name, "sha256": digest_of(picture.read_bytes())}
    events.note(course / ".coursekit" / "events.jsonl", "evidence", **evidence)
    (course / "evidence" / "private.png").write_bytes(b"mine")
    for points in (0, 1):
        events.note(course / ".coursekit" / "events.jsonl", "check", name="ch02.q1", points=points)
    (course / "names.ipynb").write_text(json.dumps(cells(RIGHT)))
    file, marked = make_bundle(course / "names.ipynb", course, "Vera Course", course, notebooks)
    assert not marked.notes
    assert (file.name, marked.total()) == ("VeraCourse_names.zip", 1)
    return file


def test_a_bundle_as_it_was_made_has_no_faults(bundle, course, capsys):
    manifest, files = read_bundle(bundle.read_bytes())
    assert set(files) == {"names.ipynb", "events.jsonl", "evidence/VeraCourse_evidence_s2.png"}
    assert (manifest["points"], manifest["of"], manifest["student"]) == (1, 1, "Vera Course")
    assert verify(bundle, course)[0] == []
    assert verified(bundle, course, "--no-run") == 0
    said = capsys.readouterr().out
    assert "Nothing was changed" in said and "It does not prove who made it, or when." in said


def test_every_flipped_byte_is_found(bundle):
    data = bundle.read_bytes()
    places = {*range(60), *range(len(data) - 60, len(data)), *random.Random(1).sample(range(len(data)), 400)}
    for place in places:
        changed = bytearray(data)
        changed[place] ^= 1 << (place % 8)
        assert bundle_faults(bytes(changed)), place


def zipped(files):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as packed:
        for name, content in files:
            packed.writestr(name, content)
    return buffer.getvalue()


def test_files_that_are_taken_out_put_in_changed_or_moved_are_found(bundle):
    with zipfile.ZipFile(bundle) as opened:
        files = [(name, opened.read(name)) for name in opened.namelist()]
    for number in range(len(files)):
        assert bundle_faults(zipped(files[:number] + files[number + 1 :]))
        name, content = files[number]
        assert bundle_faults(zipped([*files[:number], (name, content + b" "), *files[number + 1 :]]))
    assert bundle_faults(zipped([*files, ("more.txt", b"")])) == ["more.txt: was put in afterwards"]
    assert bundle_faults(zipped(files[::-1])) == ["the zip was packed again"]


def test_events_that_are_changed_or_reordered_are_found(bundle):
    _, files = read_bundle(bundle.read_bytes())
    lines = files["events.jsonl"].decode().splitlines()
    assert events.faults(lines) == []
    assert "does not follow" in events.faults(lines[::-1])[0]
    assert "does not follow" in events.faults(lines[1:])[0]
    assert "was changed" in events.faults([lines[0], lines[1].replace('"points": 0', '"points": 1'), *lines[2:]])[0]


def test_a_picture_and_a_notebook_that_the_log_does_not_tell_of_are_found(bundle):
    manifest, files = read_bundle(bundle.read_bytes())
    facts = {name: value for name, value in manifest.items() if name not in ("files", "seal")}
    assert bundle_faults(pack_bundle(files, facts)) == []
    for name in ("evidence/VeraCourse_evidence_s2.png", "names.ipynb"):
        changed = pack_bundle({**files, name: b"another"}, facts)
        assert bundle_faults(changed) == [f"{name}: it was changed after its entry in events.jsonl"]
    more = pack_bundle({**files, "evidence/VeraCourse_evidence_s3.png": b"painted"}, facts)
    assert bundle_faults(more) == ["evidence/VeraCourse_evidence_s3.png: events.jsonl does not tell of it"]


def test_another_s_bundle_is_told(bundle, course, tmp_path, capsys):
    data = bundle.read_bytes()
    assert other_hands(data, "course_vera_1234") == []
    assert other_hands(data, "bob") == ["it was made by 'Vera Course' and handed in as 'bob'"]
    (tmp_path / "BobBuilder_names.zip").write_bytes(data)
    assert verified(tmp_path / "BobBuilder_names.zip", course, "--no-run") == 1
    assert "made by 'Vera Course'" in capsys.readouterr().out
    manifest, files = read_bundle(data)
    facts = {name: value for name, value in manifest.items() if name not in ("files", "seal")}
    renamed = pack_bundle(files, {**facts, "student": "Bob Builder"})
    assert other_hands(renamed, "bob") == ["evidence/VeraCourse_evidence_s2.png: the name is not that of 'Bob Builder'"]


def test_a_forged_mark_with_a_right_seal_is_found_by_running_it_again(bundle, course, tmp_path, capsys):
    manifest, files = read_bundle(bundle.read_bytes())
    files["names.ipynb"] = json.dumps(cells("raise NotImplementedError()")).encode()
    lines = [json.loads(line) for line in files["events.jsonl"].decode().splitlines()]
    lines[-1]["sha256"] = digest_of(files["names.ipynb"])
    lines[-1]["digest"] = events.digest({name: value for name, value in lines[-1].items() if name != "digest"})
    files["events.jsonl"] = "\n".join(json.dumps(line) for line in lines).encode()
    facts = {name: value for name, value in manifest.items() if name not in ("files", "seal")}
    forged = tmp_path / "vera, forged.zip"
    forged.write_bytes(pack_bundle(files, facts))
    assert bundle_faults(forged.read_bytes()) == []
    assert verified(forged, course) == 1
    said = capsys.readouterr().out
    assert "ch02.q1: 1 points are recorded, a clean run earns 0" in said and "its cells are not those" in said


def test_a_bundle_is_a_submission_and_its_faults_are_told_to_the_teacher(bundle, tmp_path):
    with zipfile.ZipFile(bundle) as opened:
        files = [(name, opened.read(name) + b"!" * name.endswith(".png")) for name in opened.namelist()]
    changed = tmp_path / "vera.zip"
    changed.write_bytes(zipped(files))
    marked = mark(Submission("vera", changed), {"names.ipynb": cells("")}, {"ch02.q1": find("ch02.q1")}, Limits())
    assert marked.total() == 1 and "evidence/VeraCourse_evidence_s2.png: was changed" in marked.concerns
    assert not marked.notes and "was changed" not in json.dumps(report.gradescope(marked))


def test_a_bundle_counts_in_a_student_s_folder_too_and_its_marks_are_compared(bundle, tmp_path):
    manifest, files = read_bundle(bundle.read_bytes())
    facts = {name: value for name, value in manifest.items() if name not in ("files", "seal")}
    folder = tmp_path / "vera"
    folder.mkdir()
    (folder / "handed in.zip").write_bytes(pack_bundle(files, {**facts, "points": 9}))
    marked = mark(Submission("vera", folder), {"names.ipynb": cells("")}, {"ch02.q1": find("ch02.q1")}, Limits())
    assert marked.total() == 1 and len(marked.traces) == 5
    assert marked.concerns == ["9 points are recorded in all, a clean run earns 1"]


def test_a_log_that_two_hand_in_is_told_even_when_all_is_sealed_anew(bundle, course, tmp_path, capsys):
    data = resealed(bundle.read_bytes(), "Bob Builder")
    (tmp_path / "BobBuilder_names.zip").write_bytes(data)
    assert bundle_faults(data) == [] and other_hands(data, "bob builder") == []
    assert main(["verify", str(bundle), str(tmp_path / "BobBuilder_names.zip"), "--no-run", "--notebooks", str(course)]) == 1
    said = capsys.readouterr().out
    assert "BobBuilder_names.zip: the same as in VeraCourse_names.zip's: evidence/BobBuilder_evidence_s2.png, line 2" in said
    concerns = {name: [] for name in ("vera", "bob", "cem")}
    (tmp_path / "cem.zip").write_bytes(b"no zip")
    files = {"vera": bundle, "bob": tmp_path / "BobBuilder_names.zip", "cem": tmp_path / "cem.zip"}
    note_copies({name: (concerns[name], [files[name]]) for name in concerns})
    assert [len(messages) for messages in concerns.values()] == [1, 1, 0] and concerns["vera"][0].startswith(
        "the same as in bob's"
    )


def handed_in(folder, name, notebook, notebooks, student="Vera Course"):
    folder.mkdir(exist_ok=True)
    (folder / name).write_text(json.dumps(notebook))
    return make_bundle(folder / name, folder, student, folder, notebooks)


def test_without_evidence_that_is_said(course, tmp_path):
    _, marked = handed_in(tmp_path / "a", "names.ipynb", cells(RIGHT), course)
    assert marked.total() == 1 and "no evidence" in marked.notes[0]


def test_a_notebook_without_its_checks_is_not_taken(course, tmp_path):
    bare = cells(RIGHT)
    bare["cells"].pop()
    with pytest.raises(ValueError, match=r"names.ipynb holds no check of the course.*Hand in one of: names.ipynb"):
        handed_in(tmp_path / "a", "names.ipynb", bare, course)


def test_a_notebook_of_another_name_is_refused_with_words(course, tmp_path, capsys):
    file, _ = handed_in(tmp_path / "a", "mine.ipynb", cells(RIGHT), course)
    for words in ((), ("--no-run",)):
        assert verified(file, course, *words) == 1
        said = capsys.readouterr().out
        assert "'mine.ipynb' is no chapter of the course. It looks like names.ipynb" in said
        assert "There are: names.ipynb." in said and "Nothing was changed" not in said


def test_checks_that_were_taken_out_are_told(course, tmp_path, capsys):
    two = cells(RIGHT)
    two["cells"].append({**two["cells"][1], "source": 'check("ch02.q2")', "metadata": {}})
    (tmp_path / "two").mkdir()
    (tmp_path / "two" / "names.ipynb").write_text(json.dumps(two))
    file, marked = handed_in(tmp_path / "a", "names.ipynb", cells(RIGHT), tmp_path / "two")
    assert "its checks of ch02.q2 were taken out" in marked.notes[0]
    assert verified(file, tmp_path / "two", "--no-run") == 1
    assert "its checks of ch02.q2 were taken out" in capsys.readouterr().out


@pytest.mark.parametrize("line", ["[1]", "1", "null", "{", "[" * 3000, '{"digest": 3, "before": []}'])
def test_a_log_that_is_none_is_a_fault(bundle, line):
    manifest, files = read_bundle(bundle.read_bytes())
    facts = {name: value for name, value in manifest.items() if name not in ("files", "seal")}
    assert bundle_faults(pack_bundle({**files, "events.jsonl": line.encode()}, facts))


@pytest.mark.parametrize("name", ["manifest.json", "events.jsonl"])
def test_a_manifest_or_log_that_would_take_all_memory_is_not_read(bundle, name):
    with zipfile.ZipFile(bundle) as opened:
        files = {member: opened.read(member) for member in opened.namelist()}
    for long in (b"[" + b"[]," * 700_000 + b"1]", b'"' + b"x" * (17 << 20) + b'"'):
        assert f"{name} is longer than hand_in() makes it" in bundle_faults(zipped({**files, name: long}.items()))[0]


def test_what_is_no_bundle_is_said(tmp_path):
    (tmp_path / "x.zip").write_bytes(b"PK")
    faults, marked = verify(tmp_path / "x.zip", tmp_path)
    assert "not a submission bundle made by hand_in()" in faults[0] and marked is None
    with pytest.raises(SystemExit, match="There is no file"):
        main(["verify", str(tmp_path / "y.zip")])
