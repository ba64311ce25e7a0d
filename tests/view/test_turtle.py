"""The turtles' window as picture and text."""

import cv2
import numpy as np

from coursekit.sim.turtle import STEP, World
from coursekit.view.turtle import KINDS, describe, picture, png, shape


def drawn():
    world = World()
    turtle = world.spawn()
    turtle.pen.change(255, 0, 0, 5, off=False)
    turtle.command(2.0, 0.0, 0.0, now=0.0)
    for frame in range(50):
        world.step(frame * STEP)
    return world


def test_the_picture_has_background_line_and_turtle():
    image = picture(drawn(), background=(10, 20, 30), size=500)
    assert image.shape == (500, 500, 3)
    assert image[10, 10].tolist() == [30, 20, 10]
    assert image[250, 260].tolist() == [0, 0, 255], "the line is red"
    shell = [int(KINDS[0]["plate"][at : at + 2], 16) for at in (5, 3, 1)]
    assert image[250, 321].tolist() == shell, "the turtle sits at x = 7.14 m"


def test_any_size_can_be_drawn():
    assert picture(drawn(), size=120).shape == (120, 120, 3)


def test_the_file_is_a_png_of_the_picture():
    world = drawn()
    read = cv2.imdecode(np.frombuffer(png(world), np.uint8), cv2.IMREAD_COLOR)
    assert np.array_equal(read, picture(world))


def test_the_text_lists_the_turtles_by_name():
    world = drawn()
    world.spawn("albert", 1.0, 2.0, -1.5)
    assert describe(world, "/sim").splitlines() == [
        "TurtleSim [/sim]",
        "  albert   x 1.00 m  y 2.00 m  heading -85.9°  drove 0.00 m",
        "  turtle1  x 7.14 m  y 5.54 m  heading   0.0°  drove 1.60 m",
    ]


def test_an_empty_window_says_so():
    assert describe(World()).endswith("no turtles")


def test_the_turtle_is_mirror_symmetric_and_fits_into_a_metre():
    points = [point for _, polygon in shape() for point in polygon]
    assert max(abs(value) for point in points for value in point) <= 0.53
    mirrored = {(x, round(-y, 3)) for x, y in ((round(x, 3), round(y, 3)) for x, y in points)}
    assert all((round(x, 3) + 0.0, round(y, 3)) in mirrored for x, y in points if abs(y) > 1e-6 and x > 0.5)
