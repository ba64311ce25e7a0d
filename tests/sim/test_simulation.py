"""Robots in motion: they go where they are told, stop at walls, push boxes, and do the same again."""

import math
from pathlib import Path

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.sim import (
    Drift,
    Drive,
    Lidar,
    Prism,
    RobotModel,
    Simulation,
    Thing,
    World,
    WorldError,
    load_world,
    read_world,
)

WORLDS = Path(__file__).parents[2] / "maps" / "worlds"
ROOM = "world: room\nwalls: [{name: wall, points: [[-2,-2],[2,-2],[2,2],[-2,2]], closed: true}]\n"
CART = RobotModel("cart")


def run(simulation, robot, seconds, forward, turn=0.0, left=0.0):
    robot.command(forward, turn, left)
    simulation.advance(seconds)


def test_a_circle_ends_where_it_began():
    simulation = Simulation(World("plain"))
    robot = simulation.spawn(RobotModel("cart", drive=Drive(acceleration=1e9, turn_acceleration=1e9), grip=1e9))
    run(simulation, robot, 4.0, 0.5 * math.pi / 2, math.pi / 2)
    assert np.hypot(*robot.place[:2]) < 0.01 and abs(math.remainder(robot.place.theta, 2 * math.pi)) < 1e-6


def test_acceleration_speed_and_watchdog_are_limits():
    simulation = Simulation(World("plain"))
    robot = simulation.spawn(RobotModel("cart", drive=Drive(max_speed=0.3, max_turn=1.0, acceleration=1.0, watchdog=0.5)))
    robot.command(9.0, -9.0, now_ns=simulation.now_ns)
    simulation.advance(0.1)
    assert robot.velocity[0] == pytest.approx(0.1, abs=1e-3)
    simulation.advance(0.35)
    assert robot.velocity[0] == pytest.approx(0.3, abs=1e-3) and robot.velocity[2] == pytest.approx(-1.0)
    simulation.advance(0.5)
    assert robot.velocity == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)


def test_a_command_that_is_no_number_is_ignored():
    simulation = Simulation(World("plain"))
    robot = simulation.spawn(CART)
    robot.command(math.nan, math.inf)
    simulation.advance(0.5)
    assert tuple(robot.place) == (0.0, 0.0, 0.0)


def test_only_planar_robots_go_sideways():
    for kind, y in (("planar", 1.0), ("differential", 0.0)):
        simulation = Simulation(World("plain"))
        robot = simulation.spawn(RobotModel("cart", drive=Drive(kind, acceleration=1e9), grip=1e9))
        run(simulation, robot, 2.0, 0.0, 0.0, 0.5)
        assert robot.place.y == pytest.approx(y, abs=0.01)


def test_a_wall_stops_a_robot_and_is_felt():
    simulation = Simulation(read_world(ROOM))
    robot = simulation.spawn(CART)
    run(simulation, robot, 8.0, 0.5)
    assert robot.place.x == pytest.approx(1.95 - 0.15, abs=0.01) and list(robot.contacts) == ["wall"]
    assert robot.odometer.place.x > 3.5, "the wheels have turned all the time"
    run(simulation, robot, 1.0, -0.5)
    assert not robot.contacts


def test_a_light_box_is_pushed_and_a_heavy_one_is_not():
    for mass, moved in ((2.0, True), (60.0, False)):
        boxes = f"boxes: [{{name: b, center: [0.6,0], size: [0.3,0.3], mass: {mass}}}]"
        simulation = Simulation(read_world("world: w\n" + boxes))
        robot = simulation.spawn(CART)
        run(simulation, robot, 4.0, 0.4)
        assert (simulation.pose_of("b").x > 1.2) is moved
        assert simulation.pose_of("b").x - robot.place.x > 0.29, "nothing goes through anything"
        run(simulation, robot, 3.0, -0.2)
        assert simulation.velocity_of("b") == pytest.approx((0, 0, 0), abs=1e-9), "the floor brakes it"


def test_a_door_swings_on_its_hinge_and_no_further():
    simulation = Simulation(read_world("world: w\ndoors: [{name: d, hinge: [1,-0.3], yaw: 1.57, mass: 3, widest: -1.4}]"))
    robot = simulation.spawn(CART)
    run(simulation, robot, 6.0, 0.4)
    door = simulation.pose_of("d")
    assert door[:2] == pytest.approx((1, -0.3), abs=0.02) and 1.57 - 1.5 < door.theta < 1.57 - 0.5


