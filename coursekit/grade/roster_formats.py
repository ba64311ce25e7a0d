"""Learning platforms' exports of class lists, and their columns of names, e-mails and ids."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

COLUMNS: dict[str, tuple[str, ...]] = {
    "given": ("first name", "given name", "given names", "first names", "firstname", "nombre", "vorname", "prénom",
              "nome", "voornaam"),
    "family": ("last name", "surname", "family name", "family names", "lastname", "apellidos", "apellido(s)", "nachname",
               "nom de famille", "nom", "cognome", "sobrenome", "apelido", "achternaam"),
    "name": ("student", "students", "name", "names", "full name", "student name", "nombre completo", "display name"),
    "email": ("email", "e-mail", "email address", "e-mail address", "mail", "correo", "dirección de correo",
              "e-mail-adresse", "adresse de courriel", "courriel", "adresse e-mail", "indirizzo email",
              "endereço de email", "e-mailadres"),
    "id": ("id number", "student id", "sis user id", "studentid", "student number", "matricula", "matrícula",
           "número de id", "id-nummer", "matrikelnummer", "numéro d'identification", "numéro d'étudiant",
           "codice identificativo",
           "matricola", "número de identificação", "studentnummer", "user id", "id"),
    "login": ("username", "user name", "sis login id", "login id", "login", "usuario"),
    "number": ("identifier",),
    "when": ("last modified (submission)", "submitted", "submission time", "submitted at", "last submitted"),
}  # fmt: skip
"""Headings by meaning, in order of priority, for Moodle, Canvas, Blackboard and Google Classroom."""
HEADINGS = frozenset(word for words in COLUMNS.values() for word in words)
_MOODLE = {"identifier", "id number", "número de id", "id-nummer", "numéro d'identification", "codice identificativo"}
"""Names of Moodle's column in some languages."""
_NOBODY = re.compile(r"points possible|puntos posibles|possible points", re.I)
_TEST = re.compile(r"(?:student, test|test student|\w+_previewuser)", re.I)


@dataclass(frozen=True)
class Layout:
    """The columns of a table."""

    platform: str
    """moodle, canvas, blackboard, classroom, or '' for a plain table."""
    places: Mapping[str, int]

    def of(self, row: Sequence[str], what: str) -> str:
        """Return a cell of a row, or ''."""
        place = self.places.get(what, len(row))
        return row[place].strip() if place < len(row) else ""


def layout_of(headings: Sequence[str]) -> Layout | None:
    """Recognise the layout from a row of headings; None if it is not one."""
    known = [re.sub(r"\s+", " ", heading.strip().strip('"').casefold().replace("’", "'")) for heading in headings]
    places: dict[str, int] = {}
    for what, words in COLUMNS.items():
        place = next((known.index(word) for word in words if word in known), None)
        if place is not None:
            places[what] = place
    if not set(places) & {"name", "given", "family", "email"}:
        return None
    platform = _platform(known)
    if platform == "canvas" and "id" in known:
        places["number"] = known.index("id")
        places["id"] = next((known.index(heading) for heading in ("sis user id",) if heading in known), known.index("id"))
    return Layout(platform, places)


def _platform(known: Sequence[str]) -> str:
    if "sis user id" in known or ("student" in known and "section" in known):
        return "canvas"
    if _MOODLE & set(known) or "last downloaded from this course" in known:
        return "moodle"
    if {"last name", "first name", "username"} <= set(known):
        return "blackboard"
    return "classroom" if {"last name", "first name", "email address"} <= set(known) else ""


def is_nobody(row: Sequence[str]) -> bool:
    """Whether a row contains the maximum points instead of a person."""
    return any(_NOBODY.search(cell) for cell in row[:3])


def is_test(name: str) -> bool:
    """Whether a name is a platform's artificial test student."""
    return bool(_TEST.fullmatch(name.strip()))


def parted(name: str) -> tuple[str, str]:
    """Split a name at its comma into family and given names.

    >>> parted("García López, Ana"), parted("Ann Lee")
    (('García López', 'Ana'), ('', ''))
    """
    family, comma, given = (part.strip() for part in name.partition(","))
    return (family, given) if comma and family and given else ("", "")
