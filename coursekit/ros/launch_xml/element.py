"""XML elements with their line numbers."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any
from xml.parsers import expat


@dataclass
class Element:
    """One XML element: tag, attributes, children, text, and position (file:line)."""

    tag: str
    attrib: dict[str, str]
    place: str
    children: list[Element] = field(default_factory=list)
    text: str = ""


def read_elements(text: str, name: str) -> Element:
    """Return the root element of an XML text; `name` is the file name for messages.

    >>> read_elements('<launch><log message="hi"/></launch>', 'a.xml').children[0].attrib
    {'message': 'hi'}

    Raises:
        expat.ExpatError: if the text is not XML.
    """
    parser = expat.ParserCreate()
    roots: list[Element] = []
    open_elements: list[Element] = []

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(tag, attributes, f"{name}:{parser.CurrentLineNumber}")
        (open_elements[-1].children if open_elements else roots).append(element)
        open_elements.append(element)

    def end(tag: str) -> None:
        open_elements.pop()

    def data(piece: str) -> None:
        open_elements[-1].text += piece

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler = data
    parser.Parse(text, True)
    return roots[0]


def as_element(element: Any) -> Element:
    """Convert an element of ElementTree to an Element; an Element is returned unchanged.

    >>> from xml.etree import ElementTree
    >>> as_element(ElementTree.fromstring('<launch><log message="hi"/></launch>')).children[0].tag
    'log'
    """
    if isinstance(element, Element):
        return element
    children = [as_element(child) for child in element]
    return Element(element.tag, dict(element.attrib), "", children, element.text or "")
