"""Maps as files: a description (.yaml) and an image, in the format of nav2's map server and map saver."""

from __future__ import annotations

import errno
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from coursekit.files import read_bytes, write_whole
from coursekit.nav.map_cells import FREE_BELOW, MODES, OCCUPIED_ABOVE, cells_of, picture_of
from coursekit.nav.map_error import MapError
from coursekit.nav.map_picture import FORMATS, read_picture, write_picture

MAX_DESCRIPTION_BYTES = 65536
_CURE_KEYS = "a description needs image, resolution, origin, negate, occupied_thresh and free_thresh"


@dataclass(frozen=True)
class GridMap:
    """Cells int8 (rows, columns), row 0 at the smallest y: 0 free ... 100 occupied, -1 unknown.

    `resolution` is metres per cell; `origin` is (x, y, yaw) of the corner of cell (0, 0) in metres and radians.
    """

    cells: np.ndarray
    resolution: float
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class MapDescription:
    """The content of a map's .yaml; `image` is the image's full path."""

    image: Path
    resolution: float
    origin: tuple[float, float, float]
    negate: bool = False
    occupied_thresh: float = OCCUPIED_ABOVE
    free_thresh: float = FREE_BELOW
    mode: str = "trinary"

    @property
    def crossed(self) -> bool:
        """Whether some shades are both below `free_thresh` and above `occupied_thresh`: they become walls.

        >>> MapDescription(Path("room.pgm"), 0.05, (0.0, 0.0, 0.0), occupied_thresh=0.2, free_thresh=0.8).crossed
        True
        """
        return self.free_thresh > self.occupied_thresh


def load_map(path: str | Path) -> GridMap:
    """Load the map of a .yaml file; MapError when the description or its image is invalid."""
    return load_picture(read_description(path))


def load_picture(description: MapDescription) -> GridMap:
    """Load the map of a description; MapError (part 'picture') when the image cannot be read."""
    shades = read_picture(description.image)
    cells = cells_of(
        shades,
        mode=description.mode,
        negate=description.negate,
        occupied_thresh=description.occupied_thresh,
        free_thresh=description.free_thresh,
    )
    return GridMap(np.ascontiguousarray(cells[::-1]), description.resolution, description.origin)


def save_map(
    path: str | Path,
    grid: GridMap,
    *,
    mode: str = "trinary",
    image_format: str = "",
    occupied_thresh: float = OCCUPIED_ABOVE,
    free_thresh: float = FREE_BELOW,
) -> tuple[Path, Path]:
    """Write PATH.yaml and its image; return both full paths.

    The default format is pgm, or png in mode 'scale'. A PATH that ends in .yaml loses that suffix first.

    Raises MapError for an empty map and for incompatible settings, OSError when a file cannot be written.

    >>> import tempfile
    >>> grid = GridMap(np.array([[0, 100, -1]], np.int8), 0.05, (-1.0, 0.0, 0.0))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     description, picture = save_map(Path(folder, "room"), grid)
    ...     print(description.read_text(encoding="utf-8"), load_map(description).cells.tolist(), end="")
    image: room.pgm
    mode: trinary
    resolution: 0.05
    origin: [-1, 0, 0]
    negate: 0
    occupied_thresh: 0.65
    free_thresh: 0.196
     [[0, 100, -1]]
    """
    text = str(path)
    stem = Path(text[:-5] if text.endswith(".yaml") else text).absolute()
    kind = image_format.lower() or ("png" if mode == "scale" else "pgm")
    _check_settings(str(stem), mode, kind, occupied_thresh, free_thresh)
    if not grid.cells.size:
        raise MapError(str(stem), "the map is empty", "save it once a map has been made")
    cells = np.asarray(grid.cells)[::-1]
    shades = picture_of(cells, mode=mode, occupied_thresh=occupied_thresh, free_thresh=free_thresh)
    picture, description = Path(f"{stem}.{kind}"), Path(f"{stem}.yaml")
    write_picture(picture, shades)
    write_whole(description, _described(picture.name, grid, mode, occupied_thresh, free_thresh))
    return description, picture


def _described(image: str, grid: GridMap, mode: str, occupied: float, free: float) -> str:
    x, y, yaw = grid.origin
    name = yaml.safe_dump(image, width=10_000, allow_unicode=True).partition("\n")[0]
    return (
        f"image: {name}\nmode: {mode}\nresolution: {grid.resolution:.6g}\norigin: [{x:.6g}, {y:.6g}, {yaw:.6g}]\n"
        f"negate: 0\noccupied_thresh: {occupied:.6g}\nfree_thresh: {free:.6g}\n"
    )


