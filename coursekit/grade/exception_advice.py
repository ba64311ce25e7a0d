"""Advice about exceptions that ended a student's program."""

from __future__ import annotations

import re

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
NO_METHOD = "It is called with one value, and stands outside of a class: leave `self` out of its first line."
NO_CALLBACK = "A timer, subscription or service was given None: give it the function itself, without brackets: `self.tick`."
NO_CALL = "What stands before those brackets is a value and no function: leave the brackets out."
OWN_NAME = "The first of sys.argv is the program's own name: the arguments begin with sys.argv[1]."
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
    (r"TypeError: \w+\(\) missing 1 required positional argument: '\w+'(?: \(line .*\bspin\(.*\))?$", NO_METHOD),
    (r"TypeError: 'NoneType' object is not callable(?: \(line .*\bspin\(.*\))?$", NO_CALLBACK),
    (r"TypeError: '(?:bool|int|float|str|list|tuple|dict|NoneType)' object is not callable", NO_CALL),
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
_TICK = re.compile(
    r"TypeError: (?:\w+\.)+(?P<name>\w+)\(\) missing 1 required positional argument: '\w+'(?: \(line .*\bspin\(.*\))?$"
)
"""A timer's callback that is defined like a subscription's."""

_NOT_IN_MODULE = re.compile(
    r"AttributeError: module '[\w.]+\.(?P<module>\w+)' has no attribute '(?P<name>\w+)'(?!.*\.load\(\)\)$)"
)
"""A class that `main` looks for; a missing `main` itself is NOT_LOADED."""
_UNKNOWN = re.compile(r"NameError: name '(?P<name>\w+)' is not defined")
_OF_THE_NODE = re.compile(r"(?:create|get|declare|set|destroy)_\w+")
_MAKES = re.compile(r"\(line .*create_(?:subscription|timer|service|client|publisher)\(")
_CALLED = re.compile(r"TypeError: (?:\w+\.)+(?P<name>\w+)\(\) missing \d required .*\(line .*self\.(?P=name)\(\)")
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
    if tick := _TICK.match(died):
        return f"A timer calls `{tick['name']}` with nothing: begin it with `def {tick['name']}(self):`."
    if unknown := _UNKNOWN.match(died):
        return _about_a_name(unknown["name"], died)
    if called := _CALLED.match(died):
        given = f"self.{called['name']}"
        return f"With brackets it is called there and then. Give the function itself, without brackets: `{given}`."
    if absent := _NOT_IN_MODULE.match(died):
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
