"""`evidence("s2", graph())` and `hand_in()`: the evidence for a practice assignment, and the one file to hand in."""

from __future__ import annotations

import getpass
import html
import os
import re
import time
from pathlib import Path
from typing import Any

from coursekit.files import write_whole
from coursekit.grade import events, exchange, student_name
from coursekit.grade.bundle import EVENTS, digest_of
from coursekit.grade.copy import HANDED_OUT
from coursekit.grade.handing_in import make_bundle, who_and_where
from coursekit.grade.mark import Marked
from coursekit.grade.roster import student_word
from coursekit.grade.submissions import read_notebook
from coursekit.processes.session import current
from coursekit.systems import shell_spelling
from coursekit.view.shell import running_shell
from coursekit.words.gettext import gettext

from .cells import last_runs
from .errors import BadArgument, NotNow
from .evidence_picture import page

WHOSE = (
    'Whose is it? Write the name once, in the brackets: by="Firstname Lastname", or by="Vera -" if you have one name only.'
)
_NAME = re.compile(r"s\d+(_\d+)?(\.(png|pdf))?")


def course_folder() -> Path:
    """Return the folder of the student's course."""
    return Path(os.environ.get("COURSEKIT_COURSE", ".")).resolve()


def student(name: str = "") -> str:
    """Return the student's name: `name`, which is stored, or the stored name, or the variable `me` of chapter 0."""
    folder, shell = course_folder() / ".coursekit", running_shell()
    me = shell.user_ns.get(student_name.VARIABLE, "") if shell is not None else ""
    if not name and (kept := student_name.kept_name(folder)):
        return kept
    student = student_name.whole_name(name or (me if isinstance(me, str) else ""))
    if not student:
        raise BadArgument(WHOSE)
    (student_name.keep_name if name else student_name.keep_own_name)(folder, student)
    return student


class Evidence:
    """A picture that was written. It shows itself, except on the virtual clock, because it differs each time."""

    def __init__(self, file: Path, picture: bytes) -> None:
        self.file = file
        self._picture = picture

    def __repr__(self) -> str:
        return gettext(f"Wrote {self.file.parent.name}/{self.file.name}")

    def _repr_png_(self) -> bytes | None:
        return None if current().clock.virtual else self._picture


def evidence(name: str, *things: Any, by: str = "") -> Evidence | None:
    """Write the evidence that a practice assignment asks for: `evidence("s4_1", graph(), terminal("server_exe"))`.

    `name` is as in the assignment, with `.pdf` for a PDF; each of `things` is a terminal, a graph, frames, a viewer,
    a window, or text. The file is written to `evidence/` in the course folder and shows the student's name (`by`,
    given once), the place and the time.
    """
    if os.environ.get("COURSEKIT_GRADING"):
        return None  # a clean run
    if not _NAME.fullmatch(name) or not things:
        raise BadArgument(f'Give the name and what is shown: evidence("s2", graph()). Got the name {name!r}.')
    who, facts = student(by), who_and_where()
    stem, _, kind = name.partition(".")
    heading = f"{who}   {facts['user']}@{facts['host']}   {facts['time']}   {stem}"
    file = course_folder() / "evidence" / f"{student_word(who)}_evidence_{stem}.{kind or 'png'}"
    file.parent.mkdir(parents=True, exist_ok=True)
    picture = page(heading, things, "png")
    written = page(heading, things, "pdf") if kind == "pdf" else picture
    write_whole(file, written)
    events.note(course_folder() / ".coursekit" / EVENTS, "evidence", picture=file.name, sha256=digest_of(written))
    return Evidence(file, picture)


class HandedIn:
    """The file to hand in, or that was handed in at time `at`, and the mark of the clean run."""

    def __init__(self, file: Path, marked: Marked, at: str = "") -> None:
        self.file = file
        self.marked = marked
        self.at = at

    def _head(self) -> str:
        of = sum(verdict.of for verdict in self.marked.verdicts)
        points = gettext(f"{self.marked.total():g} of {of:g} points in a clean run")
        if self.at:
            return gettext(f"Handed in: {self.file.name}, {self.at} ({points})")
        return gettext(f"Hand in: {self.file.name} ({points})")

    def __repr__(self) -> str:
        return "\n".join(
            [self._head(), *map(gettext, self.marked.notes), *(verdict.text() for verdict in self.marked.verdicts)]
        )

    def _repr_html_(self) -> str:
        notes = "".join(f"<p>{html.escape(gettext(note))}</p>" for note in self.marked.notes)
        return f"<p><b>{html.escape(self._head())}</b></p>{notes}" + "".join(
            verdict.html() for verdict in self.marked.verdicts
        )


def hand_in(notebook: str | Path = "", *, by: str = "") -> HandedIn | None:
    """Run the saved notebook in a clean run, show its mark, and write the one file to hand in.

    JupyterLab needs no `notebook`. On a server with an exchange folder, the file is also handed in. Raises NotNow
    when the cells that ran differ from the saved notebook.
    """
    if os.environ.get("COURSEKIT_GRADING"):
        return None  # this is the clean run
    who, file = student(by), _notebook(notebook)
    _expect_saved(file)
    try:
        bundle, marked = make_bundle(file, course_folder(), who, course_folder())
    except ValueError as error:
        raise BadArgument(str(error)) from None
    return HandedIn(bundle, marked, _put_into_exchange(file, bundle))


def _put_into_exchange(notebook: Path, bundle: Path) -> str:
    """Hand in a file if the server has an exchange folder. Returns the time, or ''."""
    folder = os.environ.get(exchange.VARIABLE)
    if not folder:
        return ""
    facts = read_notebook(notebook).get("metadata", {}).get("coursekit", {})
    name = facts.get(HANDED_OUT) or notebook.stem
    user = os.environ.get("JUPYTERHUB_USER") or getpass.getuser()
    try:
        exchange.hand_in(Path(folder), user, name, [bundle])
    except OSError as error:
        raise NotNow(
            f"{bundle.name} was made, but not handed in: '{folder}' cannot be written ({error.strerror})."
        ) from None
    return time.strftime("%Y-%m-%d %H:%M")


def _notebook(given: str | Path) -> Path:
    """Return the notebook's file: the given one, the one reported by VS Code or JupyterLab, or the only one here."""
    shell = running_shell()
    told = [given, shell.user_ns.get("__vsc_ipynb_file__", "") if shell else "", os.environ.get("JPY_SESSION_NAME", "")]
    for name in told:
        for place in (Path(name), course_folder() / name) if name else ():
            if place.suffix == ".ipynb" and place.is_file():
                return place.resolve()
    notebooks = sorted(Path.cwd().glob("*.ipynb")) or sorted(course_folder().glob("*.ipynb"))
    if len(notebooks) == 1 and not given:
        return notebooks[0].resolve()
    names = ", ".join(path.name for path in notebooks) or "none"
    raise FileNotFoundError(gettext(f'Which notebook? Say it: hand_in("02_topics.ipynb"). There are: {names}.'))


def _expect_saved(file: Path) -> None:
    ran = last_runs()
    saved = {str(cell.get("id", "")): "".join(cell["source"]) for cell in read_notebook(file)["cells"]}
    changed = [cell for cell, text in ran.items() if cell in saved and text.strip() != saved[cell].strip()]
    if changed or not set(list(ran)[-1:]) <= set(saved):
        keys = shell_spelling.shortcut("S")
        raise NotNow(gettext(f"{file.name} is not saved as it was run: press {keys}, then run this cell again."))
