"""Marks and pages for the learning platform: a table with its columns, and the pages as a zip for Moodle."""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Sequence
from pathlib import Path, PurePosixPath

from coursekit.words.gettext import gettext, speaking

from .identifying import Identifier
from .lateness import late_by
from .moodle_sheet import comment_column, mark_column, maximum_column
from .platform_names import moodle_folder, platform_name
from .record import Record
from .report import page
from .roster import Person, Roster
from .sanitizing import cell, number, shown
from .tables import COMMA, Form, Table, write_table


def hand_back(
    platform: str, records: Sequence[Record], roster: Roster | None, out: Path, form: Form = COMMA
) -> list[Path]:
    """Write the platform's table, and for Moodle the zip of pages if its numbers are known. Returns the files.

    A platform's own list keeps its CSV format. For new tables, Moodle accepts every format.
    """
    table = out.with_name(f"{out.stem}.{platform}.csv")
    title = _title(records)
    rows = roster.table if roster is not None and roster.layout is not None and roster.layout.platform == platform else None
    if roster is not None and rows is not None:
        form = rows.form
        headings, filled = _in_list(platform, records, roster, title)
    else:
        form = form if platform == "moodle" else COMMA
        headings, filled = _of_own(platform, records, title, form)
    write_table(table, headings, filled, form)
    feedback = _feedback(records, roster, out.with_name(f"{out.stem}.feedback.zip")) if platform == "moodle" else []
    return [table, *feedback]


def _title(records: Sequence[Record]) -> str:
    chapters = list(records[0].wanted) if records else []
    return "coursekit " + " ".join(PurePosixPath(name).stem.partition("_")[0] for name in chapters)


def _mark(record: Record, form: Form) -> str:
    """Return the mark; empty without a mark, so that the platform keeps its value."""
    total = record.total()
    return "" if total is None else form.number(total)


def _said(record: Record) -> str:
    """Return a sentence for the student, which begins with the reason if nothing could be marked."""
    marked = record.marked()
    late = marked.minutes_late
    with speaking(record.language()):
        words = list(map(gettext, marked.notes[-1:])) if record.handed.entries and not record.handed.chosen else []
        words += [gettext(f"{number(v.points)} of {number(v.of)} for {v.name}") for v in marked.verdicts]
        words += [gettext(f"{late_by(late)} late")] if late else []
    return "; ".join([*words, *record.comments().values()])


def _in_list(platform: str, records: Sequence[Record], roster: Roster, title: str) -> tuple[list[str], list[list[str]]]:
    """Insert the marks into the platform's own list: rows and columns stay."""
    assert roster.table is not None
    form, headings = roster.table.form, list(roster.table.headings)
    column, comment = _columns(platform, roster.table, headings, title)
    by_row = {record.handed.person.row: record for record in records}
    of = records[0].of() if records else 0.0
    rows = []
    for at, row in enumerate(roster.table.rows):
        cells = [*row, *[""] * len(headings)][: len(headings)]
        if at in by_row:
            cells[column] = _mark(by_row[at], form) or cells[column]
            if comment is not None:
                cells[comment] = _said(by_row[at])
        elif any("points possible" in cell.casefold() for cell in row[:3]):
            cells[column] = form.number(of)
        rows.append([_kept(text) for text in cells])
    return headings, rows


def _kept(text: str) -> str:
    """Return a cell of the platform's own list: numbers unchanged, texts made harmless."""
    return text if text.strip() == "-" or _as_number(text) is not None else cell(text)


def _as_number(text: str) -> float | None:
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return None


def unlike_the_platform_s(records: Sequence[Record], roster: Roster | None) -> str:
    """Return a warning if the platform's assignment has another maximum; empty if that is unknown."""
    table = roster.table if roster is not None else None
    place = maximum_column(table) if table is not None else None
    if table is None or place is None or not records:
        return ""
    return beside_the_platform_s(records[0].of(), [row[place] for row in table.rows if len(row) > place])