def test_what_hangs_above_a_robot_does_not_stop_it():
    high = Thing("shelf", (Prism(((0.4, -1), (0.6, -1), (0.6, 1), (0.4, 1)), 0.5, 2.0),))
    simulation = Simulation(World("w", (high,)))
    robot = simulation.spawn(CART)
    run(simulation, robot, 3.0, 0.5)
    assert robot.place.x > 1.2 and not robot.contacts
    assert np.isinf(simulation.scan(Lidar(height=0.2), robot)).all()


def test_robots_see_and_bump_each_other_but_not_themselves():
    simulation = Simulation(World("w"))
    one, two = simulation.spawn(CART, "one"), simulation.spawn(CART, "two", Pose2D(1.0, 0.0, math.pi))
    lidar = Lidar(beams=4, angle_max=1.5 * math.pi, height=0.1)
    assert simulation.scan(lidar, one).tolist() == [pytest.approx(0.85), math.inf, math.inf, math.inf]
    one.command(0.3), two.command(0.3)
    simulation.advance(4.0)
    assert list(one.contacts) == ["two"] and list(two.contacts) == ["one"]
    simulation.remove("two")
    assert not one.contacts and np.isinf(simulation.scan(lidar, one)).all()


def test_a_thing_with_its_own_way_moves_and_is_seen_where_it_is():
    block = Prism(((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)))
    belt = Thing("cart", (block,), Pose2D(2, 0), math.inf, velocity=(0.5, 0, 0))
    simulation = Simulation(World("w", (belt,)))
    simulation.advance(1.0)
    assert simulation.scan(Lidar(beams=1, angle_max=0.0))[0] == pytest.approx(2.4)


def test_the_same_commands_give_the_same_run():
    def trace():
        simulation = Simulation(load_world(WORLDS / "robot_world.yaml"), seed=5)
        robot = simulation.spawn(RobotModel("cart", drift=Drift.usual()))
        chance, rows = np.random.default_rng(7), []
        for _ in range(40):
            run(simulation, robot, 0.3, *chance.uniform(-0.8, 0.8, 2))
            rows += [*robot.place, *robot.odometer.place, *simulation.pose_of("crate")]
            rows += [*simulation.scan(Lidar(beams=30), robot)]
        return np.array(rows).tobytes()

    assert trace() == trace()


def test_reset_repeats_the_run():
    simulation = Simulation(read_world(ROOM), seed=3)
    robot = simulation.spawn(RobotModel("cart", drift=Drift.usual()))
    ends = []
    for _ in range(2):
        run(simulation, robot, 3.0, 0.4, 0.5)
        ends.append((*robot.place, *robot.odometer.place))
        simulation.reset()
        assert tuple(robot.place) == (0, 0, 0) and simulation.now_ns == 0
    assert ends[0] == ends[1]


def test_odometry_drifts_as_its_model_says():
    simulation = Simulation(World("plain"))
    biased = simulation.spawn(RobotModel("cart", drift=Drift(bias=0.1)))
    run(simulation, biased, 5.0, 0.4)
    assert biased.odometer.place.x == pytest.approx(biased.place.x * 1.1, rel=0.01)
    ends = []
    for seed in range(2):
        simulation = Simulation(World("plain"), seed)
        robot = simulation.spawn(RobotModel("cart", drift=Drift.usual()))
        run(simulation, robot, 20.0, 0.5, 0.1)
        ends.append(robot.odometer.place)
        gap = robot.place.inverse() @ robot.odometer.place
        assert 0.02 < math.hypot(gap.x, gap.y) < 2.0
    assert ends[0] != ends[1]


def test_a_robot_in_a_wall_is_refused_with_the_wall_s_name():
    simulation = Simulation(read_world(ROOM, "room.yaml"))
    with pytest.raises(WorldError, match=r"room.yaml: robot 'cart': 'wall' is in the way at x 1.90, y 0.00"):
        simulation.spawn(CART, place=Pose2D(1.9, 0.0))
    with pytest.raises(WorldError, match="cannot stand"):
        simulation.spawn(CART, place=Pose2D(math.nan, 0.0))
    simulation.spawn(CART)
    with pytest.raises(WorldError, match="there is a 'cart' already"):
        simulation.spawn(CART, place=Pose2D(1.0, 1.0))


def test_a_robot_in_the_very_place_of_another_is_refused():
    simulation = Simulation(World("plain"))
    simulation.spawn(RobotModel("one"))
    for turn in (0.0, 1.5707963267948966, 3.0):
        with pytest.raises(WorldError, match=r"'one' is in the way.*\n?.*somewhere free, beside it"):
            simulation.spawn(RobotModel("two"), place=Pose2D(0.0, 0.0, turn))


def test_a_name_that_is_not_there_gets_a_hint():
    with pytest.raises(LookupError, match="Did you mean 'wall'"):
        Simulation(read_world(ROOM)).pose_of("wal")
