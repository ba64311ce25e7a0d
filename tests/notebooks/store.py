"""`make notebooks`: execute the chapters on the virtual clock and store their outputs, which tests then compare.

python -m tests.notebooks.store [notebooks/01_first_nodes.ipynb ...]
"""

from __future__ import annotations

import sys
import tempfile
import uuid
from pathlib import Path

import nbformat
from nbconvert.preprocessors import CoalesceStreamsPreprocessor

from .running import chapters, run

WIDGET = "application/vnd.jupyter.widget-view+json"


def store(path: Path) -> None:
    """Execute one chapter and write it with its outputs."""
    notebook = nbformat.read(path, as_version=4)
    with tempfile.TemporaryDirectory() as folder:
        run(notebook, Path(folder))
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
    notebook.metadata.pop("widgets", None)
    number_widgets(notebook)
    CoalesceStreamsPreprocessor().preprocess(notebook, {})  # how a text came in pieces is not the same every time
    nbformat.write(notebook, path)
    print(f"stored {path.name}")


def number_widgets(notebook: nbformat.NotebookNode) -> None:
    """Give the widgets of stored outputs numbers of their own: those of a run are random, and no run shows them again."""
    for cell in notebook.cells:
        for at, output in enumerate(cell.get("outputs", [])):
            view = output.get("data", {}).get(WIDGET)
            if view is not None:
                view["model_id"] = uuid.uuid5(uuid.NAMESPACE_OID, f"{cell.id} {at}").hex


if __name__ == "__main__":
    for chapter in [Path(name) for name in sys.argv[1:]] or chapters():
        store(chapter)
