"""Actors of SDF worlds: people who walk along waypoints."""

import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.gazebo.sdf_world import load_sdf
from coursekit.sim import Simulation
from coursekit.urdf import UrdfError

WAY = (
    "<waypoint><time>0</time><pose>2 -2 1 0 0 1.5</pose></waypoint>"
    "<waypoint><time>4</time><pose>2 2 1 0 0 1.5</pose></waypoint>"
)


@pytest.fixture
def world(tmp_path):
    def read(body, newer=False):
        file = tmp_path / "yard.world"
        file.write_text(f"<sdf version='1.6'><world name='yard'>\n{body}</world></sdf>")
        return load_sdf(file, newer).world

    return read


def actor(script="", pose="0 1 1 0 0 0.5"):
    skin = "<skin><filename>walk.dae</filename></skin><animation name='walking'><filename>walk.dae</filename></animation>"
    return f"<actor name='ann'><pose>{pose}</pose>{skin}{script}</actor>"


def script(ways, loop="true", delay="0", auto="true"):
    told = "".join(f"<trajectory id='{n}' type='walking'>{way}</trajectory>" for n, way in enumerate(ways))
    return f"<script><loop>{loop}</loop><delay_start>{delay}</delay_start><auto_start>{auto}</auto_start>{told}</script>"


def walked(world, *times):
    simulation, seen = Simulation(world), []
    for time in times:
        simulation.advance_to(round(time * 1e9))
        seen.append(round(simulation.pose_of("ann").y, 2))
    return seen


@pytest.mark.parametrize("newer", [False, True])
def test_an_actor_walks_and_begins_again(world, newer):
    yard = world(actor(script([WAY])), newer)
    assert (yard.notes, yard.models) == ((), {"ann": Pose2D(2.0, -2.0, 1.5)})
    assert walked(yard, 2.0, 3.99, 6.0) == [0.0, 1.99, 0.0]


def test_delay_and_the_end_without_a_loop(world):
    assert walked(world(actor(script([WAY], loop="false", delay="1"))), 1.0, 3.0, 5.0, 20.0) == [-2.0, 0.0, 2.0, 2.0]


def test_trajectories_follow_one_another(world):
    back = WAY.replace("-2 1", "9 1").replace("2 2 1", "2 -2 1").replace("2 9 1", "2 2 1")
    assert walked(world(actor(script([WAY, back], loop="false"))), 4.0, 8.0) == [2.0, -2.0]


@pytest.mark.parametrize("told", ["", script([]), script([WAY], auto="false")])
def test_without_a_walk_it_stands_at_its_pose(world, told):
    assert walked(world(actor(told)), 0.0, 3.0) == [1.0, 1.0]


@pytest.mark.parametrize(
    ("body", "fault"),
    [
        (actor(script(["<waypoint><time>-1</time><pose>0 0 0 0 0 0</pose></waypoint>"])), r"yard.world:2: .*time of -1"),
        (actor(script(["<waypoint><time>x</time><pose>0 0 0 0 0 0</pose></waypoint>"])), "not 1 finite number"),
        (actor(script([WAY], delay="-2")), "delay_start of -2"),
        ("<actor><pose>0 0 0 0 0 0</pose></actor>", "has no name"),
    ],
)
def test_what_is_wrong_is_told_with_its_line(world, body, fault):
    with pytest.raises(UrdfError, match=fault):
        world(body)
