"""The image for marking: Linux, Python, bubblewrap and this course, built once for each version."""

from __future__ import annotations

import hashlib
import io
import subprocess
import sys
import tempfile
import zipfile
from dataclasses import dataclass
from importlib.metadata import Distribution, distribution
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
RECIPE = """\
FROM docker.io/library/python:3.12-slim-bookworm
RUN apt-get update && apt-get install -y --no-install-recommends bubblewrap && rm -rf /var/lib/apt/lists/*
COPY *.whl *.lock /course/
RUN pip install --no-cache-dir {constraints}/course/*.whl
ENTRYPOINT ["coursekit"]
"""
_NOT_OURS = ("INSTALLER", "REQUESTED", "direct_url.json")
"""The files that an installer adds to a package."""


@dataclass
class Image:
    """The image of one version of the course."""

    wheel: bytes
    name: str
    """The name of the wheel's file."""
    lock: bytes = b""
    """The pinned versions of dependencies, if known."""

    @classmethod
    def of_this_course(cls) -> Image:
        """Make the image of the installed course, or of this checkout."""
        checkout = PACKAGE.parent
        if (checkout / "pyproject.toml").is_file():
            file, content = _built(checkout)
            return cls(content, file, (checkout / "requirements.lock").read_bytes())
        installed = distribution("coursekit")
        return cls(packed(installed), f"coursekit-{installed.version}-py3-none-any.whl")

    @property
    def tag(self) -> str:
        """The name of the image, which changes with its contents."""
        with zipfile.ZipFile(io.BytesIO(self.wheel)) as archive:
            facts = sorted((info.filename, info.CRC) for info in archive.infolist() if not info.filename.endswith("RECORD"))
        return "coursekit-grade:" + hashlib.sha256(repr((facts, self.lock, RECIPE)).encode()).hexdigest()[:16]

    def make(self, program: str) -> None:
        """Build the image unless it exists; this needs the network once, and some minutes."""
        known = subprocess.run([program, "image", "inspect", self.tag], capture_output=True, stdin=subprocess.DEVNULL)
        if known.returncode == 0:
            return
        print("Making the image in which work is marked: this takes some minutes, once.", flush=True)
        with tempfile.TemporaryDirectory() as context:
            self._write(Path(context))
            recipe = str(Path(context, "Containerfile"))
            code = subprocess.call([program, "build", "--tag", self.tag, "--file", recipe, context])
        if code:
            raise SystemExit("The image could not be made; the lines above show why. It needs the network this once.")

    def _write(self, folder: Path) -> None:
        constraints = "-c /course/requirements.lock " if self.lock else ""
        (folder / self.name).write_bytes(self.wheel)
        (folder / "requirements.lock").write_bytes(self.lock)
        (folder / "Containerfile").write_text(RECIPE.format(constraints=constraints), encoding="utf-8", newline="\n")


def _built(checkout: Path) -> tuple[str, bytes]:
    """Build a checkout's wheel. Returns its name and content."""
    with tempfile.TemporaryDirectory() as out:
        command = [sys.executable, "-m", "pip", "wheel", "-q", "--no-deps", "--wheel-dir", out, str(checkout)]
        if subprocess.call(command):
            raise SystemExit("The course could not be packed for the container; the lines above show why.")
        [wheel] = Path(out).glob("*.whl")
        return wheel.name, wheel.read_bytes()


def packed(found: Distribution) -> bytes:
    """Rebuild the wheel of an installed package from its files."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for member in found.files or []:
            outside = ".." in member.parts or "__pycache__" in member.parts or member.name in _NOT_OURS
            if not outside:
                archive.write(str(found.locate_file(member)), member.as_posix())
    return file.getvalue()
