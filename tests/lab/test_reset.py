"""What reset() says that it has ended: what the user has started, not the processes below it."""

from coursekit.lab.kernel import _started
from coursekit.wiring import COMMANDS, load


def test_ros2_run_and_the_program_that_it_runs_count_as_one(session):
    ros2 = load(COMMANDS["ros2"])
    for name in ("talker", "listener"):
        argv = ["run", "demo_nodes_py", name]
        session.start(lambda argv=argv: ros2(argv), name="ros2", argv=argv)
    session.clock.sleep(1.0)
    assert len(session.processes) == 4 and _started(session) == 2


def test_other_programs_count_each(session):
    session.start(lambda: session.clock.sleep(100.0), name="ros2", argv=["run", "a", "b"])
    session.start(lambda: session.clock.sleep(100.0), name="mine")
    session.clock.sleep(1.0)
    assert _started(session) == 2
