"""Logs are read as they are; bad lines are told and left out; nothing hostile gets far."""

from __future__ import annotations

import bz2
import gzip
import lzma
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from coursekit.slam.carmen import CarmenLog, read_log
from coursekit.slam.carmen_line import parse_laser

GOOD = "FLASER 4 1.0 2.0 3.0 81.91 0.1 0.2 0.3 0.1 0.2 0.3 12.5 host 12.5\n"
ROBOT = (
    "ROBOTLASER1 0 -1.570796 3.141593 0.017453 8.0 0.01 0 3 1.0 2.0 8.1 2 0 1 "
    "1.5 2.0 0.5 1.0 2.0 0.5 0.1 0.2 0.3 0.4 0.5 99.25 host 99.30\n"
)


def read(tmp_path: Path, text: str) -> CarmenLog:
    """A log from its text."""
    file = tmp_path / "a.clf"
    file.write_text(text)
    return read_log(file)


def test_a_flaser_line_gives_ranges_odometry_and_stamp() -> None:
    line = parse_laser("FLASER 2 1.5 2.5 1 2 0.5 0.9 2 0.5 10.25 host 11.0")
    assert line.ranges.tolist() == [1.5, 2.5] and line.stamp == 10.25
    assert tuple(line.odometry) == (0.9, 2.0, 0.5) and tuple(line.laser_pose) == (1.0, 2.0, 0.5)


def test_a_robotlaser_line_brings_its_own_sensor(tmp_path: Path) -> None:
    log = read(tmp_path, ROBOT)
    laser = log.lasers()[0]
    assert laser.angle_min == pytest.approx(-math.pi / 2) and laser.angle_increment == pytest.approx(0.017453)
    assert laser.range_max == 8.0 and log.readings[0].stamp == 99.25
    assert tuple(log.readings[0].odometry) == (1.0, 2.0, 0.5)


def test_old_lasers_look_over_180_degrees(tmp_path: Path) -> None:
    for beams, last in ((180, 89.0), (181, 90.0), (360, 89.5), (361, 90.0)):
        log = read(tmp_path, f"FLASER {beams} {'1.0 ' * beams}0 0 0 0 0 0 1 h 1\n")
        angles = np.degrees(log.lasers()[0].angles(beams))
        assert angles[0] == pytest.approx(-90) and angles[-1] == pytest.approx(last)


def test_the_lasers_place_comes_from_both_poses_or_from_the_parameters(tmp_path: Path) -> None:
    lines = [f"FLASER 1 2.0 {1.0 + 0.2} {k} 0 1.0 {k} 0 {k} h {k}\n" for k in range(5)]
    assert read(tmp_path, "".join(lines)).lasers()[0].offset.x == pytest.approx(0.2)
    told = "PARAM robot_frontlaser_offset 0.04 nohost 0\n" + GOOD
    assert read(tmp_path, told).lasers()[0].offset.x == pytest.approx(0.04)
    assert read(tmp_path, GOOD).lasers()[0].offset.x == 0.0


def test_corrected_logs_do_not_move_the_laser(tmp_path: Path) -> None:
    lines = [f"FLASER 1 2.0 {k * 1.1} 0 0 {k} 0 0 {k} h {k}\n" for k in range(5)]
    assert read(tmp_path, "".join(lines)).lasers()[0].offset.x == 0.0


@pytest.mark.parametrize("top", [8.0, 8.191, 31.9, 50.0, 51.2, 81.83, 81.91])
def test_the_value_for_no_return_is_found(tmp_path: Path, top: float) -> None:
    rng = np.random.default_rng(0)
    lines = []
    for k in range(20):
        ranges = np.where(rng.random(60) < 0.2, top, rng.uniform(0.5, 0.9 * min(top, 30), 60).round(2))
        lines.append(f"FLASER 60 {' '.join(map(str, ranges))} 0 0 0 {k} 0 0 {k} h {k}\n")
    limit = read(tmp_path, "".join(lines)).lasers()[0].range_max
    assert 0.9 * min(top, 30) < limit <= np.float32(top)


def test_a_log_whose_longest_range_is_a_wall_keeps_it(tmp_path: Path) -> None:
    lines = [f"FLASER 3 4.0 7.3{k} 7.4 0 0 0 {k} 0 0 {k} h {k}\n" for k in range(5)]
    assert read(tmp_path, "".join(lines)).lasers()[0].range_max > 7.4


def test_a_constant_pose_is_no_odometry(tmp_path: Path) -> None:
    assert not read(tmp_path, GOOD * 3).has_odometry
    assert read(tmp_path, GOOD + GOOD.replace("0.1 0.2 0.3 12.5", "0.2 0.2 0.3 12.5")).has_odometry


