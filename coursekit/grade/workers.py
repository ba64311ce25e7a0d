"""Marking on several computers: dask.distributed sends each submission to a worker, which marks it in a sandbox as here.

Only texts are sent: the submitted and the course's own notebooks there, the mark back. Anyone who can reach the
scheduler can run programs on the workers: let it listen on this computer only, or use TLS (docs/teachers.md).
"""

from __future__ import annotations

import atexit
import base64
import dataclasses
import functools
import getpass
import json
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from coursekit.systems import rights

from . import sandbox
from .exercise import Exercise, exercises_in
from .mark import Marked, mark
from .own_checks import own_files, read_checks
from .results import coursekit_version, judges_digest
from .sandbox import Limits
from .submissions import Submission
from .unsandboxed import cure

CONNECT_S = 20
"""The timeout for a scheduler's answer [s]."""
RETRIES = 3
"""How often a submission is retried whose worker has died, which the submission itself may have caused."""


class NoWorkers(ValueError):
    """Why nothing can be marked there, in words for the teacher."""


class Workers:
    """The workers of a scheduler at an address such as `tcp://127.0.0.1:8786`; a context that ends their tasks.

    Raises:
        NoWorkers: when there is none, or one of them would give other marks than this computer.
    """

    def __init__(self, address: str, *, allow_root: bool = False, unsafe: bool = False) -> None:
        try:
            from distributed import Client
        except ImportError:
            raise NoWorkers('--scheduler needs dask: pip install "coursekit[scheduler]"') from None
        try:
            self._client = Client(address, timeout=CONNECT_S, name=f"coursekit-{getpass.getuser()}")
        except (OSError, ValueError) as error:
            cure = "Start one: dask scheduler --host 127.0.0.1"
            raise NoWorkers(f"No scheduler answers at {address} ({error}). {cure}") from None
        try:
            facts_by_worker = self._client.run(facts)
            self.tier = expect_alike(facts_by_worker, address, allow_root=allow_root, unsafe=unsafe)
            self.jobs = sum(self._client.nthreads().values())
        except NoWorkers:
            self._client.close()
            raise

    def __enter__(self) -> Workers:
        return self

    def __exit__(self, *_: object) -> None:
        self._client.close()

    def mark(
        self,
        submission: Submission,
        sources: Mapping[str, dict[str, Any]],
        exercises: Mapping[str, Exercise],
        limits: Limits,
        secret: bytes = b"",
    ) -> Marked:
        """Mark like `mark.mark`, on any free worker; another one repeats it if that worker dies."""
        task = json.dumps(packed(submission, sources, exercises, limits, secret))
        future = self._client.submit(mark_packed, task, pure=False, retries=RETRIES)
        return Marked.of_json(json.loads(future.result()))


def facts() -> dict[str, Any]:
    """Return the settings of a worker that affect its marks, in addition to its tasks."""
    known = {"judges": judges_digest(), "version": coursekit_version(), "root": rights.is_root()}
    return {**known, "tier": sandbox.tier(), "lacks": cure(sandbox.complaint())}


def packed(
    submission: Submission,
    sources: Mapping[str, dict[str, Any]],
    exercises: Mapping[str, Exercise],
    limits: Limits,
    secret: bytes,
) -> dict[str, Any]:
    """Return a submission, and all data for marking it, as plain values."""
    return {
        "submission": submission.as_json(),
        "chosen": {name: _text(file) for name, file in submission.chosen.items()},
        "bundles": [_text(file) for file in submission.bundle_files],
        "sources": dict(sources),
        "checks": {file.name: file.read_text(encoding="utf-8") for file in own_files(exercises.values())},
        "limits": dataclasses.asdict(limits),
        "secret": secret.hex(),
    }


def mark_packed(task: str) -> str:
    """On the worker: unpack a submission into a temporary folder, mark it, and return the mark as text."""
    said = json.loads(task)
    with tempfile.TemporaryDirectory(prefix="coursekit-") as name:
        folder = Path(name)
        given = enumerate(said["chosen"].items())
        chosen = {chapter: _file(folder / str(at) / chapter, data) for at, (chapter, data) in given}
        bundles = [_file(folder / f"bundle{at}.zip", data) for at, data in enumerate(said["bundles"])]
        submission = dataclasses.replace(
            Submission.of_json(said["submission"]), place=folder, chosen=chosen, bundle_files=bundles
        )
        read_checks(_folder_of_checks(tuple(said["checks"].items())))
        sources, limits, secret = said["sources"], Limits(**said["limits"]), bytes.fromhex(said["secret"])
        return json.dumps(mark(submission, sources, exercises_in(*sources.values()), limits, secret).as_json())


@functools.cache
def _folder_of_checks(checks: tuple[tuple[str, str], ...]) -> Path:
    """Write a teacher's own checks to a folder that exists as long as the worker: their registrations are reused."""
    folder = Path(tempfile.mkdtemp(prefix="coursekit-checks-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    for name, text in checks:
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def expect_alike(found: Mapping[str, dict[str, Any]], address: str, *, allow_root: bool, unsafe: bool) -> str:
    """Return the sandbox tier of all workers; NoWorkers when there are none, or they differ from this computer."""
    if not found:
        raise NoWorkers(f"The scheduler at {address} has no workers yet. Start some: dask worker {address} --nthreads 1")
    own = facts()
    for worker, said in found.items():
        if (said["judges"], said["version"]) != (own["judges"], own["version"]):
            raise NoWorkers(f"The worker {worker} has another coursekit ({said['version']}): install the same one there.")
        if said["tier"] != "bubblewrap" and not unsafe:
            raise NoWorkers(f"The worker {worker} has {said['lacks']} (--unsafe marks without.)")
        if said["root"] and not allow_root:
            raise NoWorkers(f"The worker {worker} runs as root: start it as another user. (In a container: --allow-root.)")
    tiers = sorted({str(said["tier"]) for said in found.values()})
    if len(tiers) > 1:
        raise NoWorkers(f"The workers have different sandboxes ({', '.join(tiers)}): their marks would not be comparable.")
    return tiers[0]


def _text(file: Path) -> str:
    return base64.b64encode(file.read_bytes()).decode("ascii")


def _file(place: Path, data: str) -> Path:
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_bytes(base64.b64decode(data))
    return place


__all__ = ["NoWorkers", "Workers", "expect_alike", "facts", "mark_packed", "packed"]
