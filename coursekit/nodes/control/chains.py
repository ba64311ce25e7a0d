"""Controllers that command others: a chainable one exports references, which another claims like commands of hardware.

The one that commands precedes, the other follows, as the controller manager of ros2_control calls them. While somebody
claims its references, the follower is in chained mode: it takes them instead of what its topic says.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from .loaded_controller import Loaded

if TYPE_CHECKING:
    from rclpy.impl.rcutils_logger import RcutilsLogger

_SEE_ABOVE = (
    "Could not {what} controller with name '{name}'. Check above warnings for more details. Check the state of the "
    "controllers and their required interfaces using `ros2 control list_controllers -v` CLI to get more information."
)


class Chains:
    """Which loaded controllers command which, by the names of their commands."""

    def __init__(self, loaded: Mapping[str, Loaded]) -> None:
        self._loaded = loaded

    def following(self, loaded: Loaded) -> dict[Loaded, list[str]]:
        """Return the controllers that one commands, each with the names of the commands."""
        claims: dict[Loaded, list[str]] = {}
        for name in loaded.controller.command_names() if loaded.is_configured else ():
            owner = self._loaded.get(name.partition("/")[0])
            if owner is not None and owner is not loaded:
                claims.setdefault(owner, []).append(name)
        return claims

    def preceding(self, loaded: Loaded) -> list[Loaded]:
        """Return the controllers that command one."""
        return [other for other in self._loaded.values() if loaded in self.following(other)]

    def in_order(self) -> list[Loaded]:
        """Return all, each before those that it commands, so that a command arrives in the same step."""
        order: list[Loaded] = []

        def put(loaded: Loaded, way: tuple[Loaded, ...]) -> None:
            for before in self.preceding(loaded):
                if before not in (*way, *order):
                    put(before, (*way, loaded))
            if loaded not in order:
                order.append(loaded)

        for loaded in self._loaded.values():
            put(loaded, ())
        return order


class ChainSwitch:
    """What a switch does to chains; `starting` and `stopping` change while it finds out."""

    def __init__(self, chains: Chains, log: RcutilsLogger, starting: list[Loaded], stopping: list[Loaded]) -> None:
        self._chains, self._log = chains, log
        self._starting, self._stopping = starting, stopping
        self.chained: list[Loaded] = []
        """Those that another controller will command."""
        self.unchained = list(dict.fromkeys(follower for loaded in stopping for follower in chains.following(loaded)))
        """Those that no other controller will command."""

    def drop(self, strict: bool) -> bool:
        """Drop what chains forbid, with a log message; False if it is `strict` and there is such a thing."""
        for what, switched, allows in (
            ("activate", self._starting, self._may_start),
            ("deactivate", self._stopping, self._may_stop),
        ):
            for loaded in list(switched):
                if allows(loaded):
                    continue
                self._log.warning(_SEE_ABOVE.format(what=what, name=loaded.name))
                if strict:
                    self._log.error("Aborting, no controller is switched! (::STRICT switch)")
                    return False
                switched.remove(loaded)
        return True

    def restart(self) -> None:
        """Stop and start those whose mode changes while they are active."""
        for loaded in (*self.chained, *self.unchained):
            if loaded.state == "active" and loaded not in self._stopping:
                self._stopping.append(loaded)
                self._starting.append(loaded)

    def _may_start(self, loaded: Loaded, way: tuple[Loaded, ...] = ()) -> bool:
        for follower, commands in self._chains.following(loaded).items():
            if fault := self._fault(follower, commands[0]):
                self._log.warning(fault)
                return False
            if follower not in way and not self._may_start(follower, (*way, loaded)):
                return False
            if follower.controller.chained:
                self.unchained = [other for other in self.unchained if other is not follower]
            elif follower not in self.chained:
                self.chained.append(follower)
        return True

    def _fault(self, follower: Loaded, command: str) -> str:
        if not follower.controller.chainable:
            return (
                f"No reference interface '{command}' exist, since the following controller with name '{follower.name}' "
                "is not chainable."
            )
        if follower.state == "active":
            stops = follower in self._stopping
            return f"The following controller with name '{follower.name}' will be deactivated." if stops else ""
        if follower not in self._starting:
            return f"The following controller with name '{follower.name}' is not active and will not be activated."
        return ""

    def _may_stop(self, loaded: Loaded) -> bool:
        for before in self._chains.preceding(loaded) if loaded.controller.chained else ():
            if before.state == "inactive" and before in self._starting:
                why = "will be activated. "
            elif before.state == "active" and before not in self._stopping:
                why = "is active and will not be deactivated."
            else:
                continue
            self._log.warning(
                f"Could not deactivate controller with name '{loaded.name}' because preceding controller with name "
                f"'{before.name}' {why}"
            )
            return False
        return True


__all__ = ["ChainSwitch", "Chains"]
