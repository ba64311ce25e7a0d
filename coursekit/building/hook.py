"""Adds generated files to wheels, source archives and installations: files of the underlay, and the students' chapters."""

import json
import sys
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class Hook(BuildHookInterface):  # type: ignore[type-arg]
    """Called by hatchling before it collects the files of a build."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Write the underlay's files; add chapters without solutions to all builds except editable ones."""
        sys.path.insert(0, self.root)
        from coursekit.building.underlay import write

        paths = write(Path(self.root) / "coursekit")
        build_data["artifacts"] += [path.relative_to(self.root).as_posix() for path in paths]
        if version != "editable":
            self._add_chapters(build_data)

    def _add_chapters(self, build_data: dict[str, Any]) -> None:
        from coursekit.grade.release import released

        self._folder = tempfile.TemporaryDirectory()
        for source in sorted((Path(self.root) / "notebooks").glob("*.ipynb")):  # a source archive contains them already
            chapter = Path(self._folder.name) / source.name
            notebook = released(json.loads(source.read_text(encoding="utf-8")))
            chapter.write_text(json.dumps(notebook, indent=1) + "\n", encoding="utf-8")
            build_data["force_include"][str(chapter)] = f"coursekit/notebooks/{source.name}"
        beside = (Path(self.root) / "notebooks").glob("*/*.*")  # translations and images
        for file in sorted(path for path in beside if path.suffix in (".po", ".svg")):
            build_data["force_include"][str(file)] = f"coursekit/{file.relative_to(self.root).as_posix()}"
