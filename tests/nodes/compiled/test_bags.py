"""rosbag2_cpp of compiled programs: rosbag2_py writes and reads for them."""

from __future__ import annotations

import os

from rclpy.serialization import deserialize_message
from rosbag2_py import SequentialReader, StorageOptions
from std_msgs.msg import Int32

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program


def run(session, build, folder):
    process = session.launch(make_process(session, build("bags", program("bags.cpp")), name="bags", cwd=folder))
    assert process.wait(20.0) == 0, process.output
    return [line for line in process.output.splitlines() if "[rosbag2_storage]" not in line], process.output


def test_bags_are_written_and_read(session, build, tmp_path):
    said, everything = run(session, build, tmp_path)
    assert said == [
        "Failed to write on topic 'unknown'. Call create_topic() before first write.",
        "Bag directory already exists (bag), can't overwrite existing bag",
        *said[2:4],
        "6sqlite3bag_0.db3 13999999980 20 63",
        "number std_msgs/msg/Int32 cdr",
        "text std_msgs/msg/String cdr",
        "20 text by reference",
        "10000000000 number",
        "11000000000 number",
        "12000000000 number",
        "13000000000 text shared",
        "14000000000 text by reference",
        "Bag is at end. No next message.",
        "120",
        "text",
    ], everything
    assert "nowhere" in said[2], everything
    assert said[3] == "Bag is not open. Call open() before reading."
    assert "[INFO] " in everything
    assert f"Opened database 'bag{os.sep}bag_0.db3' for READ_WRITE." in everything
    assert "Opened database" in everything.split("READ_WRITE")[-1]


def test_python_reads_what_cpp_wrote(session, build, tmp_path):
    run(session, build, tmp_path)
    reader = SequentialReader()
    reader.open(StorageOptions(uri=str(tmp_path / "bag")))
    reader.read_next()
    topic, data, stamp = reader.read_next()
    assert (topic, stamp, deserialize_message(data, Int32)) == ("number", 10_000_000_000, Int32(data=0))
