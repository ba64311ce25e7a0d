"""The world's view without a browser: what it says and shows, its hands on the simulator, and what a page asks of it."""

import itertools
import subprocess
import sys

import pytest

from coursekit.lab.errors import BadArgument
from coursekit.lab.world_windows import world_view
from coursekit.nodes.gazebo.model_conversion import ModelConversion
from coursekit.processes.executables import find
from coursekit.sim import Disc, Thing
from coursekit.view.scene_shapes import Label
from coursekit.view.world_scene import LASER, ROBOTS, THINGS
from tests.urdf.oracle import ROBOTS as FILES

YARD = """
world: yard
boxes:
  - {name: hut, center: [3.0, 0.0], size: [1.0, 1.0], height: 1.0}
  - {name: crate, center: [0.0, 2.0], size: [0.4, 0.4], height: 0.4, mass: 2.0}
"""


@pytest.fixture
def server(session, tmp_path):
    """A simulator."""
    file = tmp_path / "yard.yaml"
    file.write_text(YARD)
    return session.start_executable(find("gazebo_ros", "gzserver"), [str(file)], name="gzserver")


@pytest.fixture
def world(session, server):
    """A view of a yard with a hut, a crate and a robot with a LiDAR."""
    words = ["-entity", "runner", "-file", str(FILES / "robot_lidar.urdf")]
    assert session.start_executable(find("gazebo_ros", "spawn_entity.py"), words, name="spawn").wait(30) == 0
    return world_view()


def sim_ns(world):
    return world.stage.simulator.simulation.now_ns


def test_without_a_simulator_it_says_what_to_type(session):
    view = world_view()
    assert "No simulator runs. Start one: %ros2 launch gazebo_ros gazebo.launch.py" in view.text()
    assert not view.shown()["there"] and view.png()
    for does in (view.pause, view.step, lambda: view.speed(2), lambda: view.add_box(1, 1)):
        with pytest.raises(BadArgument, match="No simulator runs"):
            does()


def test_it_says_what_there_is(world):
    lines = world.text().splitlines()
    assert lines[0].startswith("world 'yard': ") and lines[0].endswith("running")
    assert lines[1:] == [
        "  runner: robot, at (0.00, 0.00), heading 0 deg, 0.00 m/s, 0.00 rad/s",
        "  crate: can be pushed, at (0.00, 2.00)",
        "  1 fixed thing",
    ]


def test_it_draws_things_links_and_beams_and_follows_them(session, world):
    scene = world.stage.update()
    named = {
        display: {name for display_key, name in scene.things if display_key == display}
        for display in (THINGS, ROBOTS, LASER)
    }
    assert named[THINGS] == {"hut", "crate"} and "runner::base_link" in named[ROBOTS] and len(named[LASER]) == 1
    world.move("crate", 1.0, 1.5, 0.5)
    assert world.stage.update().things[THINGS, "crate"].pose[:2] == (1.0, 1.5)
    world.stage.lasers = False
    assert not [key for key in world.stage.update().things if key[0] == LASER]


def test_beams_end_at_what_they_meet(world):
    (beams,) = [thing for (display, _), thing in world.stage.update().things.items() if display == LASER]
    ends = beams.shapes[0].vertices[1:] + beams.pose[:3]
    ahead = ends[(abs(ends[:, 1]) < 0.3) & (ends[:, 0] > 0)]
    assert ahead[:, 0] == pytest.approx(2.5, abs=1e-6), "the face of the hut"


def test_it_is_paused_stepped_and_goes_on_at_its_speed(session, world):
    world.pause()
    session.clock.sleep(1.0)
    begin = sim_ns(world)
    world.step(0.5)
    session.clock.sleep(1.0)
    assert sim_ns(world) - begin == 500_000_000 and "paused" in world.text()
    world.speed(4)
    world.play()
    session.clock.sleep(1.0)
    assert sim_ns(world) - begin == pytest.approx(4_500_000_000, abs=100_000_000)
    world.reset()
    session.clock.sleep(0.1)
    assert sim_ns(world) < 500_000_000


def test_sensors_keep_their_rates_in_simulated_time(session, world):
    import rclpy
    from sensor_msgs.msg import LaserScan

    rclpy.init()
    node, stamps = rclpy.create_node("ear"), []
    node.create_subscription(LaserScan, "/scan", lambda msg: stamps.append(msg.header.stamp), 50)
    world.speed(4)
    until = session.clock.steady() + 2_000_000_000
    while session.clock.steady() < until:
        rclpy.spin_once(node, timeout_sec=0.1)
    times = [stamp.sec + stamp.nanosec * 1e-9 for stamp in stamps]
    steps = [after - before for before, after in itertools.pairwise(times)]
    assert len(steps) > 30 and max(steps) - min(steps) < 0.02, "ten a simulated second, none lost"
    rclpy.shutdown()


