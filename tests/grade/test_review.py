"""Marking by hand: only this computer's browser is answered; what is written holds in table, pages and later runs."""

import json
import urllib.error
import urllib.request

import pytest

from tests.needs import posix

from .handed import WALLS, cheap_mark, grade, rows
from .reviewing import make_class, reviewing

pytestmark = posix("submissions are marked in a container, and `--review` is refused with the reason (test_container)")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A class of three."""
    class_folder = tmp_path_factory.mktemp("marking") / "class"
    make_class(class_folder)
    return class_folder


@pytest.fixture(scope="module")
def address(folder):
    """Where it is marked; the folder of the pages."""
    with reviewing(folder) as url:
        yield url.removesuffix("class.html")


def get(url, host=None):
    request = urllib.request.Request(url, headers={"Host": host} if host else {})
    try:
        with urllib.request.urlopen(request) as answer:
            return answer.status, answer.read().decode(), answer.headers
    except urllib.error.HTTPError as error:
        return error.code, "", error.headers


def post(url, body):
    data = body if isinstance(body, bytes) else json.dumps(body).encode()
    with urllib.request.urlopen(urllib.request.Request(url, data=data, method="POST")) as answer:
        return json.loads(answer.read())


def keys(folder):
    return {name: row["key"] for name, row in rows(folder.parent / "grades.csv").items()}


def test_only_who_knows_the_address_is_answered(address):
    assert address.startswith("http://127.0.0.1:")
    status, page, headers = get(address + "class.html")
    assert status == 200 and "Ann Lee" in page and "script-src 'self'" in headers["Content-Security-Policy"]
    assert headers["X-Content-Type-Options"] == "nosniff" and headers["Referrer-Policy"] == "no-referrer"
    other = address.rsplit("/", 2)[0]
    for path in ("/", "/class.html", "/guess/class.html"):
        assert get(other + path)[0] == 404
    assert get(address + "../../etc/passwd")[0] == 404 and get(address + "static/marks.py")[0] == 404
    assert get(address + "class.html", host="evil.example")[0] == 403


def test_a_page_shows_the_work_the_evidence_and_fields(address, folder):
    _, page, _ = get(address + keys(folder)["Ann Lee"] + ".html")
    assert page.count("data:image/png;base64,") == 1 and 'data-exercise="ch02.q1"' in page
    _, page, _ = get(address + keys(folder)["Cem <b>Kaya"] + ".html")
    assert "Cem &lt;b&gt;Kaya" in page and "<script>document" not in page


def test_the_page_of_the_class_says_the_keys(address, folder):
    _, page, _ = get(address + "class.html")
    assert page.count("<nav>") == 1 and all(f"<kbd>{key}</kbd>" in page for key in ("j", "k", "n", "p", "c", "u", "Enter"))
    assert "review.js" in page and "<kbd>" not in (folder.parent / "grades" / "class.html").read_text(encoding="utf-8")


def test_everybody_is_met_from_student_to_student(address, folder):
    names = ["Ann Lee", "Ben Ito", "Bo Ahn", "Cem <b>Kaya"]
    for at, name in enumerate(names):
        _, page, _ = get(address + keys(folder)[name] + ".html")
        assert f"<span>{at + 1} of 4</span>" in page
        after = keys(folder)[names[at + 1]] + ".html" if at < 3 else "#"
        assert f'id="next" href="{after}"' in page
    told = post(address + keys(folder)["Bo Ahn"] + ".html", {"exercise": "ch02.q1", "points": "1"})
    assert told["total"] == "1" and told["status"] == "Nothing handed in"
    assert post(address + keys(folder)["Bo Ahn"] + ".html", {"exercise": "ch02.q1", "points": ""})["total"] == "0"


@WALLS
def test_the_verdict_is_told_as_it_is_after_saving(address, folder):
    url = f"{address}{keys(folder)['Cem <b>Kaya']}.html"
    said = post(url, {"exercise": "ch02.q1", "points": "0.5"})
    assert "<b>0.5</b> of 1 point" in said["verdict"] and "given by hand" in said["verdict"] and said["status"] == "Graded"
    assert said["verdict"] in get(url)[1]
    said = post(url, {"exercise": "ch02.q1", "points": ""})
    assert "<b>1</b> of 1 point" in said["verdict"] and "given by hand" not in said["verdict"]


@pytest.mark.parametrize(
    ("body", "why"),
    [
        (b"{", "Expecting"),
        ([1], "list indices"),
        ({"exercise": "ch02.q1", "points": "many"}, "points are a number from 0 on"),
        ({"exercise": "ch02.q1", "points": "nan"}, "points are a number from 0 on"),
        ({"exercise": "ch02.q9", "points": "1"}, "there is no ch02.q9"),
        ({"exercise": "", "comment": "x" * 6000}, "5000 letters at the most"),
    ],
)
def test_what_cannot_be_saved_is_said(address, folder, body, why):
    assert why in post(address + keys(folder)["Ben Ito"] + ".html", body)["error"]


def test_points_and_words_hold_in_table_pages_and_later_runs(address, folder, monkeypatch):
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    key = keys(folder)["Ben Ito"]
    url = f"{address}{key}.html"
    assert post(url, {"exercise": "ch02.q2", "points": "1,5"}) ["total"] == "2.5"
    assert post(url, {"exercise": "ch02.q2", "comment": "Nearly.\n<b>The name</b>"}) ["total"] == "2.5"
    assert post(url, {"exercise": "", "comment": "=Well done"}) ["total"] == "2.5"
    assert post(url, {"exercise": "ch02.q1", "points": "20"})["told"] == "Saved: 20 of 1, a bonus"
    assert post(url, {"exercise": "ch02.q1", "points": "0"}) ["total"] == "1.5"
    assert post(url, {"exercise": "ch02.q1", "points": ""}) ["total"] == "2.5"
    row = rows(folder.parent / "grades.csv")["Ben Ito"]
    assert (row["total"], row["comment"]) == ("2.5", "'=Well done")
    status, after = grade(folder, "--again", "--roster", folder.parent / "roster.txt")
    assert status == 0 and after["Ben Ito"]["total"] == "2.5" and after["Ben Ito"]["comment"] == row["comment"]
    page = (folder.parent / "grades" / f"{key}.html").read_text(encoding="utf-8")
    assert "Nearly.<br>&lt;b&gt;The name&lt;/b&gt;" in page and "given by hand" in page
