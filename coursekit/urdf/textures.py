"""The files that a mesh refers to (textures, materials, buffers), searched only where Gazebo searches."""

from __future__ import annotations

import io
import warnings
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from trimesh.resolvers import Resolver

from coursekit.files import is_file, read_bytes

from .resources import model_folders

PICTURES = (".png", ".jpg", ".jpeg", ".tga", ".tif", ".tiff", ".bmp", ".gif", ".dds", ".webp")
FOLDERS = ("", "materials/textures", "textures", "materials", "meshes")
"""Folders of a model that may contain textures."""
MOST = 64 << 20
"""Maximum size of a file beside a mesh [bytes]."""
MOST_POINTS = 4096 * 4096
"""Maximum number of pixels of a texture; with a larger one the mesh is drawn plain."""


class Beside(Resolver):
    """The files beside a mesh; `notes` has one line for each file that was not found or could not be read.

    A texture is replaced by an image of one pixel in its mean colour: only that is drawn, and no large image is kept.
    """

    def __init__(self, mesh: Path) -> None:
        self.mesh = mesh
        self.notes: list[str] = []
        self.roots = list(dict.fromkeys(_model_of(file) for file in (mesh, mesh.resolve())))  # for symlink installs, too

    def write(self, name: str, data: Any) -> None:
        """Refuse: nothing is written."""
        raise PermissionError(name)

    def namespaced(self, namespace: str) -> Beside:
        """Return itself: names are searched for, not followed."""
        return self

    def keys(self) -> list[str]:
        """Return nothing: files are not listed."""
        return []

    def get(self, name: str) -> bytes:
        """Return the contents of a file beside the mesh; FileNotFoundError if its model's folder contains none."""
        word = unquote(name).replace("\\", "/").removeprefix("file://").strip()
        path = next((place for place in self._places(word) if is_file(place) and self._inside(place)), None)
        picture = Path(word).suffix.lower() in PICTURES
        kind = "texture" if picture else "file"
        if path is None:
            self._note(f"{kind} '{name}' is not found beside it nor in materials/textures: it is drawn plain")
            if not picture:
                raise FileNotFoundError(name)
            return _dot((255, 255, 255))
        try:
            data = read_bytes(path, MOST)
            return _dot(mean_colour(data)) if picture else data
        except Exception as error:  # the readers of ten formats raise all kinds of exceptions
            self._note(f"{kind} '{name}' cannot be read ({type(error).__name__}): it is drawn plain")
            if not picture:
                raise FileNotFoundError(name) from None
            return _dot((255, 255, 255))

    def _note(self, what: str) -> None:
        if what not in self.notes:
            self.notes.append(what)

    def _places(self, word: str) -> list[Path]:
        name = Path(word).name
        tails = [folder for root in [*self.roots, *model_folders()] for folder in (root / name for name in FOLDERS)]
        uri = word.removeprefix("model://")
        named = [folder / uri for folder in model_folders()] if uri != word else [self.mesh.parent / word]
        return [*named, self.mesh.parent / name, *(folder / name for folder in tails)]

    def _inside(self, path: Path) -> bool:
        real = path.resolve()
        return any(real.is_relative_to(root.resolve()) for root in [*self.roots, *model_folders()])


def _model_of(mesh: Path) -> Path:
    """Return the folder of the model or package of a mesh, at most four levels above it; else its own folder."""
    folder = mesh.absolute().parent
    for parent in [folder, *folder.parents][:5]:
        if is_file(parent / "model.config") or is_file(parent / "package.xml"):
            return parent
    return folder.parent if folder.name == "meshes" and len(folder.parents) > 2 else folder


def mean_colour(data: bytes) -> tuple[int, int, int]:
    """Return the mean colour of an image, 0 to 255 each; any exception of the image library, ValueError for huge ones.

    >>> from PIL import Image
    >>> file = io.BytesIO()
    >>> Image.new("RGB", (2, 1), (200, 100, 0)).save(file, "PNG")
    >>> mean_colour(file.getvalue())
    (200, 100, 0)
    """
    from PIL import Image

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with Image.open(io.BytesIO(data)) as picture:
            return mean_of(picture)


def mean_of(picture: Any) -> tuple[int, int, int]:
    """Return the mean colour of an open image."""
    if picture.width * picture.height > MOST_POINTS:
        raise ValueError(f"{picture.width}x{picture.height} points")
    red, green, blue = picture.convert("RGB").resize((1, 1), 4).getpixel((0, 0))  # 4: box filter
    return red, green, blue


def _dot(colour: tuple[int, int, int]) -> bytes:
    from PIL import Image

    out = io.BytesIO()
    Image.new("RGB", (1, 1), colour).save(out, "PNG")
    return out.getvalue()


__all__ = ["Beside", "mean_colour", "mean_of"]
