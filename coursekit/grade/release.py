"""The students' edition: notebooks without solutions, hidden tests and outputs, as a folder and as a zip."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from coursekit.files import write_whole

from .copy import HANDED_OUT, edition_of, student_notebook
from .editions import ENGLISH, IMAGES, pictures_of, read
from .exercise import checked_in, exercises_in
from .handing_out import write_for_moodle, write_list
from .own_checks import OWN, own_files
from .release_page import page
from .roster import Person, student_word
from .sanitizing import name_of_files
from .variants import Variants, checks_in

KERNEL = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
WHEEL = "ADDRESS-OF-THE-WHEEL"
"""The placeholder of the wheel's address until a teacher sets it."""


def released(notebook: dict[str, Any]) -> dict[str, Any]:
    """Return a notebook as handed out: stubs, no outputs, a plain kernel, valid nbgrader metadata."""
    released = student_notebook(notebook)
    facts = released["metadata"]["coursekit"]
    released["metadata"] = {"kernelspec": KERNEL, "language_info": {"name": "python"}, "coursekit": facts}
    return released


def with_points(notebook: dict[str, Any]) -> dict[str, Any]:
    """Return the notebook with the judges' points in its metadata, so that both always agree."""
    points = {name: exercise.points for name, exercise in checked_in(notebook).items()}
    for name, place in checks_in(notebook).items():
        grading = notebook["cells"][place].get("metadata", {}).get("nbgrader", {})
        if grading.get("grade") and name in points:
            grading["points"] = points[name]
    return notebook


def release(
    notebooks: Sequence[Path],
    out: Path,
    variants: Variants | None = None,
    *,
    personal: bool = True,
    wheel: str = WHEEL,
    moodle: bool = False,
    language: str = ENGLISH,
) -> list[Path]:
    """Write the notebooks, their zip and a page for a learning platform to `out`. Returns the files except pictures.

    With `variants` each student has an own folder and zip, with a mark of the owner in the notebooks. With `personal`
    the copies also have individual values. With `moodle` all zips are in one that Moodle distributes. The page tells
    students to install `wheel`. Chapters with a catalogue are in that `language`.
    """
    sources = {file.name: _in_language(read(file, language), language) for file in sorted(notebooks)}
    pictures = {picture.name: picture for file in notebooks for picture in pictures_of(sources[file.name], file.parent)}
    beside = [*pictures.values(), *own_files(checked_in(*sources.values()).values())]
    written = []
    if variants:
        archives = {person: _copy_of(person, variants, sources, out, personal, beside) for person in variants.roster.people}
        written = [*archives.values(), write_list(out, archives, variants.roster.form)]
        written += [write_for_moodle(out, archives)] if moodle else []
    else:
        files = _written(sources, out, out.name, beside)
        written = [*(path for path in files if path.parent.name != IMAGES), _zipped(files, out)]
    asked = {name: [exercise.points for exercise in exercises_in(source).values()] for name, source in sources.items()}
    file = out / "page.html"
    write_whole(file, page(out.name, "" if variants else f"{out.name}.zip", wheel, asked, language))
    return [*written, file]


def _in_language(notebook: dict[str, Any], language: str) -> dict[str, Any]:
    """Set the language of panels and checks in a notebook's metadata; English is the default."""
    if language != ENGLISH:
        notebook["metadata"].setdefault("coursekit", {})["language"] = language
    return notebook


def _copy_of(
    person: Person, variants: Variants, sources: Mapping[str, Any], out: Path, personal: bool, beside: Sequence[Path]
) -> Path:
    """Write a student's own zip."""
    student = variants.roster.label(person)
    copies = variants.copies(student, sources) if personal else sources
    folder = out / (student_word(student) or name_of_files(person.identity))
    return _zipped(_written(copies, folder, out.name, beside, variants.copy_mark(person)), out)


def _written(notebooks: Mapping[str, Any], folder: Path, name: str, beside: Sequence[Path], mark: str = "") -> list[Path]:
    """Write the notebooks as handed out, marked as a release, so that course updates leave them unchanged."""
    folder.mkdir(parents=True, exist_ok=True)
    files = []
    for file, notebook in notebooks.items():
        handed_out = with_points(released(notebook))
        edition = edition_of(json.dumps(handed_out))[:24]
        handed_out["metadata"]["coursekit"] |= {HANDED_OUT: name, "chapter": file, "release": edition}
        handed_out["metadata"]["coursekit"] |= {"copy": mark} if mark else {}
        files.append(folder / file)
        write_whole(files[-1], json.dumps(handed_out, indent=1) + "\n")
    return [*files, *(_copied(file, folder) for file in beside)]


def _copied(file: Path, folder: Path) -> Path:
    """Copy a file needed by the notebooks: a picture, or a teacher's own check."""
    path = folder / (OWN if file.suffix == ".py" else IMAGES) / file.name
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(file.read_bytes())
    return path


def _zipped(files: Sequence[Path], out: Path) -> Path:
    archive = out / f"{files[0].parent.name}.zip"
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
        for file in files:
            packed.write(file, f"{out.name}/{file.relative_to(files[0].parent).as_posix()}")
    return archive
