"""Hardware: interfaces that controllers write (`commands`) and read (`states`)."""

from __future__ import annotations

import math

from .description import MOCK_OFFSET, HardwareInfo

UNCONFIGURED, INACTIVE, ACTIVE, FINALIZED = "unconfigured", "inactive", "active", "finalized"
TRANSITIONS = {
    "configure": INACTIVE, "activate": ACTIVE, "deactivate": INACTIVE, "cleanup": UNCONFIGURED, "shutdown": FINALIZED,
}  # fmt: skip
"""The lifecycle's transitions, and the states to which they lead."""
STANDARD = ("position", "velocity", "acceleration", "effort")


class Hardware:
    """A piece of hardware; all interfaces are named by their full names, such as `wheel/velocity`."""

    def __init__(self, info: HardwareInfo) -> None:
        self.info = info
        self.commands: dict[str, float] = dict.fromkeys(info.interfaces("commands"), math.nan)
        self.states: dict[str, float] = {
            name: (interface.initial if not math.isnan(interface.initial) else 0.0)
            for name, interface in info.interfaces("states").items()
        }
        self.state = UNCONFIGURED
        self.now_ns = 0
        """The time of the current step [ns]."""

    @property
    def is_available(self) -> bool:
        """Whether its interfaces can be used: from configuration to cleanup."""
        return self.state in (INACTIVE, ACTIVE)

    def transition(self, name: str) -> None:
        """Carry out one of the TRANSITIONS; `state` tells whether it succeeded. Raises CppFault."""
        self.state = TRANSITIONS[name]

    def prepare_switch(self, start: list[str], stop: list[str]) -> bool:
        """Whether it accepts that these commands are claimed and those are released."""
        return True

    def perform_switch(self, start: list[str], stop: list[str]) -> bool:
        """Change over to other commands; return whether it succeeded."""
        return True

    def read(self, dt: float) -> bool | None:
        """Update the states; False after an error."""

    def write(self, dt: float) -> bool | None:
        """Apply the commands; False after an error."""

    def close(self) -> None:
        """Handle the end of the manager."""

    def released(self, names: list[str]) -> None:
        """Handle commands released by their controller: they are applied once more, and become nan."""
        self.write(0.0)
        for name in names:
            self.commands[name] = math.nan


class GenericSystem(Hardware):
    """mock_components/GenericSystem: commands become states immediately; mimic joints follow."""

    def __init__(self, info: HardwareInfo) -> None:
        super().__init__(info)
        told = info.parameters
        self._offset = float(told.get(MOCK_OFFSET) or 0.0)
        self._custom = told.get("custom_interface_with_following_offset") or "position"
        self._dynamic = told.get("calculate_dynamics", "").lower() in ("true", "1")
        self._deaf = told.get("disable_commands", told.get("fake_sensor_commands_disabled", "")).lower() in ("true", "1")

    def read(self, dt: float) -> None:
        """Copy commands to states; with `calculate_dynamics` velocities change positions."""
        if not self._deaf:
            for name, value in self.commands.items():
                if not math.isnan(value) and name in self.states:
                    self.states[name] = value + (self._offset if name.endswith(f"/{self._custom}") else 0.0)
            if self._dynamic and dt > 0:
                self._reckon(dt)
        self._mimic()

    def _reckon(self, dt: float) -> None:
        for part in self.info.components:
            position, velocity = f"{part.name}/position", f"{part.name}/velocity"
            goal = self.commands.get(velocity, math.nan)
            if math.isnan(self.commands.get(position, math.nan)) and not math.isnan(goal) and position in self.states:
                self.states[position] += goal * dt

    def _mimic(self) -> None:
        for joint, (leader, factor, offset) in self.info.mimics.items():
            for kind in STANDARD:
                if f"{joint}/{kind}" in self.states and f"{leader}/{kind}" in self.states:
                    shift = offset if kind == "position" else 0.0
                    self.states[f"{joint}/{kind}"] = self.states[f"{leader}/{kind}"] * factor + shift


MOCKS = ("mock_components/GenericSystem", "fake_components/GenericSystem")
"""Classes of mock hardware; the second is the older name."""
__all__ = [
    "ACTIVE", "FINALIZED", "INACTIVE", "MOCKS", "STANDARD", "TRANSITIONS", "UNCONFIGURED", "GenericSystem", "Hardware",
]  # fmt: skip
