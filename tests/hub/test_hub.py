"""A class on one server: a real JupyterHub, whose students run chapters at once, each in a graph of their own.

COURSEKIT_HUB_STUDENTS says how many, and COURSEKIT_HUB_CHAPTERS which (`make hub`: 20 students, chapters 01 and 08).
"""

import json
import os
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade.roster import Person, Roster
from tests.grade.handed import collected
from tests.notebooks.running import chapters, code_cells, read

from .server import Hub, missing
from .student import Student

pytestmark = [
    pytest.mark.timeout(1500),
    pytest.mark.slow,
    pytest.mark.skipif(bool(missing()), reason=f"NOT TESTED: {missing()}"),
]
COUNT = int(os.environ.get("COURSEKIT_HUB_STUDENTS", "3"))
CHAPTERS = os.environ.get("COURSEKIT_HUB_CHAPTERS", "01").split()
OWN_NODE = """
import rclpy
from std_msgs.msg import String
rclpy.init()
own = rclpy.create_node("{name}")
_ = own.create_publisher(String, "only_{name}", 10)
"""


@pytest.fixture(scope="module")
def hub(tmp_path_factory):
    # As `coursekit hub-prepare` does: SLAM compiled once, not by each student in the same minute.
    subprocess.run([sys.executable, "-m", "coursekit.cli.compile_ahead"], check=True)
    folder = tmp_path_factory.mktemp("hub")
    exchange = folder / "exchange"
    assert main(["release", "02", "--exchange", str(exchange), "--out", str(folder / "week2")]) == 0
    hub = Hub(folder, COURSEKIT_EXCHANGE=str(exchange))
    hub.wait_until_ready()
    yield hub
    hub.close()


@pytest.fixture(scope="module")
def students(hub):
    students = [Student(hub, f"student{number:02}") for number in range(COUNT)]
    with ThreadPoolExecutor(COUNT) as pool:
        list(pool.map(Student.start, students))
    return students


def cells_of(prefix):
    [chapter] = [path for path in chapters() if path.name.startswith(prefix)]
    return [cell.source for cell in code_cells(read(chapter))]


def test_each_student_has_a_copy_of_the_course(students):
    for student in students:
        there = {entry["name"] for entry in student.ask("GET", "contents")["content"]}
        assert {"00_start_here.ipynb", "01_first_nodes.ipynb", "08_maps_and_slam.ipynb"} <= there
        notebook = student.ask("GET", "contents/01_first_nodes.ipynb")["content"]
        assert "BEGIN SOLUTION" not in json.dumps(notebook)
        released = student.ask("GET", "contents/02_topics.ipynb")["content"]
        assert released["metadata"]["coursekit"]["handed_out"] == "week2"
    took = sorted(classmate.started_in for classmate in students)
    print(f"a server starts in {took[0]:.1f} to {took[-1]:.1f} s")


def test_what_a_student_hands_in_is_collected_under_the_hub_s_name(hub, students, tmp_path):
    student = students[0]
    student.open_kernel()
    assert "Handed in: VeraCourse_02_topics.zip" in student.run('print(hand_in("02_topics.ipynb", by="Vera Course"))')
    student.close_kernel()
    roster = Roster([Person("Vera Course", id=student.name)])
    (handed,) = collected(hub.folder / "exchange" / "inbound", tmp_path / "scratch", roster=roster).handed
    assert set(handed.chosen) == {"02_topics.ipynb"}


def take(student, all_are_there):
    """As `work_through`; nobody waits for a student who fails."""
    try:
        return work_through(student, all_are_there)
    except BaseException:
        all_are_there.abort()
        raise


def work_through(student, all_are_there):
    """Run the chapters; then, with a node of one's own and while everybody has one, look at the graph in three ways."""
    began = time.monotonic()
    for name in CHAPTERS:
        student.open_kernel()
        student.run('me = "Vera Course"')  # as in chapter 0
        for source in cells_of(name):
            student.run(source)
        if name != CHAPTERS[-1]:
            student.close_kernel()
    took = time.monotonic() - began
    student.run("reset()")
    student.run(OWN_NODE.format(name=student.name))
    all_are_there.wait(1200)
    student.listen()
    seen = [student.run(line).split() for line in ("!ros2 node list", "%ros2 node list", "%ros2 topic list")]
    all_are_there.wait(1200)
    student.close_kernel()
    return took, seen


def test_they_run_chapters_at_once_and_nobody_sees_another_s_graph(students):
    all_are_there = threading.Barrier(len(students))
    with ThreadPoolExecutor(len(students)) as pool:
        takes = [pool.submit(take, student, all_are_there) for student in students]
    failed = [future.exception() for future in takes if future.exception() is not None]
    for error in sorted(failed, key=lambda one: isinstance(one, threading.BrokenBarrierError)):
        raise error  # who fails, before those who would have waited
    took, seen = zip(*(future.result() for future in takes), strict=True)
    print(f"{len(students)} students, chapters {' '.join(CHAPTERS)}: {min(took):.0f} to {max(took):.0f} s")
    for student, (nodes, same, topics) in zip(students, seen, strict=True):
        assert nodes == same == [f"/{student.name}"]
        assert [topic for topic in topics if "only" in topic] == [f"/only_{student.name}"]
