"""Advice about exceptions that ended a student's program."""

from __future__ import annotations

import builtins
import importlib.util
import re
import site
import sys
from pathlib import Path

DIED = "The program ended with that error: mend the line that it names, build, and run it in a cell."
NOT_LOADED = "It did not begin. Run the cells that write its file, its main and its line in setup.py, then build."
"""For an installed program whose module, `main` or line in setup.py is missing."""
NOT_INSTALLED = "Run the cell that adds it to setup.py (in C++ to CMakeLists.txt), then build the package."
"""For an executable that a package does not have."""
NO_RESPONSE = "rclpy ends so where a service's callback gives back no response: is there `return response` in every case?"
NO_RESULT = "Does the callback that judges parameters give back a SetParametersResult in every case?"
STUB = "The stub is still there: write your code where that line stands."
UNPACKED = "Another number of values is taken there than came: what should your function return?"
NO_RESULT_YET = "A future's result() is None until it is done: spin until the future is complete before you read it."
NO_ANSWER = "Each callback of a managed node ends with `return TransitionCallbackReturn.SUCCESS`, or FAILURE."
OTHER_TYPE = "A message's field takes exactly its type, and sys.argv holds texts: int(...) or float(...) makes numbers."
NO_BASE = "Nothing of the node is there yet: begin __init__ with super().__init__(...) and the node's name."
NO_DEPTH = "A publisher and a subscription take the depth of their queue as the last value, for example 10."
NOT_YET = "A future is not yet the response: `await` it in an `async def`, or spin until it is done and take its result()."
NONE_GIVEN = "A message was expected and None came: does the function that makes it end with `return`?"
NO_METHOD = "It stands outside of a class, where no object is handed in: leave `self` out of its first line."
ONLY_A_GOAL = "It stands outside of a class and gets only `goal_handle`: leave `self` out, or what else stands before it."
NO_CALLBACK = (
    "A timer, subscription or service was given a value, such as None: "
    "give it the function itself, without brackets: `self.tick`."
)
NO_CALL = "What stands before those brackets is a value and no function: leave the brackets out."
NO_CALL_OR_HIDDEN = (
    "What stands before some brackets there is a value and no function: "
    "leave empty brackets out, and give no variable the name of a function."
)
NO_CALL_OF_SEVERAL = (
    "A list, tuple or dict is no function: take it without brackets, and an element of it with square ones. "
    "A variable with a function's name, such as `list`, needs another."
)
OWN_NAME = "The first of sys.argv is the program's own name: the arguments begin with sys.argv[1]."
_SPINS = re.compile(r"\bspin(?:_once|_until_future_complete)?\(")
_SPIN = rf"(?: \(line .*{_SPINS.pattern}.*\))?$"
"""The end of what comes out of a callback that was not even entered: the student's own line is the one that spins."""
_CAUSES = (
    (r"TypeError: .*missing 1 required positional argument: 'qos_profile'", NO_DEPTH),
    (r"AttributeError: 'Future' object .*", NOT_YET),
    (r"ValueError: invalid literal for int\(\) with base 10: '[^']*[/\\].*sys\.argv", OWN_NAME),
    (r"AttributeError: '\w+' object has no attribute 'to_label'", NO_ANSWER),
    (r"AttributeError: 'NoneType' object has no attribute .*\.result\(\)", NO_RESULT_YET),
    (r"AssertionError: The '\w+' field must be of type '(?:int|float|str|bool)'", OTHER_TYPE),
    (r"AttributeError: '\w+' object has no attribute '_(?:default_callback_group|parameter_overrides|logger)'", NO_BASE),
    (r"NotImplementedError", STUB),
    (r".*(?:has no attribute 'successful'|Callback returned an invalid type)", NO_RESULT),
    (r"TypeError \(line", NO_RESPONSE),
    (r"TypeError: '[\w.]+' object is not callable" + _SPIN, NO_CALLBACK),
    (r"TypeError: '(?:list|tuple|dict|array\.array)' object is not callable", NO_CALL_OF_SEVERAL),
    (r"TypeError: Expected .*got <class 'NoneType'>", NONE_GIVEN),
    (r"TypeError: cannot unpack non-iterable|ValueError: (?:not enough|too many) values to unpack", UNPACKED),
    (r".*\.load\(\)\)$", NOT_LOADED),
    (r".*executable '[^']*' not found on the libexec directory", NOT_INSTALLED),
)
"""The beginnings of exception messages, and their causes."""
_CALL = re.compile(
    r"TypeError: (?:\w+\.)+(?P<name>\w+)\(\) takes \d+ positional arguments? but (?P<given>[123]) (?:was|were) given"
)
"""A method defined without `self`, or without the message: Python reports it at the call."""
_LESS = re.compile(
    r"TypeError: (?P<of>(?:\w+\.)*)(?P<name>(?!spin)\w+)\(\) missing 1 required positional argument: '(?P<missing>\w+)'"
    + _SPIN
)
"""A callback that asks for more than it gets, such as a timer's that is defined like a subscription's."""
_VALUE = re.compile(r"TypeError: '(?:bool|int|float|str)' object is not callable \(line \d+ of [^:]*: (?P<line>.*)\)$")
"""A value that is called, such as a property."""

