"""Maps as files, beside what nav2's map server makes of the same ones."""

import tracemalloc

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from coursekit.nav.map_cells import cells_of, picture_of
from coursekit.nav.map_error import MapError
from coursekit.nav.map_file import GridMap, load_map, save_map

TEXT = """image: room.{kind}
resolution: 0.05
origin: [-1.0, 2.5, 0.3]
negate: {negate}
occupied_thresh: 0.65
free_thresh: 0.196
"""
CELLS = np.array([[0, 100, -1], [-1, 0, 0]], dtype=np.int8)


def write(folder, shades, *, kind="png", negate=0, more=""):
    cv2.imwrite(str(folder / f"room.{kind}"), np.array(shades, dtype=np.uint8))
    path = folder / "room.yaml"
    path.write_text(TEXT.format(kind=kind, negate=negate) + more)
    return path


@pytest.mark.parametrize("kind", ["pgm", "png", "bmp"])
def test_a_saved_map_reads_back_the_same(tmp_path, kind):
    description, picture = save_map(tmp_path / "house", GridMap(CELLS, 0.05, (-1.5, 2.0, 0.5)), image_format=kind)
    assert (description, picture) == (tmp_path / "house.yaml", tmp_path / f"house.{kind}")
    read = load_map(description)
    assert read.cells.tolist() == CELLS.tolist()
    assert (read.resolution, read.origin) == (0.05, (-1.5, 2.0, 0.5))


def test_a_saved_map_has_the_shades_and_thresholds_that_keep_unknown_unknown(tmp_path):
    description, picture = save_map(tmp_path / "house.yaml", GridMap(CELLS, 0.05))
    assert cv2.imread(str(picture), cv2.IMREAD_UNCHANGED).tolist() == [[205, 254, 254], [254, 0, 205]]
    assert description.read_text().splitlines() == [
        "image: house.pgm",
        "mode: trinary",
        "resolution: 0.05",
        "origin: [0, 0, 0]",
        "negate: 0",
        "occupied_thresh: 0.65",
        "free_thresh: 0.196",
    ]


def test_crossed_thresholds_are_read_as_nav2_reads_them(tmp_path):
    path = write(tmp_path, [[0, 120, 205, 254]])
    path.write_text(path.read_text().replace("free_thresh: 0.196", "free_thresh: 0.9").replace("0.65", "0.25"))
    assert load_map(path).cells.tolist() == [[100, 100, 0, 0]]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("negate: 0", "negate: false"),
        ("image: room.png", "image: ./room.png"),
        ("image: room.png", "image: {folder}/room.png"),
        ("negate: 0", "negate: 0\nmode: Trinary"),
        ("\n", "\r\n"),
        ("origin: [-1.0, 2.5, 0.3]", "origin: [-10, 5, 0]"),
        ("image:", "# made by a friend\n---\nimage:"),
        ("origin: [-1.0, 2.5, 0.3]", "origin: !!python/tuple\n- -1.0\n- 2.5\n- 0.3"),
        ("negate: 0", "negate: 0\nmode: !mine trinary"),
    ],
)
def test_other_peoples_spellings_are_read(tmp_path, old, new):
    path = write(tmp_path, [[0, 254]])
    text = path.read_text().replace(old, new.format(folder=tmp_path))
    path.write_bytes(text.encode())
    assert load_map(path).cells.tolist() == [[100, 0]]


def test_row_0_of_the_picture_is_the_top(tmp_path):
    assert load_map(write(tmp_path, [[0, 254], [254, 254]])).cells.tolist() == [[0, 0], [100, 0]]


@pytest.mark.parametrize(("negate", "expected"), [(0, [100, -1, 0]), (1, [0, 100, 100])])
def test_negate_turns_dark_into_free(tmp_path, negate, expected):
    assert load_map(write(tmp_path, [[0, 205, 255]], negate=negate)).cells.tolist() == [expected]


def test_a_shade_on_a_threshold_is_unknown():
    shades = np.array([[0, 51, 255]], dtype=np.uint8)
    assert cells_of(shades, mode="trinary", negate=True, occupied_thresh=0.2, free_thresh=0.2).tolist() == [[0, -1, 100]]


def test_scale_mode_spreads_what_is_between_the_thresholds(tmp_path):
    path = write(tmp_path, [[255, 205, 150, 127, 90, 0]], more="mode: scale\n")
    occupied = 1 - np.array([205, 150, 127]) / 255
    between = np.rint((occupied - 0.196) / (0.65 - 0.196) * 100).astype(int).tolist()
    assert load_map(path).cells.tolist() == [[0, *between, 99, 100]]


def test_transparent_cells_are_unknown_in_scale_mode_only(tmp_path):
    shades = [[[0, 0, 0, 255], [0, 0, 0, 254], [255, 255, 255, 0]]]
    assert load_map(write(tmp_path, shades, more="mode: scale\n")).cells.tolist() == [[100, -1, -1]]
    assert load_map(write(tmp_path, shades, more="mode: raw\n")).cells.tolist() == [[0, 0, -1]]


def test_an_opaque_picture_gives_the_cells_of_the_same_picture_without_alpha(tmp_path):
    opaque = [[[shade, shade, shade, 255] for shade in (0, 150, 254)]]
    assert load_map(write(tmp_path, opaque)).cells.tolist() == [[100, -1, 0]]
    clear = [[[255, 255, 255, 0]]]
    assert load_map(write(tmp_path, clear)).cells.tolist() == [[-1]]


@pytest.mark.parametrize("kind", ["jpg", "tif", "pbm"])
def test_pictures_in_other_formats_are_read(tmp_path, kind):
    shades = np.full((16, 16), 255, np.uint8)
    shades[:, 8:] = 0
    cv2.imwrite(str(tmp_path / f"room.{kind}"), shades)
    path = write(tmp_path, [[0]])
    path.write_text(path.read_text().replace("room.png", f"room.{kind}"))
    assert load_map(path).cells.tolist() == [[0] * 8 + [100] * 8] * 16


