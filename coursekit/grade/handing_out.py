"""Delivery of individual copies: a list for a mail merge, and a zip that Moodle distributes."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping
from pathlib import Path

from .platform_names import moodle_folder
from .roster import Person, Roster
from .sanitizing import cell, shown
from .tables import COMMA, Form, write_table

LIST, FOR_MOODLE = "copies.csv", "moodle.zip"


def write_list(out: Path, archives: Mapping[Person, Path], form: Form = COMMA) -> Path:
    """Write copies.csv, the owners of the zips, with the columns for a mail merge."""
    rows = [
        [cell(person.name), cell(person.given or person.name), cell(person.email), cell(person.id), archive.name]
        for person, archive in archives.items()
    ]
    write_table(out / LIST, ["name", "given name", "email", "id", "file"], rows, form)
    return out / LIST


def write_for_moodle(out: Path, archives: Mapping[Person, Path]) -> Path:
    """Write moodle.zip, with each copy as a feedback file of an assignment."""
    with zipfile.ZipFile(out / FOR_MOODLE, "w", zipfile.ZIP_STORED) as packed:
        for person, archive in archives.items():
            packed.write(archive, f"{shown(moodle_folder(person.name, person.number), 250)}/{archive.name}")
    return out / FOR_MOODLE


def expect_numbers(roster: Roster) -> None:
    """Require the numbers by which Moodle identifies participants, from an assignment's grading worksheet.

    Raises:
        ValueError: when a participant has none.
    """
    without = [person.name for person in roster.people if not person.number]
    if without:
        more = f" and {len(without) - 3} more" if len(without) > 3 else ""
        who = f"{', '.join(without[:3])}{more} {'has' if len(without) == 1 else 'have'} none"
        raise ValueError(
            f"--for moodle needs Moodle's number of each student, and {who}. Make the "
            "assignment, download its grading worksheet (it has the column Identifier), and give that as --roster."
        )
