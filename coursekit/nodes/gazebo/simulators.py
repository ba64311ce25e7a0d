"""Which simulators run in a session, for whoever draws them or looks through their cameras."""

from __future__ import annotations

from typing import Any, Protocol

from coursekit.sim.simulation import Simulation


class Simulator(Protocol):
    """A running simulator: `simulation` is the world in motion, `assemblies` the models in it by name."""

    simulation: Simulation
    assemblies: dict[str, Any]
    session: Any

    def advance(self) -> int: ...


_KEY = "running gazebo"


def running(session: Any) -> list[Simulator]:
    """The simulators of a session, in the order of their start."""
    return list(_of(session))


def _of(session: Any) -> list[Simulator]:
    return session.locals.setdefault(_KEY, [])  # type: ignore[no-any-return]



def add(simulator: Simulator) -> None:
    """Enter one that has started."""
    _of(simulator.session).append(simulator)


def remove(simulator: Simulator) -> None:
    """Take one out that has ended; harmless when it is out."""
    if simulator in _of(simulator.session):
        _of(simulator.session).remove(simulator)


__all__ = ["Simulator", "add", "remove", "running"]
