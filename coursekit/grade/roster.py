"""The students of a class: a learning platform's export, a table, or a text with one name per line."""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from coursekit.words.counting import counted

from .moodle_sheet import participants
from .roster_formats import HEADINGS, Layout, is_nobody, is_test, layout_of, parted
from .sanitizing import shown
from .tables import COMMA, Form, Table, decoded, read_table


def student_word(student: str) -> str:
    """Convert a name for use in file names.

    >>> student_word("Vera de la Course")
    'VeraDeLaCourse'
    """
    return "".join(word[:1].upper() + word[1:] for word in re.findall(r"\w+", student))


def plain(name: str) -> str:
    """Normalise a name to compare different spellings.

    >>> plain("Núria O'Neill") == plain("nuria_oneill")
    True
    """
    return re.sub(r"[\W_]", "", unicodedata.normalize("NFKD", name)).casefold()


@dataclass(frozen=True)
class Person:
    """A member of a class."""

    name: str
    """The displayed name, given names first."""
    id: str = ""
    """The school's id of the person."""
    email: str = ""
    family: str = ""
    given: str = ""
    login: str = ""
    number: str = ""
    """The platform's identifier of the person: Moodle's participant, Canvas's user."""
    when: str = ""
    """The submission time recorded by the platform."""
    row: int = -1
    """The row in the list."""

    @property
    def identity(self) -> str:
        """The key, which survives corrections of the name: the id, else the e-mail, else the name."""
        return self.id or self.email.casefold() or self.name

    def names(self) -> list[str]:
        """Return the name in all orders used by platforms."""
        parts = [f"{self.given} {self.family}", f"{self.family} {self.given}"] if self.family and self.given else []
        return [self.name, *parts]

    def keys(self) -> list[str]:
        """Return other unique keys of the person: id, e-mail, its part before the @, login."""
        return [key for key in (self.id, self.email, self.email.partition("@")[0], self.login) if key]


class Roster:
    """A class.

    >>> Roster(["Ann Lee", "Ben Ito"]).told()
    '2 students'
    """

    def __init__(
        self,
        people: Iterable[str | Person],
        table: Table | None = None,
        layout: Layout | None = None,
        notes: Sequence[str] = (),
    ) -> None:
        self.people = [Person(person) if isinstance(person, str) else person for person in people]
        self.table, self.layout = table, layout
        """The original list, for handing grades back in it."""
        self.notes = list(notes)
        """Notes on omitted lines."""
        _expect_different(self.people)
        twice = Counter(plain(person.name) for person in self.people)
        self._labels = {
            person: f"{person.name} ({person.id or person.email})" if twice[plain(person.name)] > 1 else person.name
            for person in self.people
        }

    @property
    def students(self) -> list[str]:
        """The unique names in this class, with the id where names are equal."""
        return list(self._labels.values())

    @property
    def form(self) -> Form:
        """The CSV format of its table, which its spreadsheet opens."""
        return COMMA if self.table is None else self.table.form

    def label(self, person: Person) -> str:
        """Return the unique name of a person in this class."""
        return self._labels.get(person, person.name)

    def told(self) -> str:
        """Return the number of people, and the columns recognised."""
        if self.layout is None or self.table is None:
            return counted(len(self.people), "student")
        named = ((what, self.table.headings[at]) for what, at in self.layout.places.items())
        columns = ", ".join(f"{what}: '{shown(heading)}'" for what, heading in named)
        return f"{counted(len(self.people), 'student')}; {columns}"

    @classmethod
    def read(cls, file: Path) -> Roster:
        """Read the people from a file: a table with headings, else one name per line.

        Raises:
            ValueError: when it has none, two are indistinguishable, or a row is invalid.
        """
        if not file.is_file():
            raise ValueError(f"There is no file '{file}'. Give one with a student's name on each line, or a table.")
        if file.suffix.casefold() not in (".csv", ".tsv"):
            first = decoded(file.read_bytes()).partition("\n")[0]
            if not any(separator in first for separator in ";\t,") or layout_of(re.split("[;,\t]", first)) is None:
                return cls._of_lines(file)
        return cls._of_table(read_table(file), file)

    @classmethod
    def _of_lines(cls, file: Path) -> Roster:
        names = [line.strip() for line in decoded(file.read_bytes()).splitlines() if plain(line)]
        if not names:
            raise ValueError(f"There are no names in {file}. Write one on each line.")
        return cls([_person(Layout("", {"name": 0}), [line], at) for at, line in enumerate(names)])

    @classmethod
    def _of_table(cls, table: Table, file: Path) -> Roster:
        layout = _with_numbers(layout_of(table.headings), table)
        if layout is None and any(heading.strip().casefold() in HEADINGS for heading in table.headings):
            raise ValueError(f"No column of {file} is one of names. Call it 'name', or: 'given name' and 'family name'.")
        if layout is None:  # no headings: the first column has the names
            layout = Layout("", {"name": 0})
            table = replace(table, headings=[""] * len(table.headings), rows=[table.headings, *table.rows])
        people, notes = [], []
        for at, row in enumerate(table.rows):
            if is_nobody(row) or not any(plain(cell) for cell in row):
                continue
            person = _person(layout, row, at)
            if is_test(person.name) or is_test(layout.of(row, "name")) or is_test(person.login):
                notes.append(f"'{person.name}' is the platform's made-up student: left out.")
            elif plain(person.name) or person.keys():
                people.append(person)
            else:
                raise ValueError(f"Row {at + 2} of {file} has neither name nor id. Fill it in, or delete the row.")
        if not people:
            raise ValueError(f"There are no names in {file}. Write one on each line.")
        return cls(people, table, layout, notes)

    def of(self, label: str) -> Person | None:
        """Return the person of that label, id, e-mail, login, name or unambiguous part of a name; else None.

        >>> group = Roster(["Ann Lee", "Ann Ito"])
        >>> group.of("ito").name, group.of("Ann")
        ('Ann Ito', None)
        """
        if not label.strip():
            return None  # an empty text must not match people without id, e-mail or login
        exact = [person for person in self.people if label in (self.label(person), person.id, person.email, person.login)]
        named = exact or [person for person in self.people if plain(label) in {plain(name) for name in person.names()}]
        wanted = {plain(word) for word in re.split(r"[\W_]+", label)} - {""}
        people = named or [person for person in self.people if wanted and wanted <= _words_of(person)]
        return people[0] if len(people) == 1 else None


