"""A notebook's cell and the simulator's own thread change a world one after the other, never at once."""

import threading

import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.sim import RobotModel, Simulation, World


@pytest.fixture
def world():
    simulation = Simulation(World("plain"))
    simulation.spawn(RobotModel("cart"))
    return simulation


def another_thread_may_come_in(simulation):
    """Whether another thread could change the world now."""
    told = []

    def look():
        told.append(simulation.busy.acquire(blocking=False))
        if told[0]:
            simulation.busy.release()

    thread = threading.Thread(target=look)
    thread.start()
    thread.join()
    return told[0]


CHANGES = {
    "advance_to": lambda world: world.advance_to(20_000_000),
    "put": lambda world: world.put("cart", Pose2D(1.0, 0.0, 0.0)),
    "reshape": lambda world: world.reshape("cart", world.robots["cart"].model.parts),
    "remove": lambda world: world.remove("cart"),
    "spawn": lambda world: world.spawn(RobotModel("other"), place=Pose2D(2.0, 0.0, 0.0)),
    "reset": lambda world: world.reset(),
}


@pytest.mark.parametrize("change", CHANGES)
def test_while_one_thread_changes_the_world_no_other_can(world, monkeypatch, change):
    seen = []

    def watched(method):
        def call(*args, **named):
            seen.append(another_thread_may_come_in(world))
            return method(*args, **named)

        return call

    for name in ("step", "add", "remove", "reindex_shapes_for_body"):
        monkeypatch.setattr(world.space, name, watched(getattr(world.space, name)))
    CHANGES[change](world)
    assert seen and not any(seen)
    assert another_thread_may_come_in(world)


def test_many_threads_bring_it_to_the_same_time_as_one(world):
    """Two of them in the physics at once made C go round in a circle for ever."""
    world.robots["cart"].command(0.2)
    threads = [threading.Thread(target=world.advance_to, args=(1_000_000_000,)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(30)
    assert not any(thread.is_alive() for thread in threads) and world.now_ns == 1_000_000_000
    alone = Simulation(World("plain"))
    cart = alone.spawn(RobotModel("cart"))
    cart.command(0.2)
    alone.advance_to(1_000_000_000)
    assert cart.place == world.robots["cart"].place
