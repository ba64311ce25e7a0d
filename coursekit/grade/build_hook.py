"""Puts the chapters into the wheel and the source archive as students get them: without solutions."""

import json
import sys
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class StudentChapters(BuildHookInterface):  # type: ignore[type-arg]
    """Writes `coursekit/notebooks` into what is built from a checkout; a source archive holds it already."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the chapters, except where the checkout itself is used (an editable install)."""
        sources = Path(self.root) / "notebooks"
        if version == "editable" or not sources.is_dir():
            return
        sys.path.insert(0, self.root)
        from coursekit.grade.release import released

        self._folder = tempfile.TemporaryDirectory()
        for source in sorted(sources.glob("*.ipynb")):
            made = Path(self._folder.name) / source.name
            notebook = released(json.loads(source.read_text(encoding="utf-8")))
            made.write_text(json.dumps(notebook, indent=1) + "\n", encoding="utf-8")
            build_data["force_include"][str(made)] = f"coursekit/notebooks/{source.name}"
