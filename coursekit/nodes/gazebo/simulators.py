"""Which simulators run in a session, for whoever draws them or looks through their cameras."""

from __future__ import annotations

from typing import Any, Protocol

from coursekit.processes.live_things import LiveThings
from coursekit.sim.simulation import Simulation


class Simulator(Protocol):
    """A running simulator: `simulation` is the world in motion, `assemblies` the models in it by name."""

    simulation: Simulation
    assemblies: dict[str, Any]
    session: Any

    def advance(self) -> int: ...


simulators = LiveThings[Simulator]("gazebo")
