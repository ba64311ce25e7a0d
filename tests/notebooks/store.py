"""`make notebooks`: execute the chapters on the virtual clock and store their outputs, which tests then compare.

python -m tests.notebooks.store [notebooks/01_first_nodes.ipynb ...]
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import nbformat
from nbconvert.preprocessors import CoalesceStreamsPreprocessor

from .running import chapters, run


def store(path: Path) -> None:
    """Execute one chapter and write it with its outputs."""
    notebook = nbformat.read(path, as_version=4)
    with tempfile.TemporaryDirectory() as folder:
        run(notebook, Path(folder))
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
    notebook.metadata.pop("widgets", None)
    CoalesceStreamsPreprocessor().preprocess(notebook, {})  # how a text came in pieces is not the same every time
    nbformat.write(notebook, path)
    print(f"stored {path.name}")


if __name__ == "__main__":
    for chapter in [Path(name) for name in sys.argv[1:]] or chapters():
        store(chapter)
