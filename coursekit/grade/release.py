"""What students get: the notebooks without solutions, hidden tests and outputs, as a folder and as a zip."""

from __future__ import annotations

import html
import json
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .copy import student_notebook

KERNEL = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
_PAGE = """<h2>{title}</h2>
<p>Download <b>{archive}</b>, unpack it, and open the notebooks with <code>coursekit lab --folder FOLDER</code>.
Run the cells from top to bottom; write where it says <code># YOUR CODE HERE</code>, and run the check below it.</p>
<table><tr><th>Notebook</th><th>Exercises</th><th>Points</th></tr>
{rows}</table>
<p>Hand in the notebooks, saved, with the names that they have.</p>
"""


def released(notebook: dict[str, Any]) -> dict[str, Any]:
    """A notebook as it is handed out: stubs, no outputs, a plain kernel, valid nbgrader metadata."""
    made = student_notebook(notebook)
    made["metadata"] = {"kernelspec": KERNEL, "language_info": {"name": "python"}}
    return made


def release(notebooks: Sequence[Path], out: Path) -> list[Path]:
    """Write the notebooks, a zip of them and a page for a learning platform into `out`; what was written."""
    out.mkdir(parents=True, exist_ok=True)
    written, rows = [], []
    for source in sorted(notebooks):
        made = released(json.loads(source.read_text(encoding="utf-8")))
        target = out / source.name
        target.write_text(json.dumps(made, indent=1) + "\n", encoding="utf-8")
        written.append(target)
        rows.append(_row(source.stem, made))
    archive = out / f"{out.name}.zip"
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
        for target in written:
            packed.write(target, f"{out.name}/{target.name}")
    page = out / "page.html"
    page.write_text(_PAGE.format(title=html.escape(out.name), archive=archive.name, rows="\n".join(rows)), encoding="utf-8")
    return [*written, archive, page]


def _row(name: str, notebook: dict[str, Any]) -> str:
    grading = [cell.get("metadata", {}).get("nbgrader", {}) for cell in notebook["cells"]]
    points = [float(one.get("points", 0)) for one in grading if one.get("grade")]
    return f"<tr><td>{html.escape(name)}</td><td>{len(points)}</td><td>{sum(points):g}</td></tr>"