def _check_settings(file: str, mode: str, kind: str, occupied: float, free: float) -> None:
    _check_mode(file, mode)
    if kind not in FORMATS:
        raise MapError(file, f"unknown picture format '{kind}'", f"use one of: {', '.join(FORMATS)}")
    if mode == "scale" and kind != "png":
        raise MapError(file, f"mode 'scale' needs transparency, which {kind} has not", "use the format png")
    _check_thresholds(file, mode, occupied, free)


# -- reading the description


def read_description(path: str | Path) -> MapDescription:
    """Parse a .yaml file; MapError (part 'metadata') with the file, the fault and its remedy."""
    file = Path(path)
    entries = _entries(file)
    name = str(file)
    image = entries.get("image")
    if not isinstance(image, str) or not image:
        raise MapError(name, "the key 'image' is missing or no file name", _CURE_KEYS)
    mode = entries.get("mode", "trinary")
    mode = mode.lower() if isinstance(mode, str) else mode
    _check_mode(name, mode)
    resolution = _number(name, entries, "resolution")
    if resolution <= 0:
        raise MapError(name, f"resolution is {resolution:g}", "it is metres a cell, for example 0.05")
    occupied, free = _number(name, entries, "occupied_thresh"), _number(name, entries, "free_thresh")
    if mode == "scale":
        _check_thresholds(name, mode, occupied, free)
    where = file.absolute().parent / image
    return MapDescription(where, resolution, _origin(name, entries), _negate(name, entries), occupied, free, mode)


class _Untagged(yaml.SafeLoader):
    """Ignores tags, as the map server does: Python's yaml.dump adds one to a tuple."""

    def _plain(self, _tag: str, node: yaml.Node) -> Any:
        if isinstance(node, yaml.MappingNode):
            return self.construct_mapping(node, deep=True)
        return self.construct_sequence(node, deep=True) if isinstance(node, yaml.SequenceNode) else node.value


_Untagged.add_multi_constructor("", _Untagged._plain)


def _entries(file: Path) -> dict[str, Any]:
    name = str(file)
    try:
        data = read_bytes(file, MAX_DESCRIPTION_BYTES)
    except OSError as error:
        if error.errno == errno.EFBIG:
            raise MapError(name, "is too large for a map's description", "name the .yaml file, not the picture") from None
        raise MapError(name, f"cannot be read: {error.strerror}", "name the .yaml file of a map") from None
    try:
        entries = yaml.load(data.decode("utf-8"), _Untagged)
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        first = " ".join(str(error).split())[:200]
        raise MapError(name, f"is no YAML: {first}", _CURE_KEYS) from None
    if not isinstance(entries, dict):
        raise MapError(name, "holds no 'key: value' lines", _CURE_KEYS)
    return entries


def _number(file: str, entries: dict[str, Any], key: str) -> float:
    if key not in entries:
        raise MapError(file, f"the key '{key}' is missing", _CURE_KEYS)
    return _finite(file, key, entries[key])


def _finite(file: str, key: str, value: Any) -> float:
    try:
        number = math.nan if isinstance(value, bool) else float(value)
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not math.isfinite(number):
        raise MapError(file, f"{key} is {str(value)[:40]!r}, not a number", f"write for example '{key}: 0.05'")
    return number


def _origin(file: str, entries: dict[str, Any]) -> tuple[float, float, float]:
    value = entries.get("origin")
    if not isinstance(value, list) or len(value) != 3:
        raise MapError(file, "origin is not three numbers", "write 'origin: [x, y, yaw]' in metres and radians")
    x, y, yaw = (_finite(file, "origin", number) for number in value)
    return x, y, yaw


def _negate(file: str, entries: dict[str, Any]) -> bool:
    value = entries.get("negate")
    if value not in (0, 1):
        raise MapError(file, f"negate is {str(value)[:40]!r}", "write 'negate: 0' (dark is occupied) or 'negate: 1'")
    return bool(value)


def _check_mode(file: str, mode: Any) -> None:
    if not isinstance(mode, str) or mode not in MODES:
        raise MapError(file, f"unknown mode {str(mode)[:40]!r}", f"use one of: {', '.join(MODES)}")


def _check_thresholds(file: str, mode: str, occupied: float, free: float) -> None:
    fine = 0.0 <= free <= occupied <= 1.0 and (mode != "scale" or free < occupied)
    if not fine:
        what = f"free_thresh {free:g} and occupied_thresh {occupied:g} do not go together"
        raise MapError(file, what, f"0 <= free < occupied <= 1, for example {FREE_BELOW} and {OCCUPIED_ABOVE}")
