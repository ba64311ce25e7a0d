"""turtle_teleop_key, draw_square, mimic, rotate_absolute and the launch file."""

import math
import re

import pytest

from coursekit.nodes.turtlesim.simulators import simulators

ROTATE = ("action", "send_goal", "/turtle1/rotate_absolute", "turtlesim/action/RotateAbsolute")


@pytest.fixture
def world(run, session):
    run("turtlesim", "turtlesim_node")
    session.clock.sleep(0.2)
    return simulators.running(session)[0].world


@pytest.fixture
def turtle(world):
    return world.turtles["turtle1"]


def test_a_rotation_goal_turns_the_turtle_and_returns_the_way_back(turtle, ros2):
    output = ros2(*ROTATE, "{theta: 1.57}", "--feedback")
    assert turtle.theta == pytest.approx(1.57, abs=0.03)
    assert "remaining: 1.57" in output
    assert re.search(r"delta: -1\.5[45]", output) and "Goal finished with status: SUCCEEDED" in output


def test_a_velocity_aborts_a_rotation(turtle, ros2, session, run):
    key = run("turtlesim", "turtle_teleop_key")
    session.clock.call_at(session.clock.steady() + 500_000_000, lambda: key.write_stdin("\x1b[A"))
    output = ros2(*ROTATE, "{theta: 3.0}")
    assert "Goal finished with status: ABORTED" in output


def test_a_second_goal_aborts_the_first(session, run, world, turtle):
    key = run("turtlesim", "turtle_teleop_key")
    key.write_stdin("d")
    session.clock.sleep(0.5)
    key.write_stdin("g")
    session.clock.sleep(2.0)
    assert turtle.theta == pytest.approx(0.0, abs=0.03)
    (sim,) = [process for process in session.processes if process.name == "turtlesim_node"]
    assert "Rotation goal received before a previous goal finished. Aborting previous goal" in sim.output
    assert "Rotation goal completed successfully" in sim.output


@pytest.mark.parametrize(
    ("typed", "moved"),
    [("\x1b[A", (2.0, 0.0)), ("\x1b[B", (-2.0, 0.0)), ("\x1bOC", (0.0, -2.0)), ("\x1b[D", (0.0, 2.0))],
)
def test_an_arrow_key_drives_as_the_real_one_does(run, session, turtle, typed, moved):
    key = run("turtlesim", "turtle_teleop_key")
    key.write_stdin(typed)
    session.clock.sleep(0.2)
    assert (turtle.forward, turtle.turning) == moved
    session.clock.sleep(2.0)
    assert turtle.speed == 0.0


def test_the_scales_are_parameters(run, session, turtle):
    run("turtlesim", "turtle_teleop_key", "--ros-args", "-p", "scale_linear:=0.5").write_stdin("\x1b[A")
    session.clock.sleep(0.2)
    assert turtle.forward == 0.5


def test_f_cancels_a_rotation(run, session, turtle):
    key = run("turtlesim", "turtle_teleop_key")
    key.write_stdin("d")
    session.clock.sleep(0.5)
    key.write_stdin("f")
    session.clock.sleep(0.1)
    theta = turtle.theta
    session.clock.sleep(1.0)
    assert turtle.theta == theta and 0.3 < abs(theta) < 0.7


@pytest.mark.parametrize("end", ["q", "Q"])
def test_q_quits(run, session, world, end):
    key = run("turtlesim", "turtle_teleop_key")
    session.clock.sleep(0.1)
    key.write_stdin(end)
    assert key.wait(2.0) == 0
    assert "G|B|V|C|D|E|R|T" in key.output


def test_ctrl_c_and_the_end_of_the_input_end_the_keyboard_too(run, session, world):
    keys = [run("turtlesim", "turtle_teleop_key") for _ in range(2)]
    session.clock.sleep(0.1)
    keys[0].interrupt()
    keys[1].close_stdin()
    assert [key.wait(2.0) for key in keys] == [0, 0]


def test_draw_square_comes_round(run, session, world):
    square = run("turtlesim", "draw_square")
    corners = []
    for _ in range(250):
        session.clock.sleep(0.1)
        turtle = world.turtles["turtle1"]
        corners.append((turtle.x, turtle.y))
    assert "New goal [7.544445 5.544445, 0.000000]" in square.output
    assert square.output.count("Reached goal") >= 6
    assert max(x for x, _ in corners) - min(x for x, _ in corners) == pytest.approx(1.95, abs=0.1)
    assert max(y for _, y in corners) - min(y for _, y in corners) == pytest.approx(1.95, abs=0.1)


def test_mimic_follows_in_another_window(run, session):
    for name in ("turtlesim1", "turtlesim2"):
        run("turtlesim", "turtlesim_node", "--ros-args", "-r", f"__ns:=/{name}")
    run(
        "turtlesim",
        "mimic",
        "--ros-args",
        "-r",
        "input/pose:=/turtlesim1/turtle1/pose",
        "-r",
        "output/cmd_vel:=/turtlesim2/turtle1/cmd_vel",
    )
    session.clock.sleep(0.2)
    key = run("turtlesim", "turtle_teleop_key", "--ros-args", "-r", "__ns:=/turtlesim1")
    key.write_stdin("\x1b[D")
    session.clock.sleep(2.0)
    first, second = (simulator.world.turtles["turtle1"] for simulator in simulators.running(session))
    assert first.theta == pytest.approx(2.0, abs=0.1)
    assert math.isclose(second.theta, first.theta, abs_tol=0.1)


def test_multisim_starts_two(session, ros2):
    from coursekit.cli.parser import run as run_cli

    argv = ["launch", "turtlesim", "multisim.launch.py"]
    process = session.start(lambda: run_cli(argv), name="ros2", argv=argv)
    session.clock.sleep(2.0)
    assert ros2("node", "list").split() == ["/turtlesim1/turtlesim", "/turtlesim2/turtlesim"]
    process.interrupt()
    process.wait(10)
