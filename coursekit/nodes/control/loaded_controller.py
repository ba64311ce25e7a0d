"""A controller that is loaded."""

from __future__ import annotations

from dataclasses import dataclass, field

from .controller import Controller


@dataclass(eq=False)
class Loaded:
    """A loaded controller, and its state."""

    name: str
    type: str
    controller: Controller
    state: str = "unconfigured"
    claimed: list[str] = field(default_factory=list)

    @property
    def is_configured(self) -> bool:
        """Whether it knows which commands it needs."""
        return self.state in ("inactive", "active")


__all__ = ["Loaded"]
