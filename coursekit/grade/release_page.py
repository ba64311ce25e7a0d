"""The release's page for a learning platform: how to start, what to do, how to hand in."""

from __future__ import annotations

import html
from collections.abc import Mapping, Sequence
from pathlib import Path

from coursekit.systems.command_lines import join_words
from coursekit.words.gettext import ENGLISH, words_of


def page(title: str, archive: str, wheel: str, points: Mapping[str, Sequence[float]], language: str = ENGLISH) -> str:
    """Return a release's page in a language; `points` of each exercise by notebook, `wheel` to install.

    An `archive` of '' means that each student has an own zip.
    """
    gettext = words_of(language).translated
    folder, wheel = html.escape(join_words([title])), html.escape(wheel)
    archive = html.escape(archive) or gettext("the zip with your name")
    begin = [
        gettext(f"Download <b>{archive}</b> and unpack it: it holds a folder <code>{folder}</code>."),
        gettext("(Extract All of Windows puts that into another folder: move it out.)"),
        gettext(
            f"Put <code>{folder}</code> next to <code>ros-env</code>, and open the notebooks with "
            f"<code>ros-env/bin/coursekit lab --folder {folder}</code>."
        ),
        gettext("Run the cells from top to bottom;"),
        gettext("write where it says <code># YOUR CODE HERE</code>, and run the check below it."),
    ]
    hand_in = [
        gettext("Hand in the notebooks, saved, with the names that they have;"),
        gettext("or the file that <code>hand_in()</code> makes of each:"),
        gettext(
            "type that in a new cell at the end of the notebook (the first time with your name: "
            '<code>hand_in(by="Ann Lee")</code>), and run it.'
        ),
        gettext("Its file also holds the pictures that <code>evidence()</code> made:"),
        gettext("where the assignment asks for evidence, hand in this file."),
    ]
    windows = gettext(
        f"(Windows: <code>py -3 -m venv ros-env</code>, then <code>ros-env\\Scripts\\pip install {wheel}</code>, "
        "and <code>ros-env\\Scripts\\coursekit</code> below.)"
    )
    return "\n".join(
        [
            f"<h2>{html.escape(title)}</h2>",
            f"<p>{gettext('Once, in a terminal, with Python 3.10 or newer:')}</p>",
            f"<pre>python3 -m venv ros-env\nros-env/bin/pip install {wheel}</pre>",
            f"<p>{windows}</p>",
            "\n".join([f"<p>{begin[0]}", *begin[1:]]) + "</p>",
            _table(points, [gettext("Notebook"), gettext("Exercises"), gettext("Points")], gettext("All")),
            "\n".join([f"<p>{hand_in[0]}", *hand_in[1:]]) + "</p>",
            "",
        ]
    )


def _table(points: Mapping[str, Sequence[float]], heads: Sequence[str], last: str) -> str:
    every = [value for given in points.values() for value in given]
    rows = [_row("th", *heads), *(_row("td", html.escape(Path(name).stem), *_sums(given)) for name, given in points.items())]
    return "\n".join([f"<table>{rows[0]}", *rows[1:], _row("th", last, *_sums(every)) + "</table>"])


def _sums(points: Sequence[float]) -> tuple[str, str]:
    """Return the number of exercises, and the sum of their points."""
    return str(len(points)), f"{sum(points):g}"


def _row(tag: str, *cells: str) -> str:
    return f"<tr>{''.join(f'<{tag}>{cell}</{tag}>' for cell in cells)}</tr>"


__all__ = ["page"]
