"""Interfaces: .msg, .srv and .action text becomes Python classes with Humble's checks, and CDR bytes."""

from coursekit.interfaces.errors import CdrError, InterfaceError, UnknownInterface
from coursekit.interfaces.find import definition_text, find_definition
from coursekit.interfaces.parser import parse, parse_file
from coursekit.interfaces.registry import interface_of, load

__all__ = [
    "CdrError",
    "InterfaceError",
    "UnknownInterface",
    "definition_text",
    "find_definition",
    "interface_of",
    "load",
    "parse",
    "parse_file",
]