def beside_the_platform_s(of: float, maxima: Sequence[str]) -> str:
    """Return that warning for a platform's column of maxima.

    >>> beside_the_platform_s(14.0, ["14.00"])
    ''
    """
    other = next((maximum for maximum in maxima if _as_number(maximum) not in (None, of)), None)
    if other is None:
        return ""
    return (
        f"In your list the assignment's maximum grade is {shown(other)}, and these marks are of {number(of)} points. "
        f"Set the maximum to {number(of)} before you upload them, or they count too little or too much."
    )


def _columns(platform: str, table: Table, headings: list[str], title: str) -> tuple[int, int | None]:
    """Return the columns of the mark and the comment; a list without a column for marks gets one at the end."""
    mark = mark_column(table) if platform == "moodle" else None
    if mark is not None:
        return mark, comment_column(table)
    headings.append(title)
    if platform != "moodle":
        return len(headings) - 1, None
    headings.append(f"{title} comments")
    return len(headings) - 2, len(headings) - 1


def _of_own(
    platform: str, records: Sequence[Record], title: str, form: Form
) -> tuple[list[str], list[list[str]]]:
    """Return the columns that identify people on the platform, if its own list was not given."""
    known: dict[str, tuple[list[str], Callable[[Person], list[str]]]] = {
        "moodle": (["ID number", "Email address", "First name", "Last name"], lambda p: [p.id, p.email, p.given, p.family]),
        "canvas": (["Student", "ID", "SIS User ID", "SIS Login ID", "Section"],
                   lambda p: [_family_first(p), p.number, p.id, p.login or p.email, ""]),
        "blackboard": (["Last Name", "First Name", "Username", "Student ID"],
                       lambda p: [p.family, p.given or p.name, p.login or p.email.partition("@")[0], p.id]),
    }  # fmt: skip
    headings, of = known[platform]
    rows = [
        [*(cell(text) for text in of(record.handed.person)), _mark(record, form), cell(_said(record))] for record in records
    ]
    if platform == "canvas":
        return [*headings, title], [["    Points Possible", "", "", "", "", number(records[0].of() if records else 0)],
                                    *(row[:-1] for row in rows)]  # fmt: skip
    return [*headings, "Grade" if platform == "moodle" else title, "Feedback comments"], rows


def _family_first(person: Person) -> str:
    return f"{person.family}, {person.given}" if person.family and person.given else person.name


def _feedback(records: Sequence[Record], roster: Roster | None, file: Path) -> list[Path]:
    """Write the pages of those with a submission or a message, in folders named as Moodle expects."""
    folders = {folder: record for folder, record in _with_a_page(records, roster) if folder}
    if not folders:
        return []
    fresh = file.with_suffix(".new")
    with zipfile.ZipFile(fresh, "w", zipfile.ZIP_DEFLATED) as packed:
        for folder, record in folders.items():
            packed.writestr(f"{shown(folder, 250)}/feedback.html", page(record))
    fresh.replace(file)
    return [file]


def _with_a_page(records: Sequence[Record], roster: Roster | None) -> list[tuple[str, Record]]:
    """Return those with a submission or a message, and each one's folder for Moodle; '' if unknown."""
    identifier = Identifier(roster) if roster is not None else None
    return [
        (_folder(record, identifier), record)
        for record in records
        if record.counts() or record.handed.entries or record.comments()
    ]


def left_out(records: Sequence[Record], roster: Roster | None) -> str:
    """Return the students without a page in the zip, and what Moodle needs for them; empty if there are none."""
    names = [record.label for folder, record in _with_a_page(records, roster) if not folder]
    if not names:
        return ""
    more = f" and {len(names) - 5} more" if len(names) > 5 else ""
    return (
        f"The zip of pages has none for {', '.join(names[:5])}{more}: Moodle's number of them is not known. Download the "
        "assignment's grading worksheet (it has the column Identifier), and give that as --roster."
    )


def _folder(record: Record, identifier: Identifier | None) -> str:
    """Return a person's folder for Moodle: by the number in the list, else from a folder of the download with the name."""
    person = record.handed.person
    if person.number:
        return moodle_folder(person.name, person.number)
    for entry in record.handed.entries if identifier is not None else ():
        told = platform_name(entry.name)
        own = identifier is not None and identifier.by_name(entry.name).people == (person,)
        if told is not None and told.platform == "moodle" and own:
            return moodle_folder(told.name, told.number)
    return ""
