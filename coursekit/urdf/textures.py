"""The files that a mesh refers to: textures, materials and buffers, found as Gazebo does, and read nowhere else."""

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
"""Of a model: where textures lie."""
MOST = 64 << 20
"""The largest file beside a mesh that is read [bytes]."""
MOST_POINTS = 4096 * 4096
"""Of a texture; more is drawn plain."""


class Beside(Resolver):
    """The files beside a mesh; `notes` tells in one line each what was not found or could not be read.

    A texture becomes a picture of one point in its mean colour: nothing more of it is drawn, and nothing huge is kept.
    """

    def __init__(self, mesh: Path) -> None:
        self.mesh = mesh
        self.notes: list[str] = []
        self.roots = list(dict.fromkeys(_model_of(one) for one in (mesh, mesh.resolve())))  # an install of links, too

    def write(self, name: str, data: Any) -> None:
        """Nothing is written."""
        raise PermissionError(name)

    def namespaced(self, namespace: str) -> Beside:
        """The same: names are looked for, not followed."""
        return self

    def keys(self) -> list[str]:
        """Nothing is listed."""
        return []

    def get(self, name: str) -> bytes:
        """The contents of a file beside the mesh; FileNotFoundError where there is none inside its model's folder."""
        word = unquote(name).replace("\\", "/").removeprefix("file://").strip()
        path = next((one for one in self._places(word) if is_file(one) and self._inside(one)), None)
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
        except Exception as error:  # the readers of ten formats fail in as many ways
            self._note(f"{kind} '{name}' cannot be read ({type(error).__name__}): it is drawn plain")
            if not picture:
                raise FileNotFoundError(name) from None
            return _dot((255, 255, 255))

    def _note(self, what: str) -> None:
        if what not in self.notes:
            self.notes.append(what)

    def _places(self, word: str) -> list[Path]:
        name = Path(word).name
        tails = [folder for root in [*self.roots, *model_folders()] for folder in (root / one for one in FOLDERS)]
        uri = word.removeprefix("model://")
        named = [folder / uri for folder in model_folders()] if uri != word else [self.mesh.parent / word]
        return [*named, self.mesh.parent / name, *(folder / name for folder in tails)]

    def _inside(self, path: Path) -> bool:
        real = path.resolve()
        return any(real.is_relative_to(one.resolve()) for one in [*self.roots, *model_folders()])


def _model_of(mesh: Path) -> Path:
    """The folder of the model or package that a mesh is part of: at the most four above it; else its own folder."""
    folder = mesh.absolute().parent
    for one in [folder, *folder.parents][:5]:
        if is_file(one / "model.config") or is_file(one / "package.xml"):
            return one
    return folder.parent if folder.name == "meshes" and len(folder.parents) > 2 else folder


def mean_colour(data: bytes) -> tuple[int, int, int]:
    """The mean colour of a picture, 0 to 255 each; any exception of the picture library, ValueError for huge ones."""
    from PIL import Image

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with Image.open(io.BytesIO(data)) as picture:
            return mean_of(picture)


def mean_of(picture: Any) -> tuple[int, int, int]:
    """The mean colour of a picture that is open already."""
    if picture.width * picture.height > MOST_POINTS:
        raise ValueError(f"{picture.width}x{picture.height} points")
    red, green, blue = picture.convert("RGB").resize((1, 1), 4).getpixel((0, 0))  # 4: the mean of a box
    return red, green, blue


def _dot(colour: tuple[int, int, int]) -> bytes:
    from PIL import Image

    out = io.BytesIO()
    Image.new("RGB", (1, 1), colour).save(out, "PNG")
    return out.getvalue()


__all__ = ["Beside", "mean_colour", "mean_of"]