def _with_numbers(layout: Layout | None, table: Table) -> Layout | None:
    """Return the layout with Moodle's numbers, recognised by content; names follow them in its worksheet."""
    place = participants(table)
    if place is None:
        return layout
    places = {what: at for what, at in (layout.places if layout else {}).items() if at != place} | {"number": place}
    if not set(places) & {"name", "given", "family"} and place + 1 < len(table.headings):
        places["name"] = place + 1
    return Layout("moodle", places)


def _person(layout: Layout, row: Sequence[str], at: int) -> Person:
    family, given, name = layout.of(row, "family"), layout.of(row, "given"), layout.of(row, "name")
    if name and not (family and given):
        family, given = parted(name)
    if family or given:
        name = f"{given} {family}".strip()
    facts = {what: layout.of(row, what) for what in ("id", "email", "login", "number", "when")}
    facts = {what: shown(text) for what, text in facts.items()}
    facts["number"] = re.sub(r"\D", "", facts["number"])
    name = shown(name or facts["email"] or facts["id"])
    return Person(name, family=shown(family), given=shown(given), row=at, **facts)


def _words_of(person: Person) -> set[str]:
    return {plain(word) for name in person.names() for word in re.split(r"[\W_]+", name)}


def _expect_different(people: Sequence[Person]) -> None:
    """Require unique ids, e-mails and logins; people of the same name need them."""
    for what in ("id", "email", "login"):
        count = Counter(getattr(person, what).casefold() for person in people)
        twice = [person for person in people if getattr(person, what) and count[getattr(person, what).casefold()] > 1]
        if twice:
            names = ", ".join(person.name for person in twice)
            raise ValueError(f"These have the same {what} '{getattr(twice[0], what)}': {names}. Mend the list.")
    count = Counter(plain(person.name) for person in people)
    twice = [person for person in people if count[plain(person.name)] > 1 and not (person.id or person.email)]
    if twice:
        names = ", ".join(person.name for person in twice)
        raise ValueError(f"Students have the same name: {names}. Tell them apart by an id, an e-mail or a number.")
