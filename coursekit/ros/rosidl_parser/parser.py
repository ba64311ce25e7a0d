"""Reads IDL, as far as ROS uses it: one interface in a text or a file. In ROS 2: rosidl_parser.parser."""

from __future__ import annotations

from coursekit.files import read_text
from coursekit.interfaces.idl_content import IdlContent, IdlFile, IdlLocator, content_of
from coursekit.interfaces.idl_reader import interface_of_idl


def parse_idl_string(idl_string: str, png_file: str | None = None) -> IdlContent:
    """Return what a text in IDL says; InterfaceError for anything else. No picture of it is drawn.

    >>> from rosidl_parser.definition import Message
    >>> text = "module arm { module msg { struct Reach { double far; }; }; };"
    >>> [message.structure.members[0].name for message in parse_idl_string(text).get_elements_of_type(Message)]
    ['far']
    """
    return content_of(interface_of_idl(idl_string))


def parse_idl_file(locator: IdlLocator, png_file: str | None = None) -> IdlFile:
    """Return a file and what it says; OSError or InterfaceError when it cannot be read."""
    return IdlFile(locator, parse_idl_string(read_text(locator.get_absolute_path()), png_file))
