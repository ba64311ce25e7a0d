"""The picture beside a verdict: a judge hands out facts and who draws them; drawn is it only where somebody looks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from coursekit.view.figure import Figure

    from .work import Work

LONGEST = 400_000
"""Letters of a picture; a longer one would make the notebook slow."""


class Illustration:
    """The thing that a judge handed out last, and the place of the fault in it.

    It is drawn when the verdict is given, so it takes nothing of it: what cannot be drawn is left out.
    """

    def __init__(self) -> None:
        self._make: Callable[..., Figure] | None = None
        self._facts: tuple[Any, ...] = ()
        self._work: Work | None = None
        self.at: Sequence[Sequence[float]] = ()
        """Where in the last panel something is wrong."""

    def keep(self, work: Work, make: Callable[..., Figure], *facts: Any) -> None:
        """Have `make(*facts)` drawn: plain values that the judge has checked; lists may still grow until the verdict.

        The work is kept with them: a robot's meshes are files that last as long as it.
        """
        self._make, self._facts, self._work = make, facts, work

    def forget(self) -> None:
        """Draw nothing: there is no work yet."""
        self._make = None

    def html(self) -> str:
        """The picture as HTML; empty where nothing was handed out, and where it cannot be drawn."""
        try:
            from coursekit.view.figure_html import html

            figure = self.figure()
            made = html(figure) if figure else ""
        except (Exception, KeyboardInterrupt):
            return ""
        return made if len(made) <= LONGEST else ""

    def figure(self) -> Figure | None:
        """The picture of it, with rings where the fault is; it raises whatever drawing raises."""
        if self._make is None:
            return None
        figure = self._make(*self._facts)
        figure.panels[-1].rings += [(one[0], one[1]) for one in self.at]
        return figure


__all__ = ["Illustration"]
