"""The entries of a class's submissions: of a folder, or of a learning platform's zip."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import BinaryIO

from .archives import OF_A_CLASS, Archive, Member
from .exchange import false_owner
from .safe_walk import Walked, walk
from .sanitizing import shown
from .submission_parts import FILE, SYSTEM, WORKSPACE, ZIPPED, Raw


def entries_of_folder(folder: Path, leave: Iterable[Path] = ()) -> Iterator[tuple[str, bool, Iterator[Raw]]]:
    """Yield a class folder's entries: name, whether it is neither folder, notebook nor zip, and content.

    Hidden entries and those in `leave` are skipped.
    """
    left = {path.resolve() for path in leave}
    for place in sorted(folder.iterdir()):
        if not place.name.startswith(".") and place.name not in (*SYSTEM, WORKSPACE) and place.absolute() not in left:
            fault = false_owner(place)
            files = iter([Raw((place.name,), fault=fault)]) if fault else map(_of_walked, walk(place))
            yield place.name, place.is_file() and is_loose(place.name), files


def _of_walked(walked: Walked) -> Raw:
    return Raw(walked.parts, walked.when, FILE, walked.open, walked.size, walked.fault)


def is_loose(name: str) -> bool:
    """Whether a file is neither notebook nor zip by its name.

    >>> [is_loose(name) for name in ("02_topics.ipynb", "All.ZIP", "report.pdf")]
    [False, False, True]
    """
    return not name.casefold().endswith((".ipynb", ".zip"))


def entries_of_zip(file: Path) -> Iterator[tuple[str, bool, Iterator[Raw]]]:
    """Yield the entries of a learning platform's zip of a class's submissions, as `entries_of_folder` does.

    Raises:
        BadArchive: when it cannot be opened.
    """
    with Archive(open(file, "rb"), OF_A_CLASS) as opened:
        members = [member for member in opened.members() if "__MACOSX" not in member.parts]
        names = {member.parts[0] for member in members}
        wrapped = len(names) == 1 and shown(next(iter(names))) == shown(file.stem) and all(len(m.parts) > 1 for m in members)
        groups: dict[str, list[Raw]] = {}
        files = set()
        changed = file.stat().st_mtime
        for member in members:
            parts = member.parts[1:] if wrapped else member.parts
            how = ZIPPED if member.when else FILE
            inner = Raw(parts[1:] or parts, member.when or changed, how, _opener(opened, member), member.size)
            groups.setdefault(parts[0], []).append(inner)
            files |= {parts[0]} if len(parts) == 1 else set()
        for name in sorted(groups):
            if not name.startswith("."):
                yield name, name in files and is_loose(name), iter(groups[name])


def _opener(opened: Archive, member: Member) -> Callable[[], BinaryIO]:
    return lambda: io.BytesIO(opened.read(member))
