"""Compiled programs: message_filters, laser_geometry, wait sets, guard conditions, messages as bytes, adapted types."""

from __future__ import annotations

import pytest
from laser_geometry import LaserProjection
from sensor_msgs.msg import LaserScan

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program


@pytest.fixture
def start(session, build):
    def started(name):
        return session.launch(make_process(session, build(name, program(f"{name}.cpp")), name=name))

    return started


def test_messages_are_put_together_by_equal_and_by_close_stamps(start):
    process = start("filters")
    assert process.wait(20.0) == 0, process.output
    assert process.output.splitlines() == [
        "100+103 200+201 300+309 400+400 ",
        "130+128 190+190 ",
        "30+31 ",  # 40 and 41 wait: what comes next could be closer
        "121+120 203+200 ",
        "|100+101 ",
        "110+106 120+125 146+150 |20+23 ",  # 110 and 106 first: 114 came later
        *("equal 100 100", "close 100 100", "close 200 205", "equal 300 300", "close 300 300", "equal 400 400"),
        "close 400 400",
        "300400231200400",
        "1",
    ]


def test_filters_stand_in_a_row_and_messages_are_put_in_order(start):
    process = start("chains")
    assert process.wait(20.0) == 0, process.output
    assert process.output.splitlines() == ["01112", "0 in time", "1 in time", "2 in time"]  # one that is late is lost


def test_the_last_messages_come_with_each_of_the_topic_that_comes_most_often(start):
    process = start("latest")
    assert process.wait(20.0) == 0, process.output
    assert process.output.split() == ["4:5", "4:6", "4:7", "8:9", "8:10", "8:11", "12:13", "12:14", "12:15"]


def test_a_program_waits_by_itself_and_messages_go_as_bytes(session, start):
    process = start("waits")
    session.clock.sleep(2.0)
    assert process.output.splitlines() == [
        "11101021",
        "called with hello",
        "0",
        "1 after 50 10110",
        "timer's callback",
        "0guard condition already in use by another wait set1",
        "12abc97[INFO] [1700000000.300000000] [rclcpp]: Currently used middleware can't loan messages. "
        "Local allocator will be used.",
        " typed abc raw 12 also 12 typed abc raw 12 also 12 typed lent raw 13 also 13",
        "custom one plain one" + "custom two plain two" + "custom three plain three",
        "waits",
    ]
    process.interrupt()
    assert process.wait(5.0) == 0
    assert process.output.splitlines()[-1] == "10"


def printed(cloud):
    """A cloud as the program prints it."""
    fields = "".join(f" {field.name}{field.offset}" for field in cloud.fields)
    bytes_ = "".join(f" {byte:x}" for byte in bytes(cloud.data))
    return f"{cloud.header.frame_id} {cloud.width} {cloud.point_step}{int(cloud.is_dense)}{fields}{bytes_}"


def test_a_scan_becomes_the_cloud_that_python_makes_of_it(start):
    process = start("scans")
    assert process.wait(20.0) == 0, process.output
    scan = LaserScan(angle_min=-1.0, angle_increment=0.5, time_increment=0.25, range_min=0.1, range_max=10.0)
    scan.header.frame_id = "laser"
    scan.ranges, scan.intensities = [1.0, 0.05, 2.5, 20.0, 4.0], [5.0, 6.0, 7.0, 8.0, 9.0]
    projection = LaserProjection()
    option = LaserProjection.ChannelOption
    assert process.output.splitlines() == [
        printed(projection.projectLaser(scan)),
        printed(projection.projectLaser(scan, 3.0, option.DISTANCE | option.TIMESTAMP)),
        "map 101 101.25 101.5 101.75 102",  # the scanner moves by a metre while it looks ahead
    ]