@pytest.mark.parametrize("times", [0, -1, 101, "2", float("nan")])
def test_a_speed_that_is_none_is_refused(world, times):
    with pytest.raises(BadArgument, match="above 0"):
        world.speed(times)


def test_boxes_are_models_of_the_world(session, world):
    assert (world.add_box(1.0, 1.0), world.add_box(-2.0, 0.0)) == ("box_1", "box_2")
    assert "box_1: can be pushed, at (1.00, 1.00)" in world.text()
    assert {"box_1", "box_2", "runner"} <= set(world.stage.simulator.around.models())
    world.remove("box_1")
    assert "box_1" not in world.text() and "box_1" not in world.stage.simulator.around.models()
    with pytest.raises(LookupError, match="there is no 'box_1'"):
        world.remove("box_1")


def test_a_box_can_be_moved_at_once_also_in_a_paused_world(world):
    world.pause()
    world.move(world.add_box(1.0, 1.0), 2.0, 1.5)
    assert "box_1: can be pushed, at (2.00, 1.50)" in world.text()


def test_another_thing_under_an_old_name_is_drawn_anew(world):
    simulation = world.stage.simulator.simulation
    before = world.stage.update().things[THINGS, "crate"].shapes[0].vertices
    simulation.remove("crate")
    simulation.add(Thing("crate", (Disc(0.0, 0.0, 0.5, 0.0, 1.0),)))
    after = world.stage.update().things[THINGS, "crate"].shapes[0].vertices
    assert (abs(before).max(), abs(after).max()) == pytest.approx((0.4, 1.0))


def test_what_a_robot_touches_is_written_over_it(session, world):
    world.move("runner", 2.2, 0.0)
    world.stage.simulator.simulation.robots["runner"].command(0.3)
    session.clock.sleep(2.0)
    assert "touches hut" in world.text()
    shapes = [shape for thing in world.stage.update().things.values() for shape in thing.shapes]
    assert [shape.text for shape in shapes if isinstance(shape, Label)] == ["touches hut"]
    world.move("runner", 0.0, 0.0)
    session.clock.sleep(0.2)
    world.stage.update()
    assert "touches" not in world.text()


def test_a_page_picks_and_drags(session, world):
    world.on_pick({"name": "crate"})
    assert world.shown()["told"] == "crate at (0.00, 2.00) m"
    world.on_drag({"x": 0.5, "y": -0.5})
    world.on_drag({"x": 1.0, "y": -1.0})
    assert world.stage.simulator.simulation.pose_of("crate")[:2] == (1.0, 1.0), "from where it was picked"
    assert world.shown()["told"] == "crate at (1.00, 1.00) m"


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        ("drag", {}), ("drag", {"x": "far", "y": 0}), ("drag", {"x": float("nan"), "y": 0}), ("pick", {}),
        ("pick", {"name": "ghost"}), ("remove", {"name": None}), ("press", {}), ("press", {"button": "explode"}),
        ("speed", {"speed": "fast"}), ("speed", {"speed": -1}), ("lasers", {}), ("box", {"x": None, "y": []}),
        ("box", {"x": 1e9, "y": 0}),
    ],
)  # fmt: skip
def test_a_page_that_sends_nonsense_does_no_harm(session, world, kind, message):
    before = world.text()
    world._hear(None, {"type": kind, **message}, [])
    session.clock.sleep(0.0)
    assert world.text().splitlines()[1:] == before.splitlines()[1:]


def test_a_simulator_that_ends_leaves_an_empty_scene(world, server):
    assert world.stage.update().things
    server.interrupt()
    assert server.wait(5) == 0
    assert not world.stage.update().things and "No simulator runs" in world.text()


def test_what_cannot_be_done_is_told_to_who_asked_and_the_world_goes_on(session, world, server, capsys):
    world.stage.simulator.soon(world.stage.simulator.put, ModelConversion("crate", things=[Thing("crate", ())]))
    session.clock.sleep(0.5)
    assert "there is a 'crate' already" in capsys.readouterr().err and server.state == "running"


def test_a_kernel_that_shows_no_world_does_not_load_its_physics():
    """It would take a third of the kernel's start."""
    code = "import sys, coursekit.lab; print([one for one in ('numba', 'pymunk', 'mapbox_earcut') if one in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", check=True)
    assert done.stdout.strip().splitlines()[-1] == "[]"