def test_a_large_picture_needs_little_more_memory_than_its_cells():
    picture = np.full((3000, 3000), 254, np.uint8)
    picture[1000:, :1000] = 0
    tracemalloc.start()
    cells = cells_of(picture, mode="trinary", negate=False, occupied_thresh=0.65, free_thresh=0.196)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert most < 6 * picture.nbytes
    assert np.array_equal(cells, np.where(picture == 0, 100, 0))


def test_raw_mode_keeps_the_values_to_100(tmp_path):
    path = write(tmp_path, [[0, 1, 100, 101, 255]], more="mode: raw\n", negate=1)
    assert load_map(path).cells.tolist() == [[0, 1, 100, -1, -1]]


@given(arrays(np.int8, (3, 4), elements=st.integers(-1, 100)))
def test_raw_and_scale_pictures_keep_every_cell(cells):
    for mode in ("raw", "scale"):
        picture = picture_of(cells, mode=mode, occupied_thresh=1.0, free_thresh=0.0)
        back = cells_of(picture, mode=mode, negate=False, occupied_thresh=1.0, free_thresh=0.0)
        assert back.tolist() == cells.tolist()


@pytest.mark.parametrize(
    "data",
    [b"P2 # by hand\n3 1\n# four shades\n4\n0 4 2\n", b"P5\n3 1\n4\n\x00\x04\x02", b"P5 3 1 65535\n\0\0\xff\xff\x80\0"],
)
def test_pgm_files_of_every_kind_are_read(tmp_path, data):
    path = write(tmp_path, [[0]], kind="pgm")
    (tmp_path / "room.pgm").write_bytes(data)
    assert load_map(path).cells.tolist() == [[100, 0, -1]]


@pytest.mark.parametrize(
    ("old", "new", "part", "says"),
    [
        ("image: room.png", "image: no.png", "picture", "No such file"),
        ("image: room.png\n", "", "metadata", "'image' is missing"),
        ("resolution: 0.05\n", "", "metadata", "'resolution' is missing"),
        ("resolution: 0.05", "resolution: small", "metadata", "'small', not a number"),
        ("resolution: 0.05", "resolution: .nan", "metadata", "not a number"),
        ("resolution: 0.05", "resolution: -1", "metadata", "metres a cell"),
        ("origin: [-1.0, 2.5, 0.3]", "origin: [1, 2]", "metadata", "[x, y, yaw]"),
        ("negate: 0", "negate: maybe", "metadata", "negate is 'maybe'"),
        ("free_thresh: 0.196", "free_thresh: 0.7\nmode: scale", "metadata", "do not go together"),
        ("free_thresh: 0.196\n", "", "metadata", "'free_thresh' is missing"),
        ("negate: 0", "negate: 0\nmode: fuzzy", "metadata", "trinary, scale, raw"),
        ("negate: 0", "negate: [", "metadata", "no YAML"),
        ("negate: 0", "negate: " + "[" * 5000, "metadata", "no YAML"),
    ],
)
def test_a_bad_description_says_the_file_the_fault_and_the_cure(tmp_path, old, new, part, says):
    path = write(tmp_path, [[0]])
    path.write_text(path.read_text().replace(old, new))
    with pytest.raises(MapError) as caught:
        load_map(path)
    assert caught.value.part == part
    assert says in str(caught.value)
    assert str(tmp_path) in str(caught.value) and caught.value.cure


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"P5\n100000 100000\n255\n", "100000 x 100000 pixels"),
        (b"\x89PNG\r\n\x1a\n" + b"\0\0\0\rIHDR" + b"\0\1\0\0" * 2 + b"\0" * 9, "65536 x 65536 pixels"),
        (b"P5\n2 2\n255\n\0", "ends before"),
        (b"P2\n2 1\n255\n1 x", "no shade"),
        (b"P5\n0 2\n255\n", "at least one pixel"),
        (b"BM" + b"\1" * 40, "pixels"),
        (b"hello", "pgm, png, bmp"),
        (b"", "pgm, png, bmp"),
    ],
)
def test_a_bad_picture_is_refused_before_it_takes_memory(tmp_path, data, says):
    path = write(tmp_path, [[0]])
    (tmp_path / "room.png").write_bytes(data)
    with pytest.raises(MapError) as caught:
        load_map(path)
    assert caught.value.part == "picture"
    assert says in str(caught.value)


def test_a_missing_file_and_a_picture_in_its_place_are_told(tmp_path):
    with pytest.raises(MapError, match="No such file"):
        load_map(tmp_path / "none.yaml")
    (tmp_path / "big.yaml").write_bytes(b"#" * 100_000)
    with pytest.raises(MapError, match="too large"):
        load_map(tmp_path / "big.yaml")


@pytest.mark.parametrize(
    ("settings", "says"),
    [
        ({"mode": "scale", "image_format": "pgm"}, "transparency"),
        ({"mode": "odd"}, "unknown mode"),
        ({"image_format": "gif"}, "unknown picture format"),
        ({"free_thresh": 0.9}, "do not go together"),
    ],
)
def test_settings_that_do_not_go_together_write_nothing(tmp_path, settings, says):
    with pytest.raises(MapError, match=says):
        save_map(tmp_path / "house", GridMap(CELLS, 0.05), **settings)
    assert list(tmp_path.iterdir()) == []


def test_an_empty_map_is_not_saved(tmp_path):
    with pytest.raises(MapError, match="empty"):
        save_map(tmp_path / "house", GridMap(np.empty((0, 0), dtype=np.int8), 0.05))
