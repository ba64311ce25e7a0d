"""Stored marks: each is valid while its dependencies are unchanged, and only if this account wrote it."""

from __future__ import annotations

import functools
import hashlib
import hmac
import json
import secrets
from collections import Counter
from collections.abc import Container, Iterable, Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path, PurePosixPath
from typing import Any

from coursekit.files import write_whole
from coursekit.words.counting import counted

from .exercise import Exercise
from .mark import Marked
from .own_checks import digest_of_checks
from .teacher_secrets import config_folder, mac, own_key
from .variants import values_of

FILE = "result.json"
CHANGES = {
    "submission": "other work was handed in",
    "judges": "the code that marks has changed",
    "course": "the chapter has changed",
    "coursekit": "coursekit has another version",
    "tier": "the sandbox is another one",
    "variants": "the student's own numbers have changed",
    "points": "the points of its exercises have changed",
    "checks": "its checks have changed",
    "dice": "the roster's secret has changed",
}
"""Why a stored mark is no longer valid, by dependency; the first change is reported."""


@functools.cache
def judges_digest() -> str:
    """Return a digest of all code that affects marks."""
    digest, folder = hashlib.sha256(), Path(__file__).parent
    for file in sorted(folder.rglob("*.py")):
        digest.update(str(file.relative_to(folder)).encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()


@functools.cache
def coursekit_version() -> str:
    """Return the installed version."""
    try:
        return version("coursekit")
    except PackageNotFoundError:
        return "unknown"


def key_of(
    submission: str, source: Mapping[str, Any], exercises: Mapping[str, Exercise], tier: str, dice: bytes
) -> dict[str, Any]:
    """Return all dependencies of a mark."""
    course = hashlib.sha256(json.dumps(source, sort_keys=True).encode()).hexdigest()
    points = {name: exercise.points for name, exercise in exercises.items()}
    return {
        "submission": submission,
        "judges": judges_digest(),
        "course": course,
        "coursekit": coursekit_version(),
        "tier": tier,
        "variants": json.loads(json.dumps(values_of([source]))),
        "points": points,
        "checks": digest_of_checks(exercises.values()),
        "dice": hashlib.sha256(dice).hexdigest(),
    }


class Results:
    """The stored results of a class in a folder; one file per person, sealed by this account."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.told: list[str] = []
        self.changes: dict[tuple[str, str], str] = {}
        """Why a stored mark was not used, by key and chapter."""
        try:
            self._key = own_key()
        except OSError as error:
            self._key = secrets.token_bytes(32)
            self.told.append(f"No secret can be kept in {config_folder()} ({error}): the next run marks everything again.")

    def dice(self) -> bytes:
        """Return the seed of the judges' random choices for a class without its own secret."""
        return hmac.new(self._key, b"dice", hashlib.sha256).digest()

    def chapters(self, key: str) -> dict[str, dict[str, Any]]:
        """Return everything stored under a key, by chapter; empty for a manipulated file."""
        file = self.folder / key / FILE
        if not file.is_file():
            return {}
        try:
            stored = json.loads(file.read_text(encoding="utf-8"))
            payload, said = dict(stored["payload"]), str(stored["hmac"])
            genuine = hmac.compare_digest(mac(self._key, payload), said) and payload["key"] == key
            chapters: dict[str, dict[str, Any]] = dict(payload["chapters"])
        except (OSError, ValueError, TypeError, LookupError, RecursionError):
            genuine, chapters = False, {}
        if not genuine:
            self.told.append(f"The kept result of {key} was changed, or is not of this account: marked again.")
            file.unlink(missing_ok=True)
            return {}
        return chapters

    def read(self, key: str, chapter: str, depends: Mapping[str, Any]) -> Marked | None:
        """Return the stored mark for a chapter, if all its dependencies are unchanged."""
        kept = self.chapters(key).get(chapter)
        if kept is None:
            return None
        before = kept.get("depends")
        if before != depends:
            changed = (name for name in CHANGES if not isinstance(before, dict) or before.get(name) != depends[name])
            self.changes[key, chapter] = CHANGES[next(changed, "judges")]
            return None
        try:
            return Marked.of_json(kept["marked"])
        except (TypeError, LookupError):
            return None

    def told_changes(self, keys: Container[str]) -> list[str]:
        """Report how many stored marks of these people were renewed, and why."""
        counts = Counter((why, PurePosixPath(chapter).stem) for (key, chapter), why in self.changes.items() if key in keys)
        return [
            f"{chapter}: {counted(number, 'kept mark was', 'kept marks were')} made anew, since {why}."
            for (why, chapter), number in counts.items()
        ]

    def write(self, key: str, chapter: str, depends: Mapping[str, Any], marked: Marked) -> None:
        """Store a mark."""
        chapters = self.chapters(key)
        chapters[chapter] = {"depends": dict(depends), "marked": marked.as_json()}
        self._write(key, chapters)

    def note(self, key: str, chapter: str, facts: Mapping[str, Any]) -> None:
        """Store additional facts of a mark, such as its deduction."""
        chapters = self.chapters(key)
        if chapter in chapters and chapters[chapter].get("facts") != facts:
            chapters[chapter]["facts"] = dict(facts)
            self._write(key, chapters)

    def forget(self, keys: Iterable[str], chapters: Iterable[str]) -> None:
        """Drop some results, so that they are marked again."""
        gone = set(chapters)
        for key in keys:
            kept = {name: chapter for name, chapter in self.chapters(key).items() if name not in gone}
            if (self.folder / key / FILE).exists():
                self._write(key, kept)

    def _write(self, key: str, chapters: Mapping[str, Any]) -> None:
        payload = {"key": key, "chapters": json.loads(json.dumps(chapters))}
        text = json.dumps({"payload": payload, "hmac": mac(self._key, payload)}, indent=1)
        write_whole(self.folder / key / FILE, text.encode("utf-8", "replace"), 0o600, parents=True)
