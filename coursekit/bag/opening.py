"""Opens a bag file by its storage id, and imports the storage's libraries only then."""

from __future__ import annotations

from pathlib import Path

from coursekit.bag.errors import BagError
from coursekit.bag.storage import FileReader, FileWriter, check_storage_id


def open_reader(path: Path, storage_id: str) -> FileReader:
    """Open a file for reading. Raises BagError."""
    if not path.is_file():
        raise BagError(f"the file '{path}' of the bag is not there")
    if check_storage_id(storage_id) == "mcap":
        from coursekit.bag.mcap_reader import McapReader

        return McapReader(path)
    from coursekit.bag.sqlite_storage import SqliteReader

    return SqliteReader(path)


def open_writer(path: Path, storage_id: str, preset: str = "", config: str = "") -> FileWriter:
    """Open a new file for writing, with the settings of a preset or of a configuration file."""
    if check_storage_id(storage_id) == "mcap":
        from coursekit.bag.mcap_writer import McapWriter

        return McapWriter(path, preset, config)
    from coursekit.bag.sqlite_storage import SqliteWriter

    return SqliteWriter(path, preset, config)
