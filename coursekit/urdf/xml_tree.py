"""XML with line numbers, parsed safely: no entities, no external resources, limited depth."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from .errors import UrdfError

DEEPEST = 200
"""Maximum depth of elements; a robot needs about 10."""
TRUNCATED = {expat.errors.codes[expat.errors.XML_ERROR_NO_ELEMENTS], 5, 15}
_COMMENT, _DECLARATION = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL), re.compile(r"\A\s*<\?xml\b[^>]*\?>")
"""What the parsers of urdfdom and SDF accept and expat does not: `--` in a comment; a declaration late or misspelled.

To them a text ends at its first zero byte.
"""


@dataclass(eq=False)
class Element:
    """One element of a document."""

    tag: str
    attributes: dict[str, str]
    line: int
    file: str = ""
    parent: Element | None = field(default=None, repr=False)
    children: list[Element] = field(default_factory=list, repr=False)
    text: str = ""

    def get(self, name: str) -> str | None:
        """Return an attribute, or None."""
        return self.attributes.get(name)

    def first(self, tag: str) -> Element | None:
        """Return the first child with that tag, or None."""
        return next((child for child in self.children if child.tag == tag), None)

    def all(self, tag: str) -> Iterator[Element]:
        """Return all children with that tag."""
        return (child for child in self.children if child.tag == tag)

    def label(self) -> str:
        """Return a label for messages: `<origin> of <joint name="j">`.

        >>> joint = read('<robot><joint name="elbow"><limit/></joint></robot>').children[0]
        >>> joint.label(), joint.children[0].label()
        ('<joint name="elbow">', '<limit> of <joint name="elbow">')
        """
        own = f'<{self.tag} name="{self.attributes["name"]}">' if "name" in self.attributes else f"<{self.tag}>"
        above = self.parent
        while above is not None and "name" not in above.attributes:
            above = above.parent
        if "name" in self.attributes or above is None or above.parent is None:
            return own
        return f'{own} of <{above.tag} name="{above.attributes["name"]}">'

    def error(
        self, what: str, cure: str = "", chain: tuple[str, ...] = (), kind: type[UrdfError] = UrdfError
    ) -> UrdfError:
        """Return an error at this location, to be raised."""
        return kind(what, file=self.file, line=self.line, element=self.label(), cure=cure, chain=chain)

    def tell(self, path: str) -> str:
        """Return the stripped text of a descendant ('ray/range/min'); '' if it is missing.

        >>> sensor = read("<sensor><ray><range><min> 0.12 </min></range></ray></sensor>")
        >>> sensor.tell("ray/range/min"), sensor.tell("ray/scan")
        ('0.12', '')
        """
        place: Element | None = self
        for tag in path.split("/"):
            place = place.first(tag) if place is not None else None
        return place.text.strip() if place is not None else ""


class _Builder:
    """Builds the tree from expat's calls."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.root: Element | None = None
        self._open: list[Element] = []
        self._parser = parser = expat.ParserCreate("utf-8")
        parser.buffer_text = True
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._characters
        parser.EntityDeclHandler = self._refuse
        parser.ExternalEntityRefHandler = self._refuse
        parser.UnparsedEntityDeclHandler = self._refuse

    def build(self, text: str) -> Element:
        try:
            self._parser.Parse(text.encode("utf-8"), True)
        except expat.ExpatError as error:
            raise self._fault(error) from None
        except (UnicodeError, ValueError, LookupError) as error:
            if isinstance(error, UrdfError):
                raise
            raise UrdfError(
                f"XML parser error: {error}", file=self.file, cure="Save the file as UTF-8 text."
            ) from None
        assert self.root is not None
        return self.root

    def _fault(self, error: expat.ExpatError) -> UrdfError:
        open_ = self._open[-1] if self._open else None
        element = open_.label() if open_ is not None else ""
        if error.code in TRUNCATED and open_ is not None:
            cure = f"The text ends inside {element}, which begins in line {open_.line}: the end of the file is missing."
        elif self.root is None:
            cure = "A robot description begins with <robot name=...> and ends with </robot>."
        else:
            cure = f"Look at line {error.lineno}, column {error.offset + 1}: a tag, a quote or an & is not closed there."
        what = f"XML parser error: {expat.ErrorString(error.code)}"
        return UrdfError(what, file=self.file, line=error.lineno, element=element, cure=cure)

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        above = self._open[-1] if self._open else None
        element = Element(tag, attributes, self._parser.CurrentLineNumber, self.file, above)
        if above is None:
            self.root = element
        else:
            above.children.append(element)
        self._open.append(element)
        if len(self._open) > DEEPEST:
            raise element.error(
                f"XML parser error: more than {DEEPEST} elements inside each other", "Close what is open."
            )

    def _end(self, _tag: str) -> None:
        self._open.pop()

    def _characters(self, text: str) -> None:
        if self._open:
            self._open[-1].text += text

    def _refuse(self, *_anything: object) -> int:
        raise UrdfError(
            "XML parser error: entities are not allowed in a robot description",
            file=self.file,
            line=self._parser.CurrentLineNumber,
            element="<!DOCTYPE>",
            cure="Remove the <!ENTITY ...> declarations and write their text where they are used.",
        )


def read(text: str, file: str = "") -> Element:
    """Return the root element of an XML text; raises UrdfError with file and line.

    >>> read("<robot name='r'><link name='a'/></robot>").first("link").label()
    '<link name="a">'
    """
    return _Builder(file).build(_DECLARATION.sub(_blank, _COMMENT.sub(_blank, text.partition("\0")[0]), 1))


def _blank(skipped: re.Match[str]) -> str:
    """Return blanks in place of a text, so that lines and columns stay."""
    return re.sub(r"[^\n]", " ", skipped[0])


__all__ = ["Element", "read"]
