"""The course as static pages with a search, for reading: `python -m coursekit.building.web FOLDER` (or `make web`).

Nothing can be run there. Solutions and their outputs are left out; images replace panels. English is at the top of the
folder, each other language in its own folder.
"""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from coursekit.grade.copy import student_notebook
from coursekit.grade.editions import ENGLISH, IMAGES, chapters, languages, notebooks_folder, read

WIDGET = "application/vnd.jupyter.widget-view+json"
CONF = """project = "coursekit"
language = {language!r}
extensions = ["myst_nb"]
html_theme = "furo"
html_title = {title!r}
html_show_sourcelink = html_show_copyright = False
nb_execution_mode = "off"
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
suppress_warnings = ["misc.highlighting_failure"]
"""
SHORT = 8
"""Minimum length of a line that gives a solution away."""
WORDS = {
    "en": ("ROS 2 in notebooks", "The chapters to read and to search. To run them, install coursekit: `make lab`."),
    "es": ("ROS 2 en cuadernos", "Los capítulos para leer y buscar. Para ejecutarlos instala coursekit: `make lab`."),
}
"""The title of the pages and the sentence below it, by language."""
NAMES = {"en": "English", "es": "Español"}


def web_notebook(notebook: dict[str, Any]) -> dict[str, Any]:
    """Return a chapter for reading: stubs for solutions; stored outputs, except of answers and checks, or with a solution.

    >>> cell = {"cell_type": "code", "source": ["1 + 1"], "metadata": {}, "outputs": [{"output_type": "stream"}]}
    >>> len(web_notebook({"cells": [cell], "metadata": {}})["cells"][0]["outputs"])
    1
    """
    chapter = student_notebook(notebook)
    secret = _lines(notebook) - _lines(chapter)
    for cell, stored in zip(chapter["cells"], notebook["cells"], strict=True):
        if cell["cell_type"] == "code" and not cell.get("metadata", {}).get("nbgrader"):
            outputs = [_still(output) for output in stored.get("outputs", [])]
            cell["outputs"] = [output for output in outputs if not secret & _words(output)]
    chapter["metadata"] = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    return chapter


def _lines(notebook: dict[str, Any]) -> set[str]:
    """Return the meaningful lines of all cells."""
    return {line for cell in notebook["cells"] for line in _telling("".join(cell["source"]))}


def _words(output: dict[str, Any]) -> set[str]:
    """Return the meaningful lines of an output."""
    texts = [output.get("text", ""), output.get("data", {}).get("text/plain", "")]
    return {line for text in texts for line in _telling("".join(text))}


def _telling(text: str) -> Iterator[str]:
    return (line.strip() for line in text.splitlines() if len(line.strip()) >= SHORT)


def _still(output: dict[str, Any]) -> dict[str, Any]:
    """Return an output without its widget: the image or text beside it stays."""
    if WIDGET not in output.get("data", {}):
        return output
    return {**output, "data": {kind: data for kind, data in output["data"].items() if kind != WIDGET}}


def write_sources(folder: Path, language: str, others: Sequence[str]) -> None:
    """Write the sources of the pages in one language; the first page links to the `others`."""
    title, sentence = WORDS.get(language, WORDS[ENGLISH])
    names = []
    for chapter in chapters(notebooks_folder(), language):
        (folder / chapter.name).write_text(json.dumps(web_notebook(read(chapter, language))), encoding="utf-8")
        names.append(chapter.stem)
    shutil.copytree(notebooks_folder() / IMAGES, folder / IMAGES)
    top = "" if language == ENGLISH else "../"
    elsewhere = [_link(other, f"{top}{'' if other == ENGLISH else other + '/'}index.html") for other in others]
    tree = "\n".join(["```{toctree}", ":maxdepth: 1", "", *names, "```"])
    (folder / "index.md").write_text(f"# {title}\n\n{sentence}\n\n{' '.join(elsewhere)}\n\n{tree}\n", encoding="utf-8")
    (folder / "conf.py").write_text(CONF.format(language=language, title=title), encoding="utf-8")


def _link(language: str, address: str) -> str:
    return f'<a href="{address}" lang="{language}">{NAMES.get(language, language)}</a>'


def build(out: Path) -> int:
    """Build the pages of every language; return Sphinx's exit code if one fails, 2 without Sphinx."""
    try:
        from sphinx.cmd.build import main as sphinx
    except ImportError:
        print('The pages are made by Sphinx: pip install "coursekit[docs]"', file=sys.stderr)
        return 2
    known = languages(notebooks_folder())
    for language in known:
        where = out if language == ENGLISH else out / language
        with tempfile.TemporaryDirectory() as folder:
            write_sources(Path(folder), language, [other for other in known if other != language])
            code = int(sphinx(["-q", "-W", "--keep-going", "-d", f"{folder}/.trees", folder, str(where)]))
        if code:
            return code
    print(f"Open {out / 'index.html'}")
    return 0


def main(words: Sequence[str] | None = None) -> int:
    """Build into the given folder; return 2 if there is none."""
    named = list(sys.argv[1:] if words is None else words)
    if len(named) != 1:
        print("Name a folder: python -m coursekit.building.web build/web", file=sys.stderr)
        return 2
    return build(Path(named[0]))


if __name__ == "__main__":
    sys.exit(main())
