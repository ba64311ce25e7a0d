"""Errors in a robot's description: the location, urdfdom's words, and the remedy."""

from __future__ import annotations

from collections.abc import Iterable

from coursekit.suggestions import did_you_mean


class UrdfError(ValueError):
    """An invalid robot description.

    `what` is the fault in urdfdom's words, `file`, `line` and `element` are the location, `cure` is the remedy, and
    `chain` holds the lines that urdfdom adds when the fault ends the reading of a larger element.

    >>> print(UrdfError("joint [j] has no type", file="arm.urdf", line=3, element='<joint name="j">', cure="Add one."))
    arm.urdf:3: <joint name="j">: joint [j] has no type
    Add one.
    """

    def __init__(
        self,
        what: str,
        *,
        file: str = "",
        line: int = 0,
        element: str = "",
        cure: str = "",
        chain: tuple[str, ...] = (),
    ) -> None:
        self.what = what
        self.file = file or "robot description"
        self.line = line
        self.element = element
        self.cure = cure
        self.chain = chain
        super().__init__(self._text())

    def _text(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else self.file
        where = f"{place}: {self.element}: " if self.element else f"{place}: "
        return f"{where}{self.what}\n{self.cure}" if self.cure else where + self.what

    def within(self, outer: str) -> UrdfError:
        """Return the same fault as part of a larger element; `outer` is urdfdom's message about that element."""
        return UrdfError(
            self.what,
            file=self.file,
            line=self.line,
            element=self.element,
            cure=self.cure,
            chain=(*self.chain, outer),
        )


class Negative(UrdfError):
    """A negative mass or size, which urdfdom accepts but which is refused here."""


class MeshError(UrdfError):
    """A mesh file that is missing or cannot be read; the message names the folders that were searched."""


EXPAND = "Expand the file first: xacro robot.urdf.xacro > robot.urdf."


def expanded(text: str, cure: str) -> str:
    """Return the cure, or that of a text which xacro has yet to work out.

    >>> expanded("${width / 2}", "Write a number.")
    'Expand the file first: xacro robot.urdf.xacro > robot.urdf.'
    """
    return EXPAND if "${" in text or "$(" in text else cure


def close(name: str, known: Iterable[str]) -> str:
    """Return a hint with the most similar names, or with all of them.

    >>> close("base_lnk", ["base_link", "wheel"])
    "Did you mean 'base_link'?"
    >>> close("x", ["base_link", "wheel"])
    'There are: base_link, wheel.'
    """
    names = list(known)
    more = " ..." if len(names) > 12 else ""
    return did_you_mean(name, names, f"There are: {', '.join(names[:12]) or 'none'}{more}.", quotes="'")
