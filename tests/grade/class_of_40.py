"""A class of 40 that hands in as classes do: by platforms, folders and zips, twice, late, renamed, and some not at all."""

from __future__ import annotations

import json
from pathlib import Path

from coursekit.grade.bundle import pack_bundle
from coursekit.grade.variants import Variants

from .handed import NOON, SERVICES, SOURCES, TOPICS, notebook, text, write, zipped

HOUR = 3600
GIVEN = ("Ana", "Ben", "Cem", "Dai", "Eva", "Fay", "Gil", "Hal")
FAMILY = ("García López", "Ito", "O'Neill", "Núñez", "van den Berg")
PEOPLE = [(f"a{at:03}", given, family) for at, (given, family) in enumerate((g, f) for f in FAMILY for g in GIVEN)]
"""Id, given and family name."""
PEOPLE[13] = ("a013", "class", "")


def roster() -> str:
    """The list of the class."""
    head = "Student ID;Given name;Family name;E-mail\n"
    return head + "".join(f"{id_};{given};{family};{id_}@uni.example\n" for id_, given, family in PEOPLE)


def sealed(name: str, *done: str, chapter: str = TOPICS) -> bytes:
    """What `hand_in()` made an hour before noon; without a log."""
    facts = {"student": name, "notebook": chapter, "time": "2026-11-23 08:00:00 +0000"}
    return pack_bundle({chapter: text(*done, chapter=chapter).encode()}, facts)


def marked(mark: str, *done: str) -> str:
    """Work in the copy that was released to somebody."""
    nb = notebook(*done)
    nb["metadata"]["coursekit"]["copy"] = mark
    return json.dumps(nb)


def beside(folder: Path, name: str, number: int) -> None:
    """All four exercises, and beside them what must not count."""
    work = text("q1", "q2", "q3", "q4")
    if number == 1:
        empty = {"02_topics (backup of empty).ipynb": (text(), NOON + HOUR)}
        write(folder / f"{name}.zip", zipped({TOPICS: (work, NOON)} | empty))
    elif number == 2:
        write(folder / name / TOPICS, text("q1"), NOON - HOUR)
        write(folder / f"{name}.ipynb", work)
    elif number == 3:
        checkpoint = ".ipynb_checkpoints/02_topics-checkpoint.ipynb"
        write(folder / f"{name}.zip", zipped({checkpoint: (text("q1"), NOON + HOUR), TOPICS: (work, NOON)}))
    else:
        write(folder / name / TOPICS, work)
        write(folder / name / "02_topics.new.ipynb", text(), NOON + HOUR)
        write(folder / name / ".ipynb_checkpoints" / "02_topics-checkpoint.ipynb", text(), NOON + HOUR)


def hand_in(folder: Path, at: int, mark: str) -> tuple[str, float | None]:
    """One person hands in their way; their name, and the points that they deserve (None: the teacher is asked)."""
    id_, given, family = PEOPLE[at]
    name, way = f"{given} {family}".strip(), at % 10
    word = "".join(given.split() + family.replace("'", " ").split())
    if way == 0:
        write(folder / f"{family} {given}_{900 + at}_assignsubmission_file_" / TOPICS, text("q1", "q2"))
        return name, 3
    if way == 1:
        write(folder / f"{id_}_7{at}_8{at}_{TOPICS}", text("q1"))
        return name, 1
    if way == 2:
        write(folder / f"Week_2_{id_}_attempt_2026-11-22-10-00-00_{TOPICS}", text("q1"))
        write(folder / f"Week_2_{id_}_attempt_2026-11-23-11-00-00_{TOPICS}", text("q1", "q2", "q3"))
        write(folder / f"Week_2_{id_}_attempt_2026-11-23-11-00-00.txt", "Name: somebody")
        return name, 5
    if way == 3:
        place = folder / (f"{name} - {TOPICS}" if at < 20 else f"group 7/homework {at}.ipynb")
        write(place, marked(mark, "q4").encode("utf-8-sig" if at < 10 else "utf-8"))
        return name, 2
    if way == 4:
        beside(folder, name, at // 10)
        return name, 7
    if way == 5:
        files = {f"final/{TOPICS}": (text("q1", "q3"), NOON), f"old/{TOPICS}": (text("q1"), NOON - HOUR),
                 f"__MACOSX/final/._{TOPICS}": b"\0\5\26\7"}  # fmt: skip
        write(folder / f"{family}, {given}.zip", zipped(files))
        return name, 3
    if way == 6:
        write(folder / f"{word}_02_topics.zip", sealed(name, "q1", "q2"))
        if at < 20:
            write(folder / name / SERVICES, text("q1", chapter=SERVICES))
        else:
            write(folder / f"{word}_03_services.zip", sealed(name, "q1", chapter=SERVICES))
        return name, 3
    if way == 7:
        for place, done in (("a", "q1"), ("b", "q2")):
            write(folder / name / place / TOPICS, text(done))
        return name, None
    if way == 8:
        write(folder / id_ / TOPICS, "<html>Please log in</html>" if at % 20 == 8 else json.dumps(SOURCES[TOPICS]))
        return name, 0 if at % 20 == 8 else 7
    return name, 0


def make_class(folder: Path, list_of_class: Path) -> dict[str, float | None]:
    """Everybody hands in; what each deserves. The list is written, and the secret of the copies beside it."""
    write(list_of_class, roster().encode("utf-16"))
    marks = {person.id: mark for mark, person in Variants.read(list_of_class, new=True).copy_marks().items()}
    return dict(hand_in(folder, at, marks[PEOPLE[at][0]]) for at in range(len(PEOPLE)))
