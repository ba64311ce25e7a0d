"""Smoothers that are C++ classes."""

from __future__ import annotations

from nav_msgs.msg import Path

from coursekit.nodes.compiled.frames import packed
from coursekit.nodes.nav2.cpp_plugins import CppListeningPlugin


class CppSmoother(CppListeningPlugin):
    """A class derived from nav2_core::Smoother."""

    served, base = "smoother", "nav2_core::Smoother"
    what, created = "smoother", "Created smoother : {name} of type {kind}"

    def smooth(self, path: Path, nanoseconds: int) -> tuple[Path, bool]:
        """Call smooth; return its path, and whether it was done in time."""
        answer = self.ask("smooth", rest=packed(path, nanoseconds))
        done = bool(answer.integer())
        return answer.message(Path), done
