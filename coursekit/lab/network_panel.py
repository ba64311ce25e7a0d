"""The network that this notebook has joined: its members, the traffic in both directions, rates and delays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.cli.session_client import domain_id

from .panel import Panel, static

if TYPE_CHECKING:
    from coursekit.net.report import Report

LOOK_AGAIN_S = 1.0
"""The refresh period: rates must fall to zero when others fall silent, so they are polled."""
HOW_TO_JOIN = "%network ADDRESS"


class NetworkPanel(Panel):
    """See `network_panel`."""

    _esm = static("network.js")
    _css = static("network.css")

    def __init__(self) -> None:
        super().__init__("network_panel")
        self.hidden.graph.watch(self.changed)

    def _report(self) -> Report | None:
        from coursekit.net.joining import link_of
        from coursekit.net.report import report_of

        link = link_of(self.session, domain_id())
        return None if link is None or link.closed else report_of(link)

    # -- what is shown

    def shown(self) -> dict[str, Any]:
        """Return the state and the rows of the tables."""
        self.look_again(LOOK_AGAIN_S)
        report = self._report()
        if report is None:
            return {"joined": False, "how": HOW_TO_JOIN}
        return {
            "joined": True,
            "address": report.address,
            "domain": report.domain_id,
            "up": report.is_up,
            "listenOnly": report.listen_only,
            "others": [{"name": name, "nodes": nodes} for name, nodes in report.others.items()],
            "heard": report.heard,
            "sent": report.sent,
            "notes": report.notes,
        }

    def text(self) -> str:
        """Return the lines of `%network`."""
        from coursekit.net.report import NOT_JOINED

        report = self._report()
        return NOT_JOINED if report is None else "\n".join(report.lines())

    def on_leave(self, _message: dict[str, Any]) -> None:
        """Handle the leave button."""
        from coursekit.net.joining import leave

        leave(self.session, domain_id())
        self.changed()

    def leave(self) -> None:
        """Stop watching the graph."""
        self.hidden.graph.unwatch(self.changed)


def network_panel() -> NetworkPanel:
    """Show the network joined by `%network ADDRESS`, live: its members and its traffic, with a button to leave it.

    In ROS 2: `ros2 node list`, `ros2 topic hz` and `ros2 topic delay`.
    """
    return NetworkPanel()


__all__ = ["NetworkPanel", "network_panel"]
