"""The turtles' world in numbers."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.sim.turtle import SIDE, STEP, Teleport, World, normalize_angle


def run(world, seconds, start=0.0):
    hits = []
    for frame in range(round(seconds / STEP)):
        hits += world.step(start + frame * STEP)
    return hits


@given(st.floats(-1000, 1000))
def test_a_normalized_angle_is_the_same_direction_within_half_a_turn(angle):
    normal = normalize_angle(angle)
    assert -math.pi - 1e-9 <= normal <= math.pi + 1e-9
    assert math.isclose(math.cos(normal), math.cos(angle), abs_tol=1e-6)
    assert math.isclose(math.sin(normal), math.sin(angle), abs_tol=1e-6)


def test_a_command_moves_the_turtle_forward_and_is_forgotten_after_a_second():
    world = World()
    turtle = world.spawn()
    turtle.command(2.0, 0.0, 0.0, now=0.0)
    run(world, 3.0)
    assert turtle.x == pytest.approx(SIDE / 2 + 2.0, abs=2 * 2.0 * STEP)
    assert turtle.y == pytest.approx(SIDE / 2)
    assert turtle.speed == 0.0


def test_forward_and_turning_draw_a_circle():
    world = World()
    turtle = world.spawn()
    for start in range(10):
        turtle.command(1.0, 0.0, 1.0, now=float(start))
        run(world, 1.0, float(start))
        assert math.dist((turtle.x, turtle.y), (SIDE / 2, SIDE / 2 + 1.0)) == pytest.approx(1.0, abs=0.02)


def test_a_holonomic_turtle_moves_sideways_without_turning():
    world = World()
    turtle = world.spawn(theta=math.pi / 2)
    turtle.command(0.0, 1.0, 0.0, now=0.0)
    run(world, 0.8)
    assert turtle.x == pytest.approx(SIDE / 2 - 0.8) and turtle.theta == pytest.approx(math.pi / 2)


def test_a_wall_holds_the_turtle_and_says_where_it_would_have_been():
    world = World()
    turtle = world.spawn(x=SIDE - 0.01)
    turtle.command(1.0, 0.0, 0.0, now=0.0)
    hits = run(world, STEP)
    assert hits == [(turtle, (pytest.approx(SIDE - 0.01 + STEP), SIDE / 2))]
    assert turtle.x == SIDE


@given(st.lists(st.tuples(st.floats(-5, 5), st.floats(-5, 5)), max_size=8))
def test_no_drive_leaves_the_paper(commands):
    world = World()
    turtle = world.spawn()
    for number, (forward, turning) in enumerate(commands):
        turtle.command(forward, 0.0, turning, now=number * 0.5)
        run(world, 0.5, number * 0.5)
        assert 0.0 <= turtle.x <= SIDE and 0.0 <= turtle.y <= SIDE


def test_a_rotation_turns_the_short_way_and_ends_near_its_goal():
    world = World()
    turtle = world.spawn(theta=3.0)
    rotation = turtle.rotate_to(-3.0)
    run(world, 1.0)
    assert rotation.reached and turtle.rotation is None
    assert abs(normalize_angle(turtle.theta + 3.0)) < 0.03
    assert rotation.delta == pytest.approx(-0.28, abs=0.03)


def test_a_rotation_to_where_it_looks_already_is_reached_at_once():
    world = World()
    rotation = world.spawn().rotate_to(0.01)
    world.step(0.0)
    assert rotation.reached


def test_teleports_wait_for_the_next_frame_and_draw():
    world = World()
    turtle = world.spawn()
    turtle.teleports += [Teleport(x=1.0, y=1.0), Teleport(linear=2.0, theta=math.pi / 2, relative=True)]
    assert turtle.x == SIDE / 2
    world.step(0.0)
    assert (turtle.x, turtle.y, turtle.theta) == pytest.approx((1.0, 3.0, math.pi / 2))
    assert [stroke.points[-1] for stroke in world.paper.strokes] == [pytest.approx((1.0, 3.0))]
    assert turtle.travelled == 0.0


def test_a_lifted_pen_draws_nothing():
    world = World()
    turtle = world.spawn()
    turtle.pen.change(1, 2, 3, 4, off=True)
    turtle.command(1.0, 0.0, 0.0, now=0.0)
    run(world, 0.5)
    assert world.paper.strokes == []


def test_a_pen_of_width_zero_draws_one_pixel():
    world = World()
    pen = world.spawn().pen
    pen.change(255, 0, 0, 0, off=False)
    assert (pen.r, pen.width, pen.on) == (255, 1, True)


def test_names_count_on_and_skip_those_in_use():
    world = World()
    world.spawn("turtle2")
    assert [world.spawn().name for _ in range(2)] == ["turtle1", "turtle3"]
    with pytest.raises(KeyError):
        world.spawn("turtle2")


def test_reset_counts_from_one_again_on_clean_paper():
    world = World()
    turtle = world.spawn()
    turtle.command(1.0, 0.0, 0.0, now=0.0)
    run(world, 0.5)
    edition = world.paper.edition
    world.reset()
    assert world.paper.strokes == [] and world.paper.edition > edition
    assert world.spawn().name == "turtle1"