_NOT_IN_MODULE = re.compile(
    r"AttributeError: module '(?P<package>\w+)\.(?:\w+\.)*(?P<module>\w+)' has no attribute '(?P<name>\w+)'"
    r"(?!.*\.load\(\)\)$)"
)
"""A class that `main` looks for; a missing `main` itself is NOT_LOADED."""
_UNKNOWN = re.compile(r"NameError: name '(?P<name>\w+)' is not defined")
_OF_THE_NODE = re.compile(r"(?:create|get|declare|set|destroy)_\w+")
_MAKES = re.compile(r"\(line .*create_(?:subscription|timer|service|client|publisher)\(")
_CALLED = re.compile(
    r"TypeError: (?:\w+\.)+(?P<name>\w+)\(\) missing \d required .*"
    r"\(line .*(?:[(,] ?self\.(?P=name)\(\)|self\.(?P=name)\(\),)"
)
"""A callback that is called where it should be given."""


def cause_of(died: str) -> str:
    """Return advice about an exception in the form of `exception_in`.

    >>> cause_of("StopIteration (line 25 of my_exe: return next(matches).load())") == NOT_LOADED
    True
    >>> cause_of("TypeError: Ear.heard() takes 1 positional argument but 2 were given (line 9 of ear.py: rclpy.spin(node))")
    '`heard` gets two values, the object itself and what it is called with: begin it with `def heard(self, msg):`.'
    """
    if call := _CALL.match(died):
        return _about_a_call(call["name"], int(call["given"]))
    if less := _LESS.match(died):
        return _about_too_little(less["name"], less["missing"], in_a_class=bool(less["of"]))
    if unknown := _UNKNOWN.match(died):
        return _about_a_name(unknown["name"], died)
    if called := _CALLED.match(died):
        given = f"self.{called['name']}"
        return f"With brackets it is called there and then. Give the function itself, without brackets: `{given}`."
    if value := _VALUE.match(died):
        return _about_a_value(value["line"])
    if (absent := _NOT_IN_MODULE.match(died)) and not _is_installed(absent["package"]):
        where = absent["module"]
        return f"`{where}` defines no `{absent['name']}`: is it spelt so in its file, and was the package built since?"
    return next((cause for pattern, cause in _CAUSES if re.match(pattern, died)), DIED)


def no_executable(package: str, name: str) -> str:
    """Return advice about an executable that `ros2 run` does not find.

    >>> no_executable("s2_py_pubsub", "ear_exe").partition(". ")[0]
    's2_py_pubsub has no executable ear_exe'
    """
    missing = f"{package} has no executable {name}."
    return f"{missing} {NOT_INSTALLED}"


def _about_a_call(name: str, given: int) -> str:
    """Return advice about a method that is called with `given` values, of which the first is the object itself."""
    if given == 1:
        return f"`{name}` gets one value, the object itself: begin it with `def {name}(self):`."
    if given == 2:
        begin = f"begin it with `def {name}(self, msg):`."
        return f"`{name}` gets two values, the object itself and what it is called with: {begin}"
    begin = f"begin it with `def {name}(self, request, response):`."
    return f"`{name}` gets three values, as a service's callback does, the object itself first: {begin}"


def _about_a_name(name: str, died: str) -> str:
    """Return advice about a name that is not defined, in a line that makes a part of a node; else DIED."""
    if _MAKES.search(died) and name[0].isupper():
        return f"`{name}` is not imported: is there `from ... import {name}` at the top of its file, spelled so?"
    if _OF_THE_NODE.fullmatch(name) or _MAKES.search(died):
        return f"What belongs to the node is written with self before it: `self.{name}`."
    return DIED


def _about_too_little(name: str, missing: str, in_a_class: bool) -> str:
    """Return advice about a callback that gets one value less than it asks for; the last one is the one missing."""
    if in_a_class and missing == "self":
        return f"It is called without an object: in the class, give the callback as `self.{name}`."
    if in_a_class:
        begins = f"a timer's begins with `def {name}(self):`, a subscription's with `def {name}(self, msg):`."
        return f"`{name}` asks for one value more than it gets: {begins}"
    if missing in ("self", "goal_handle"):
        return NO_METHOD if missing == "self" else ONLY_A_GOAL
    begins = f"outside of a class, a timer's begins with `def {name}():`, a subscription's with `def {name}(msg):`."
    return f"`{name}` asks for one value more than it gets: {begins}"


def _about_a_value(line: str) -> str:
    """Return advice about a line that calls a number or a text: a property, or a variable that hides a function."""
    if _SPINS.search(line):
        return NO_CALLBACK
    hidden = any(hasattr(builtins, name) and name != "print" for name in re.findall(r"(?<![\w.])(\w+)\(", line))
    return NO_CALL if re.search(r"\w\(\)", line) and not hidden else NO_CALL_OR_HIDDEN


def _is_installed(package: str) -> bool:
    """Whether a package is Python's, the course's or installed with pip, and so none that a student builds."""
    if package in sys.stdlib_module_names:
        return True
    try:
        found = importlib.util.find_spec(package)
    except ValueError:  # a module that was made by hand
        return False
    if found is None:
        return False
    homes = [*site.getsitepackages(), site.getusersitepackages(), str(Path(__file__).resolve().parents[1])]
    places = [found.origin] if found.origin else list(found.submodule_search_locations or ())
    return any(Path(place).is_relative_to(home) for place in places for home in homes)
