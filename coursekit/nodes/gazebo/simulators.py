"""The running simulators of a session, for views and cameras."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol

from coursekit.processes.live_things import LiveThings
from coursekit.sim.simulation import Simulation

from .sim_time import SimTime

if TYPE_CHECKING:
    from coursekit.nodes.gazebo.model_conversion import ModelConversion


class Simulator(Protocol):
    """A running simulator: `simulation` is the world in motion, `assemblies` the models in it by name.

    Changes are made in its own thread; `soon` schedules them from any other.
    """

    simulation: Simulation
    assemblies: dict[str, Any]
    time: SimTime
    session: Any

    def advance(self) -> int: ...

    def soon(self, work: Callable[..., Any], *values: Any) -> None: ...

    def pause(self, pause: bool) -> None: ...

    def step(self, seconds: float) -> None: ...

    def restart(self, time: bool) -> None: ...

    def put(self, model: ModelConversion) -> None: ...

    def delete(self, name: str) -> None: ...


simulators = LiveThings[Simulator]("gazebo")
