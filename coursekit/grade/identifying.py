"""The student of a submission, by the copy's mark, the exact name, the platform's pattern, or a name within the name.

Each method may find one person, several, or none. The first that finds one decides, unless an equally reliable one
finds another person. Then the teacher is asked.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from .platform_names import PlatformName, platform_name
from .roster import Person, Roster, plain

COPY_AND_NAME = "the mark of the copy and a name"
SURE = ("the exact name", "the platform's name for it", "the name that hand_in gives its files", COPY_AND_NAME)
"""Methods that are not reported each time."""
_ENDINGS = (".ipynb", ".zip", ".txt", ".html", ".pdf", ".py", ".docx", ".json")


@dataclass(frozen=True)
class Identified:
    """The student found, and the method."""

    people: tuple[Person, ...] = ()
    """One person is a result; none or several become a question."""
    how: str = ""


def named_in(name: str, roster: Roster) -> str:
    """Return the student named by a folder or file; '' if there is none, or it is ambiguous.

    >>> named_in("annleeds_1234_AnnLeeds_03_services", Roster(["Ann Lee", "Ann Leeds"]))
    'Ann Leeds'
    """
    identified = Identifier(roster).by_name(name)
    return roster.label(identified.people[0]) if len(identified.people) == 1 else ""


class Identifier:
    """Knows a class, and the marks of its copies.

    >>> someone = Identifier(Roster([Person("Ana García López", family="García López", given="Ana")]))
    >>> someone.by_name("García López Ana_101_assignsubmission_file_").how
    "the platform's name for it"
    """

    def __init__(self, roster: Roster, copies: Mapping[str, Person] | None = None) -> None:
        self.roster = roster
        self._copies = copies or {}

    def owner(self, copy: str) -> Person | None:
        """Return the student for whom a copy with this mark was made."""
        return self._copies.get(copy)

    def identify(self, name: str, copies: Iterable[str] = ()) -> Identified:
        """Identify the student of a folder or file by its name, and by the marks of the copies in it."""
        marked = {self._copies[copy] for copy in copies if copy in self._copies}
        named = self.by_name(name)
        if len(marked) > 1:
            return Identified(self._sorted(marked), "it holds copies of several students")
        if not marked:
            return named
        owner = next(iter(marked))
        if not named.people or named.people == (owner,):
            return Identified((owner,), COPY_AND_NAME if named.people else "the mark of the copy")
        if len(named.people) > 1 and owner in named.people:
            return Identified((owner,), "the mark of the copy")
        others = self._sorted({owner, *named.people})
        return Identified(others, f"the copy was made for {self.roster.label(owner)}, the name is another student's")

    def by_name(self, name: str) -> Identified:
        """Identify the student by the name alone."""
        given = platform_name(name)
        stem = without_ending(name)
        for how, people in (
            ("the exact name", self._exactly([stem, *(given.logins if given else ())], name_only=given is None)),
            ("the platform's name for it", self._of_platform(given)),
            ("the same words in another order", self._shuffled.get(_words(given.name if given else stem), set())),
        ):
            if people:
                return Identified(self._sorted(people), how if len(people) == 1 else "several have that name")
        if given is not None and given.platform in ("moodle", "canvas", "blackboard"):
            return Identified((), "no student in the list has that name")
        people = self._inside(given.name if given else stem)
        if len(people) == 1 and people == self._plain.get(plain(stem.partition("_")[0])):
            return Identified(tuple(people), "the name that hand_in gives its files")
        return Identified(self._sorted(people), ("a name in the name" if len(people) == 1 else "several names fit") if people
                          else "no student in the list has that name")  # fmt: skip

    def maybe(self, name: str) -> tuple[Person, ...]:
        """Return people whose names share a word with it: choices for a question, not an answer.

        >>> [one.name for one in Identifier(Roster(["Ana García", "Luz García", "Ben Ito"])).maybe("garcia.ipynb")]
        ['Ana García', 'Luz García']
        """
        words = {plain(word) for word in re.split(r"[\W_]+", without_ending(name))} - {""}
        parts = {person: {plain(part) for text in person.names() for part in text.split()} for person in self.roster.people}
        return tuple(person for person, own in parts.items() if words & own)

    def _exactly(self, texts: Sequence[str], *, name_only: bool) -> set[Person]:
        if name_only:
            return self._spelled.get(_letters(texts[0]), set()) or self._plain.get(plain(texts[0]), set())
        return {person for text in texts for person in self._keys.get(plain(text), ())}

    def _of_platform(self, given: PlatformName | None) -> set[Person]:
        if given is None:
            return set()
        numbered = {person for person in self.roster.people if given.number and person.number == given.number}
        spelled = self._spelled.get(_letters(given.name), set()) if given.name else set()
        named = spelled or (self._plain.get(plain(given.name), set()) if given.name else set())
        if numbered and named and not numbered & named:
            return numbered | named
        return numbered & named or numbered or named

    def _inside(self, text: str) -> set[Person]:
        """Return people whose name or id is in the text as whole words; the longest names take precedence."""
        words = [plain(word) for word in re.split(r"[\W_]+", text) if plain(word)]
        spans: list[tuple[int, int, Person]] = []
        for begin in range(len(words)):
            for end in range(begin + 1, min(len(words), begin + 8) + 1):
                key = "".join(words[begin:end])
                if not (key.isdigit() and len(key) < 5):
                    spans += [(begin, end, person) for person in self._plain.get(key, ())]
        longest = [
            person for begin, end, person in spans
            if not any(b <= begin and end <= e and (e - b) > (end - begin) for b, e, _ in spans)
        ]  # fmt: skip
        return set(longest)

    @cached_property
    def _spelled(self) -> dict[str, set[Person]]:
        """The people by name with accents, and by key."""
        return _table(
            (_letters(name), person) for person in self.roster.people for name in (*person.names(), *person.keys())
        )

    @cached_property
    def _plain(self) -> dict[str, set[Person]]:
        return _table((plain(name), person) for person in self.roster.people for name in (*person.names(), *person.keys()))

    @cached_property
    def _shuffled(self) -> dict[str, set[Person]]:
        return _table((_words(name), person) for person in self.roster.people for name in person.names())

    @cached_property
    def _keys(self) -> dict[str, set[Person]]:
        return _table((plain(key), person) for person in self.roster.people for key in person.keys())  # noqa: SIM118

    def _sorted(self, people: Iterable[Person]) -> tuple[Person, ...]:
        return tuple(person for person in self.roster.people if person in set(people))


def _table(pairs: Iterable[tuple[str, Person]]) -> dict[str, set[Person]]:
    table: dict[str, set[Person]] = {}
    for key, person in pairs:
        if key:
            table.setdefault(key, set()).add(person)
    return table


def _letters(text: str) -> str:
    return re.sub(r"[\W_]", "", unicodedata.normalize("NFKC", text)).casefold()


def _words(name: str) -> str:
    """Return two or more words of a name in alphabetical order; empty for fewer."""
    words = sorted(plain(word) for word in re.split(r"[\W_]+", name) if plain(word))
    return " ".join(words) if len(words) > 1 else ""


def without_ending(name: str) -> str:
    """Remove the file suffixes from a name.

    >>> without_ending("Ann Lee.ipynb.txt"), without_ending("Dr. Lee")
    ('Ann Lee', 'Dr. Lee')
    """
    while Path(name).suffix.casefold() in _ENDINGS:
        name = Path(name).stem
    return name