@pytest.mark.parametrize("pack", [gzip.compress, lzma.compress, bz2.compress])
@pytest.mark.parametrize("name", ["a.clf.gz", "a.log", "a.xz"])
def test_packed_logs_are_known_by_their_first_bytes(tmp_path: Path, pack, name: str) -> None:
    (tmp_path / name).write_bytes(pack(GOOD.encode() * 3))
    assert len(read_log(tmp_path / name).readings) == 3


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("FLASER", "the number of beams is missing"),
        ("FLASER x 1 2 3 4 5 6 7 8 9", "the number of beams is missing"),
        ("FLASER 5 1.0 2.0 0 0 0 0 0 0 1 h 1", "5 beams announced, but the line ends"),
        ("FLASER 1 1.0 2.0 3.0 4.0 0 0 0 0 0 0 1 h 1", "1 beams announced, but 12 words follow"),
        ("FLASER 0 0 0 0 0 0 0 1 h 1", "0 beams"),
        ("FLASER -3 0 0 0 0 0 0 1 h 1", "-3 beams"),
        ("FLASER 99999999999 1.0", "beams: expected 1 to"),
        ("FLASER 2 1.0 two 0 0 0 0 0 0 1 h 1", "a range is no number"),
        ("FLASER 1 1.0 0 0 0 nan 0 0 1 h 1", "the odometry should be a number"),
        ("FLASER 1 1.0 0 0 0 1e300 0 0 1 h 1", "farther than"),
        ("FLASER 1 1.0 0 0 0 0 0 0 soon h 1", "the stamp should be a number"),
        ("ROBOTLASER1 0 0 0", "the number of beams is missing"),
        ("RAWLASER1 0 -1.57 3.14 0.01 8.0 0.01 0 2 1.0 2.0", "the line ends"),
        ("ODOM 1 2", "ODOM has 3 words: expected 10"),
        ("ODOM 1 2 x 0 0 0 1.0 h 1.0", "the odometry should be a number"),
        (ROBOT.replace(" 2 0 1 ", " 999999999 0 1 ").strip(), "999999999 remission values announced"),
    ],
)
def test_bad_lines_are_told_with_their_number_and_left_out(tmp_path: Path, line: str, says: str) -> None:
    log = read(tmp_path, f"# a comment\n{GOOD}{line}\n{GOOD}")
    assert len(log.readings) == 2 and log.bad == 1
    assert log.complaints[0].startswith("line 3: ") and says in log.complaints[0]


ODOM = "ODOM {0} 0 0 0.5 0 0 {0}.0 host {0}.0\n"
RAW = "RAWLASER1 0 -1.570796 3.141593 0.017453 8.0 0.01 0 3 1.0 2.0 8.1 0 {} host 1.0\n"


@pytest.mark.parametrize("line", [RAW, "FLASER 3 1.0 2.0 8.1 {} host 1.0\n"])
def test_scans_without_a_pose_take_it_from_the_odometry_s_own_lines(tmp_path: Path, line: str) -> None:
    text = "SYNC tag\nTRUEPOS 0 0 0 0 0 0 1 h 1\n" + line.format(1.25) + line.format(9.0)
    log = read(tmp_path, text + "".join(ODOM.format(k) for k in (3, 1, 2)))
    assert [reading.odometry.x for reading in log.readings if reading.odometry] == pytest.approx(
        [1.25, 3.0]
    ) and log.has_odometry
    assert log.lasers()[0].angle_min == pytest.approx(-math.pi / 2)
    assert not read(tmp_path, text).has_odometry


def test_raw_scans_beside_those_of_the_robot_are_not_taken_twice(tmp_path: Path) -> None:
    log = read(tmp_path, RAW.format(99.2) + ROBOT + RAW.format(99.3) + ROBOT)
    assert [reading.kind for reading in log.readings] == ["ROBOTLASER1"] * 2


def test_many_bad_lines_are_counted_not_listed(tmp_path: Path) -> None:
    log = read(tmp_path, GOOD + "FLASER 3 nothing\n" * 1000)
    assert log.bad == 1000 and len(log.complaints) == 20


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"", "is empty"),
        (b"\n\n# only comments\n", "is empty"),
        (
            b"<html>\n<body>",
            "is no CARMEN log: no line begins with FLASER, ROBOTLASER1 or RAWLASER1 (found '<html>', '<body>')",
        ),
        (b"FLASER 9 1.0\n", "none of its 1 scans can be read; line 1"),
        (b"\xfd7zXZ\x00broken", "is damaged"),
        (lzma.compress(GOOD.encode() * 200)[:-40], "is damaged"),
        (gzip.compress(GOOD.encode() * 200)[:-9], "is damaged"),
        (bytes(range(256)) * 50, "is no CARMEN log"),
    ],
)
def test_foreign_files_are_refused_with_the_reason(tmp_path: Path, data: bytes, says: str) -> None:
    file = tmp_path / "foreign.clf"
    file.write_bytes(data)
    with pytest.raises(ValueError) as caught:
        read_log(file)
    assert says in str(caught.value)


def test_missing_files_and_folders_are_told(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="no file"):
        read_log(tmp_path / "gone.clf")
    with pytest.raises(IsADirectoryError, match="is a folder"):
        read_log(tmp_path)


words = st.sampled_from(
    ["FLASER", "ROBOTLASER1", "PARAM", "ODOM", "180", "3", "-1", "1e999", "nan", "inf", "0.5", "x", "\x00"]
)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=200)
@given(st.lists(st.lists(words | st.text(max_size=5), max_size=25).map(" ".join), max_size=8))
def test_no_text_whatever_makes_the_reader_fall_over(tmp_path: Path, lines: list[str]) -> None:
    file = tmp_path / "fuzz.clf"
    file.write_text("\n".join([GOOD.strip(), *lines]), encoding="utf-8", errors="replace")
    log = read_log(file)
    assert log.readings and len(log.lasers()) == len(log.readings)


def test_a_file_without_line_ends_does_not_fill_the_memory(tmp_path: Path) -> None:
    file = tmp_path / "long.xz"
    file.write_bytes(lzma.compress(b"FLASER 4 " + b"1.0 " * 5_000_000))
    with pytest.raises(ValueError, match="none of its|is no CARMEN log"):
        read_log(file)
