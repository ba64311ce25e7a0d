"""Files that a launch creates for its processes, such as parameter files."""

from __future__ import annotations

import atexit
import itertools
import os
import shutil
import tempfile

from coursekit.processes import session


class TemporaryFiles:
    """Creates names of new files; on the virtual clock they are numbered, which makes output reproducible."""

    def __init__(self) -> None:
        self.__folder: str | None = None
        self.__numbers: dict[int, itertools.count[int]] = {}

    def new_path(self, prefix: str) -> str:
        """Return the path of a file that does not exist yet; it is removed when Python ends."""
        if self.__folder is None:
            self.__folder = tempfile.mkdtemp(prefix="launch_")
            atexit.register(shutil.rmtree, self.__folder, ignore_errors=True)
        current = session.current()
        if not current.clock.virtual:
            handle, path = tempfile.mkstemp(prefix=prefix, dir=self.__folder)
            os.close(handle)
            return path
        number = next(self.__numbers.setdefault(id(current), itertools.count(1)))
        return os.path.join(self.__folder, f"{prefix}{number}")

    def shown(self, text: str) -> str:
        """Return text with this run's own folder replaced by the system's temporary folder, the same in every run."""
        return text if self.__folder is None else text.replace(self.__folder, tempfile.gettempdir())


temporary_files = TemporaryFiles()
