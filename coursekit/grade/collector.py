"""Find each person's submission and the file that counts for each chapter; ambiguities become questions.

The data flow is: entries of a folder or zip, their owners, the file that counts for each chapter.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from coursekit.words.counting import counted

from .chapter_files import choose
from .entries import entries_of_folder, entries_of_zip
from .identifying import SURE, Identified, Identifier, without_ending
from .lateness import Policy, platform_time
from .person_submission import PersonSubmission
from .platform_names import platform_name
from .questions import NOBODY, Question, numbered
from .recognising import Recogniser
from .roster import Person, Roster, plain, student_word
from .sanitizing import identity_of, shown, unique
from .submission_parts import LISTED, SEALED, Entry, Gatherer, Piece, Raw
from .submission_split import Part, parts_of, whole


@dataclass
class Collection:
    """The work of a class."""

    handed: list[PersonSubmission]
    questions: list[Question]
    """All questions, answered or not."""
    told: list[str]
    """Messages about entries that do not belong to one person."""
    unanswered: list[Question] = field(default_factory=list)
    whose: list[tuple[str, Question]] = field(default_factory=list)
    """Entries without an owner so far."""


class Collector:
    """Collects for a class."""

    def __init__(
        self,
        sources: Mapping[str, Mapping[str, Any]],
        scratch: Path,
        *,
        roster: Roster | None = None,
        copies: Mapping[str, Person] | None = None,
        policy: Policy | None = None,
        answers: Mapping[str, str] | None = None,
    ) -> None:
        self._gatherer = Gatherer(Recogniser(sources), scratch)
        self._recogniser = Recogniser(sources)
        self._roster = roster
        self._identifier = Identifier(roster, copies) if roster else None
        self._knows_marks = bool(copies)
        self._policy = policy or Policy()
        self._answers = answers or {}
        self._people: dict[str, PersonSubmission] = {}
        self._made = Collection([], [], list(roster.notes) if roster else [])

    def collect(self, place: Path, leave: Iterable[Path] = ()) -> Collection:
        """Collect all submissions from a folder, or from the zip of a learning platform."""
        for person in self._roster.people if self._roster else []:
            self._of(person)
        for name, loose, files in self._entries(place, leave):
            entry = self._gathered(name, files)
            if loose and not entry.pieces and not self._is_somebody_s(name):
                self._made.told.append(f"'{shown(name)}' is no notebook, zip or folder: left out.")
            else:
                self._put(entry)
        for handed in self._people.values():
            self._choose(handed)
            self._look_for_other_s_copies(handed)
        self._made.handed = sorted(self._people.values(), key=lambda person: (plain(person.label), person.key))
        self._look_alike()
        self._look_for_marks()
        self._made.unanswered += [owner for _, owner in self._made.whose]
        return self._made

    def _gathered(self, name: str, files: Iterable[Raw]) -> Entry:
        try:
            return self._gatherer.entry(name, files)
        except Exception as error:  # one unforeseen hand-in must never stop the class
            return Entry(name, faults=[f"it cannot be read ({type(error).__name__}: {shown(str(error), 100)})"])

    def _entries(self, place: Path, leave: Iterable[Path]) -> Iterable[tuple[str, bool, Iterable[Raw]]]:
        return entries_of_folder(place, leave) if place.is_dir() else entries_of_zip(place)

    def _is_somebody_s(self, name: str) -> bool:
        """Whether a file that is neither notebook nor zip is a submission, and not a stray table or picture."""
        known = self._identifier is not None and len(self._identifier.by_name(name).people) == 1
        return known or platform_name(name) is not None

    def _of(self, person: Person) -> PersonSubmission:
        label = self._roster.label(person) if self._roster else shown(person.name)
        return self._people.setdefault(person.identity, PersonSubmission(person, label))

    def _put(self, entry: Entry) -> None:
        """Assign an entry to its owner, or ask; an entry with several people's copies is divided."""
        for part in parts_of(entry, self._identifier) if self._identifier is not None else [self._by_itself(entry)]:
            identified = part.found
            if len(identified.people) != 1:
                question = self._whose(part)
                self._made.questions.append(question)
                identified = self._answered(part, question, question.chosen(self._answers))
            if len(identified.people) == 1:
                handed = self._of(identified.people[0])
                handed.entries.append(part.entry)
                if identified.how and identified.how not in SURE:
                    handed.concerns.append(f"'{part.where}' was taken as theirs by {identified.how}")

    def _whose(self, part: Part) -> Question:
        people = part.found.people or (self._identifier.maybe(part.entry.name) if self._identifier else ())
        choices = tuple(self._roster.label(person) for person in people) if self._roster else ()
        about = f"{part.where} ({part.found.how}; {counted(len(part.entry.pieces), 'notebook')})"
        text = "Whose is this? Write the name, id or e-mail; or: nobody."
        return Question(numbered("whose", *part.about), text, about, choices)

    def _answered(self, part: Part, question: Question, said: str) -> Identified:
        if said.casefold() == NOBODY:
            self._made.told.append(f"'{part.where}' is nobody's, as answered: left out.")
            return Identified()
        person = self._roster.of(said) if self._roster else Person(shown(said)) if said else None
        if person is not None:
            return Identified((person,), "")
        why = f"the answer '{shown(said, 60)}' is not one person of the list" if said else part.found.how
        question = replace(question, about=f"{question.about}; {why}") if said else question
        self._made.whose.append((part.where, question))
        for someone in part.found.people:
            self._of(someone).open.append(f"whose '{part.where}' is: {why}")
        return Identified()

    def _by_itself(self, entry: Entry) -> Part:
        """Return the whole of an entry, if there is no roster."""
        person = self._without_list(entry)
        owner = Identified((person,), "") if person else Identified((), "its name is that of a chapter, not of a person")
        return whole(entry, owner)

    def _without_list(self, entry: Entry) -> Person | None:
        """Return the person named by an entry's name or content."""
        stem = without_ending(entry.name)
        told = platform_name(entry.name)
        if told is not None and (told.name or told.logins):
            name = shown(told.name or told.logins[0])
            return Person(name, number=told.number, id=f"{identity_of(name)} {told.number}".strip())
        for student in unique(entry.students):
            if plain(stem).startswith(plain(student_word(student))):
                return Person(student, id=identity_of(student))
        loose = ".ipynb" in entry.name.casefold() or entry.name.casefold().endswith((".json", ".txt"))
        chapter = self._recogniser.by_name(stem + ".ipynb") if loose else ""
        if chapter:
            before = re.split(re.escape(Path(chapter).stem), stem, maxsplit=1, flags=re.I)[0].strip(" _-.")
            return Person(shown(before), id=identity_of(before)) if identity_of(before) else None
        return Person(shown(stem), id=identity_of(stem) or shown(stem))

    def _look_for_other_s_copies(self, handed: PersonSubmission) -> None:
        """Note that a copy was made for another student, even if the teacher assigned it."""
        for piece in handed.chosen.values():
            owner = self._identifier.owner(piece.known.copy) if self._identifier is not None else None
            if owner is not None and owner != handed.person and self._roster is not None:
                handed.concerns.append(f"{shown(piece.where)}: the copy was made for {self._roster.label(owner)}")

    def _look_for_marks(self) -> None:
        """Report copies with marks that cannot be read without the release's secret: then only names decide."""
        marked = any(piece.known.copy for handed in self._people.values() for piece in handed.pieces())
        if self._roster is not None and not self._knows_marks and marked:
            missing = "the .secret of the list that they were released with is not beside this list"
            self._made.told.append(f"There are copies with a mark, but {missing}: only names tell whose they are.")

    def _choose(self, handed: PersonSubmission) -> None:
        """Choose the file that counts for each chapter."""
        deadline = self._policy.deadline(handed.person)
        listed = platform_time(handed.person.when)
        by_chapter: dict[str, list[Piece]] = {}
        for entry in handed.entries:
            entry.pieces = [_listed(piece, listed) for piece in entry.pieces]
            for piece in entry.pieces:
                by_chapter.setdefault(piece.chapter, []).append(piece)
            handed.notes += entry.faults
            handed.concerns += entry.concerns
        self._take_apart(handed, by_chapter)
        others = [name for entry in handed.entries for name in entry.others]
        if handed.entries and not by_chapter and not handed.notes:
            only = f", only {', '.join(others[:5])}" if others else ""
            handed.notes.append(f"no notebook was handed in{only}")
        nameless = [self._chapter_of(piece, handed, bool(by_chapter)) for piece in by_chapter.pop("", ())]
        for piece in (piece for piece in nameless if piece.chapter):
            by_chapter.setdefault(piece.chapter, []).append(piece)
        for chapter, pieces in sorted(by_chapter.items()):
            choice = choose(pieces, handed.label, self._policy.count, deadline, self._answers)
            if choice.question is not None:
                self._made.questions.append(choice.question)
            if choice.piece is None:
                assert choice.question is not None
                self._made.unanswered.append(choice.question)
                handed.open.append(f"which file is {chapter}: {choice.question.about}")
            elif choice.piece.fault:
                handed.notes.append(f"{choice.piece.where}: {choice.piece.fault}")
            else:
                handed.chosen[chapter] = choice.piece
                handed.notes += [choice.why] if choice.why else []
                if choice.piece.known.level == 0:
                    handed.concerns.append(f"{choice.piece.where}: nothing was written in it")

    def _take_apart(self, handed: PersonSubmission, by_chapter: dict[str, list[Piece]]) -> None:
        """Use a notebook with exercises of two chapters for both, unless the other chapter has its own notebook."""
        own = set(by_chapter)
        for entry in handed.entries:
            for piece in list(entry.pieces):
                for known in piece.also:
                    stem = Path(known.chapter).stem
                    if known.chapter in own:
                        said = f"exercises of {stem} are in it, too: they do not count beside a notebook of that chapter"
                    else:
                        said = f"exercises of {stem} are in it, too: they count as that chapter"
                        part = replace(piece, chapter=known.chapter, known=known, also=())
                        entry.pieces.append(part)
                        by_chapter.setdefault(known.chapter, []).append(part)
                    handed.concerns.append(f"{piece.where}: {said}")

    def _chapter_of(self, piece: Piece, handed: PersonSubmission, others: bool) -> Piece:
        """Find the chapter of a notebook that neither content nor name gives; ask if the person handed in nothing else."""
        if piece.fault or others or not piece.known.work:
            why = piece.fault or "it holds no exercise of the chapters"
            (handed.concerns if others else handed.notes).append(f"{piece.where}: {why}")
            return piece
        names = tuple(self._recogniser.chapters)
        text = f"Which chapter is this notebook of {handed.label}? Write its name; or: none."
        question = Question(numbered("chapter", handed.key, piece.digest), text, piece.where, names)
        said = question.chosen(self._answers)
        self._made.questions.append(question)
        if said in names:
            return replace(piece, chapter=said)
        if said.casefold() == "none":
            handed.notes.append(f"{piece.where}: it holds no exercise of the chapters")
        else:
            self._made.unanswered.append(question)
            handed.open.append(f"which chapter {piece.where} is")
        return piece

    def _look_alike(self) -> None:
        """Report, without a roster, spellings that may be one person, and a folder that may be a whole class."""
        if self._roster is not None:
            return
        if len(self._made.handed) == 1:
            self._look_for_a_class(self._made.handed[0])
        seen: dict[str, str] = {}
        for handed in self._made.handed:
            other = seen.setdefault(plain(re.sub(r" ?\(\d+\)$", "", handed.label)), handed.label)
            if other != handed.label:
                self._made.told.append(f"'{other}' and '{handed.label}' look like one name: give the class with --roster.")


    def _look_for_a_class(self, only: PersonSubmission) -> None:
        """Report a student with everybody's work: the folder above that of the class was given."""
        for name, pieces in itertools.groupby(
            sorted(only.pieces(), key=lambda piece: piece.chapter), lambda piece: piece.chapter
        ):
            folders = unique(str(Path(piece.where).parent) for piece in pieces)
            if name and len(folders) > 1:
                stem, many = Path(name).stem, len(folders)
                said = f"'{only.label}' is taken as one student, and {stem} lies in {many} folders of it"
                cure = f"If these are students, give '{only.label}' itself, or the class with --roster."
                self._made.told.append(f"{said}. {cure}")
                return


def _listed(piece: Piece, when: float) -> Piece:
    """Set the time from the platform's list, if neither a seal nor the download has one."""
    if not when or piece.when_from in (SEALED, "the platform's time"):
        return piece
    return replace(piece, when=when, when_from=LISTED)
