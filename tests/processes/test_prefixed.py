"""`nice`, `gdb` and the like before an executable of a package."""

import sys

import pytest

from coursekit.processes.executables import find
from coursekit.processes.prefixed import prefixed
from coursekit.processes.session import Session

TALKER = str(find("demo_nodes_py", "talker"))


@pytest.mark.parametrize(
    "prefix", [["nice", "-n", "3"], ["/usr/bin/taskset", "-c", "1"], ["ionice", "-c", "3"], ["stdbuf", "-oL"]]
)
def test_what_cannot_reach_a_node_inside_the_session_is_left_out(prefix):
    assert prefixed([*prefix, TALKER, "--ros-args"]) == [TALKER, "--ros-args"]


def test_other_prefixes_start_the_interpreter_for_a_file_that_names_none():
    assert prefixed(["gdb", "--args", TALKER, "a"]) == ["gdb", "--args", sys.executable, TALKER, "a"]
    assert prefixed([sys.executable, "-m", "pdb", TALKER]) == [sys.executable, "-m", "pdb", TALKER]


@pytest.mark.parametrize("command", [["nice", "-n", "3", "ls"], ["ls"], [TALKER, "--ros-args"], []])
def test_other_commands_stay_as_they_are(command):
    assert prefixed(command) == command


@pytest.mark.parametrize("line", ["ros2 run --prefix 'nice -n 5' demo_nodes_py talker"])
def test_a_node_with_a_prefix_shares_the_graph_on_the_virtual_clock(line):
    import shlex

    from coursekit.cli.parser import run

    with Session(virtual=True).use() as session:
        talker = session.start(lambda: run(shlex.split(line)[1:]), name="ros2")
        listener = session.start_executable(find("demo_nodes_py", "listener"))
        session.clock.sleep(1.5)
        for process in (talker, listener):
            process.interrupt()
            process.wait(5)
    assert "I heard: [Hello World: 0]" in listener.output
