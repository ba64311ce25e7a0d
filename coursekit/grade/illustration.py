"""The picture beside a verdict: a judge provides facts and a drawing function, which is called only if it is displayed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from coursekit.view.figure import Figure

    from .work import Work

LONGEST = 400_000
"""The maximum size of a picture [characters]; a larger one would slow down the notebook."""


class Illustration:
    """The picture last provided by a judge, and the position of its fault.

    It is drawn after the verdict, and cannot affect it: a picture that cannot be drawn is omitted.
    """

    def __init__(self) -> None:
        self._make: Callable[..., Figure] | None = None
        self._facts: tuple[Any, ...] = ()
        self._work: Work | None = None
        self.at: Sequence[Sequence[float]] = ()
        """The positions of faults in the last panel."""

    def keep(self, work: Work, make: Callable[..., Figure], *facts: Any) -> None:
        """Schedule `make(*facts)`, with plain values validated by the judge; lists may still grow until the verdict.

        The work is also kept, because a robot's mesh files exist as long as it does.
        """
        self._make, self._facts, self._work = make, facts, work

    def forget(self) -> None:
        """Draw nothing: there is no work yet."""
        self._make = None

    def html(self) -> str:
        """Return the picture as HTML; empty if none was provided, or it cannot be drawn."""
        try:
            from coursekit.view.figure_html import html

            figure = self.figure()
            picture = html(figure) if figure else ""
        except (Exception, KeyboardInterrupt):
            return ""
        return picture if len(picture) <= LONGEST else ""

    def figure(self) -> Figure | None:
        """Return the figure, with rings at the faults; exceptions of the drawing function propagate."""
        if self._make is None:
            return None
        figure = self._make(*self._facts)
        figure.panels[-1].rings += [(point[0], point[1]) for point in self.at]
        return figure


__all__ = ["Illustration"]
