"""What a camera sees of a world."""

import math

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.sim import Drift, RobotModel, Simulation, read_world
from coursekit.sim.view import View

RED = "world: w\nboxes: [{name: b, center: [3.0, 0.0], size: [1.0, 1.0], height: 1.0, colour: red, texture: plain}]"


def reds(picture):
    blue, green, red = (picture[:, :, k].astype(int) for k in range(3))
    return np.argwhere((red > 100) & (red > 2 * green) & (red > 2 * blue))


def test_a_box_is_where_the_pinhole_puts_it():
    view = View(above=0.5, fov=math.pi / 2, width=200, height=200)
    rows, columns = reds(view.render(Simulation(read_world(RED)), Pose2D())).T
    half = 100 * 0.5 / 2.5
    assert columns.min() == pytest.approx(99.5 - half, abs=1) and columns.max() == pytest.approx(99.5 + half, abs=1)
    assert rows.min() == pytest.approx(99.5 - half, abs=1) and rows.max() == pytest.approx(99.5 + half, abs=1)


def test_what_is_to_the_left_is_left_and_behind_is_nothing():
    view, simulation = View(above=0.5, width=160, height=120), Simulation(read_world(RED))
    assert reds(view.render(simulation, Pose2D(theta=-0.4)))[:, 1].mean() < 60
    assert len(reds(view.render(simulation, Pose2D(theta=math.pi)))) == 0


def test_the_near_hides_the_far():
    wall = "\nwalls: [{name: w, points: [[1.5,-5],[1.5,5]], height: 3}]"
    assert len(reds(View(above=0.5).render(Simulation(read_world(RED + wall)), Pose2D()))) == 0


def test_pushed_boxes_and_robots_are_seen_where_they_are():
    simulation = Simulation(read_world(RED.replace("height", "mass: 1.0, height")))
    view = View(above=0.5, width=160, height=120)
    before = reds(view.render(simulation, Pose2D()))[:, 1].mean()
    simulation.put("b", Pose2D(3.0, 1.0))
    assert reds(view.render(simulation, Pose2D()))[:, 1].mean() < before - 10
    robot = simulation.spawn(RobotModel("r", drift=Drift()), place=Pose2D(1.5, 0.0))
    with_robot = view.render(simulation, Pose2D())
    without = view.render(simulation, Pose2D(), without=robot)
    assert not np.array_equal(with_robot, without)


def test_the_same_view_is_the_same_picture():
    pictures = [View(width=64, height=48).render(Simulation(read_world(RED)), Pose2D()) for _ in range(2)]
    assert np.array_equal(*pictures) and pictures[0].dtype == np.uint8 and pictures[0].shape == (48, 64, 3)
