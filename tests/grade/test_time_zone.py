"""A container tells times as the computer around it does."""

import argparse
import os
import time

import pytest

from coursekit.cli.grading import add_commands
from coursekit.grade.container import Marking
from coursekit.grade.time_zone import posix_zone
from tests.needs import posix

from .handed import NOON

ZONES = {
    "CET-1CEST,M3.5.0,M10.5.0/3": "<+0100>-01:00<+0200>-02:00,J88/02:00,J298/03:00",
    "EST5EDT,M3.2.0,M11.1.0": "<-0500>05:00<-0400>04:00,J67/02:00,J305/02:00",
    "<-06>6": "<-0600>06:00",
    "IST-5:30": "<+0530>-05:30",
    "AEST-10AEDT,M10.1.0,M4.1.0/3": "<+1000>-10:00<+1100>-11:00,J277/02:00,J95/03:00",
    "UTC0": "<+0000>-00:00",
}


@pytest.fixture
def zone():
    """Sets the zone of this process."""
    before = os.environ.get("TZ")

    def enter(text):
        os.environ["TZ"] = text
        time.tzset()

    yield enter
    if before is None:
        del os.environ["TZ"]
    else:
        os.environ["TZ"] = before
    time.tzset()


@posix("Windows cannot change the zone of a process")
@pytest.mark.parametrize("name", ZONES)
def test_each_hour_of_the_year_is_the_same_in_the_container(zone, name):
    zone(name)
    moments = [int(time.mktime((2026, 1, 1, 0, 0, 0, 0, 0, -1))) + 1800 * number for number in range(2 * 24 * 365)]
    around = [time.localtime(moment)[:6] for moment in moments]
    tz = posix_zone(NOON)
    assert tz == ZONES[name]
    zone(tz)
    assert [time.localtime(moment)[:6] for moment in moments] == around


@posix("Windows cannot change the zone of a process")
def test_the_container_is_told_this_computer_s_zone(zone, tmp_path):
    """A deadline in a policy has no zone: in UTC, a class in Mexico would be late by six hours."""
    parser = argparse.ArgumentParser()
    add_commands(parser.add_subparsers())
    said = ["grade", str(tmp_path), "--out", str(tmp_path / "grades.csv"), "--due", "2026-11-23T12:00"]
    zone("CET-1CEST,M3.5.0,M10.5.0/3")
    words = Marking("podman", parser.parse_args(said)).command("tag")
    assert words[words.index("TZ=<+0100>-01:00<+0200>-02:00,J88/02:00,J298/03:00") - 1] == "--env"
