"""Hints for the most common mistakes in C++ and CMakeLists.txt: one sentence each, after the tools' own messages."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

_PROVIDERS = {
    "rosidl_generate_interfaces": "rosidl_default_generators",
    "rosidl_get_typesupport_target": "rosidl_default_generators",
    "rclcpp_components_register_node": "rclcpp_components",
    "rclcpp_components_register_nodes": "rclcpp_components",
    "pluginlib_export_plugin_description_file": "pluginlib",
    "ament_auto_find_build_dependencies": "ament_cmake_auto",
    "add_launch_test": "launch_testing_ament_cmake",
}
_STANDARD = {
    "cout": "iostream", "cerr": "iostream", "endl": "iostream", "string": "string", "vector": "vector", "map": "map",
    "bind": "functional", "function": "functional", "make_shared": "memory", "shared_ptr": "memory", "unique_ptr": "memory",
    "chrono": "chrono", "thread": "thread", "mutex": "mutex", "array": "array", "optional": "optional", "sqrt": "cmath",
    "ofstream": "fstream", "ifstream": "fstream", "stringstream": "sstream", "numeric_limits": "limits",
    "setprecision": "iomanip",
}  # fmt: skip
_Q = "['‘’`\"]"
_BEFORE, _BEHIND = r"(?:[^'’(\n]* )?", r"(?=[<('’\s]|$)"
"""A linker prints a function with its return type before the name, and its parameters after it."""
_BRACES = "count the braces above this place: one is missing, or one too many."
"""For a compiler's first error alone: behind another one, a compiler often misses braces that are there."""
Mending = Callable[[re.Match[str]], str]


def _unknown_command(match: re.Match[str]) -> str:
    name = match["name"].lower()
    provider = _PROVIDERS.get(name) or ("ament_cmake" if name.startswith("ament_") else "")
    if not provider:
        return f"CMake knows no command {name}(): look at its spelling, or for a find_package() that is missing."
    return f"{name}() comes with {provider}: write find_package({provider} REQUIRED) above it, behind project()."


def _missing_header(match: re.Match[str]) -> str:
    header = match["name"]
    package, _, rest = header.partition("/")
    if re.match(r"(msg|srv|action)/", rest):
        snake = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", rest.rpartition("/")[2].partition(".")[0]).lower()
        kind = rest.partition("/")[0]
        return (
            f'headers of interfaces are written small, with _ between words: "{package}/{kind}/{snake}.hpp". If that is how '
            f"you wrote it, look at `ros2 interface list | grep {package}`, and add {package} to find_package() and "
            "ament_target_dependencies()."
        )
    if rest:
        return f"is {package} in package.xml, in find_package() and in ament_target_dependencies() of this target?"
    return f'is "{header}" spelled as the file is, and its folder in target_include_directories() of this target?'


_NAMES = "|".join(_STANDARD)


def _undeclared(names: str) -> str:
    """Return the pattern of g++'s and clang's messages about undeclared names."""
    return rf"{_Q}(?P<name>{names}){_Q} was not declared|undeclared identifier '(?P<other>{names})'"


def _name(match: re.Match[str]) -> str:
    """Return the name in either compiler's message."""
    groups = match.groupdict()
    return next(filter(None, map(groups.get, ("name", "other", "member"))))


_RULES: tuple[tuple[str, str | Mending], ...] = (
    (r"Unknown CMake command \"(?P<name>\w+)\"", _unknown_command),
    (r"passed package name '(?P<name>\w+)' was\s+not\s+found\s+before",
     lambda match: f"write find_package({match['name']} REQUIRED) above ament_target_dependencies()."),
    (r"(configuration file provided by|not providing) \"(Find)?(?P<name>\w+?)(\.cmake)?\"",
     lambda match: f"there is no package {match['name']}: is it spelled as in `ros2 pkg list`, built, and in package.xml?"),
    (r"passed dependency\s+'(?P<name>\w+)'\s+has\s+not\s+been\s+found",
     lambda match: f"write find_package({match['name']} REQUIRED) above rosidl_generate_interfaces()."),
    (r"must\s+be\s+represented\s+as\s+an\s+absolute\s+base\s+path",
     "write the file's path in the package, such as msg/Length.msg; file(GLOB ...) gives such paths with RELATIVE."),
    (r"(?P<name>\w+)\(\)\s+must\s+be\s+called\s+before\s+ament_package",
     lambda match: f"ament_package() is a package's last line: move {match['name']}() above it."),
    (r"Cannot find source file:\s+(?P<name>\S+)",
     lambda match: f"there is no file {match['name']}: is it spelled as it lies in the package's folder?"),
    (r"Parse error\.\s+Function missing ending \"\)\"", "a ) is missing at the end of a command of the CMakeLists.txt."),
    (r"install TARGETS given target \"(?P<name>\w+)\" which does not exist",
     lambda match: f"install(TARGETS ...) names {match['name']}, but no add_executable() or add_library() makes it."),
    (r"fatal error: '?(?P<name>[\w./+-]+?)'?(: No such file| file not found)", _missing_header),
    (rf"error: expected ({_Q},{_Q} or )?{_Q};{_Q}", "a statement ends with ; and the one above this place has none."),
    (_undeclared(_NAMES), lambda match: f"write std::{_name(match)}, with #include <{_STANDARD[_name(match)]}> at the top."),
    (rf"{_Q}(?P<name>{_NAMES}){_Q} is not a member of {_Q}std|no member named '(?P<other>{_NAMES})' in namespace 'std'",
     lambda match: f"add #include <{_STANDARD[_name(match)]}> at the top."),
    (_undeclared("_[1-9]"), "write std::placeholders::_1 in std::bind(), or `using std::placeholders::_1;` at the top."),
    (_undeclared("Node|init|spin|shutdown|ok"), "rclcpp's names are written with rclcpp:: before them."),
    (rf"{_Q}(?P<name>\w+_msgs|example_interfaces){_Q} (has not been|was not) declared",
     lambda match: f"include the message's header, such as \"{match['name']}/msg/...hpp\", small and with _ between words."),
    (r"unable to find numeric literal operator .{0,3}operator\"\"(ms|s|us|ns)|no matching literal operator",
     "write `using namespace std::chrono_literals;` at the top, for times such as 500ms."),
    (rf"shared_ptr<.*has no member named {_Q}(?P<name>\w+){_Q}|no member named '(?P<other>\w+)' in 'std::shared_ptr"
     rf"|request for member {_Q}(?P<member>\w+){_Q} in .* which is of pointer type",
     lambda match: f"the object before it is a pointer: write ->{_name(match)} in place of .{_name(match)}"),
    (rf"{_Q}(class|struct) \S+{_Q} has no member named {_Q}(?P<name>\w+){_Q}|no member named '(?P<other>\w+)' in ",
     lambda match: f"there is no {_name(match)} in it: `ros2 interface show TYPE` lists a message's fields."),
    (r"no matching function for call to .{0,3}(\w+::)*create_subscription|static assertion failed.{0,80}[Cc]allback",
     "a subscription's callback takes the message, as SharedPtr or const &, and std::bind() one placeholder for it."),
    (r"no match for call to .{0,3}\(std::_Bind|no type named .{0,3}type.{0,3} in .{0,3}(struct|class) std::_?(result|Bind)",
     "the function given to std::bind() takes other arguments: one placeholder, std::placeholders::_1, ..., for each."),
    (r"error: .this. was not captured|.this. cannot be implicitly captured",
     "begin the lambda with [this]: what belongs to the node is used in it."),
    (r"no matching (member )?function for call to .{0,3}(\w+::)*create_(wall_)?timer",
     "a timer takes a time with its unit, such as 500ms, and then a function, such as [this] { speak(); }."),
    (r"invalid use of non-static member function", "write std::bind(&Class::function, this, ...): with &Class::, and this."),
    (r"undefined reference to [`‘']?main|undefined symbol: main", "a program needs int main(int argc, char ** argv)."),
    (rf"undefined reference to [`‘']{_BEFORE}(?P<name>[\w:~]+){_BEHIND}"
     rf"|undefined symbol: {_BEFORE}(?P<other>[\w:~]+){_BEHIND}",
     lambda match: f"{_name(match)} is declared and not defined: is its .cpp in add_executable(), its library linked?"),
    (rf"error: expected {_Q}[{{}}()]|expected unqualified-id|expected declaration", _BRACES),
    (r"passing .const \S+ as .this. argument discards qualifiers", "the function called is not const, but its object is."),
)  # fmt: skip


def with_hints(lines: list[bytes]) -> list[bytes]:
    """Return a compiler's lines, followed by hints."""
    said = b"".join(lines).decode(errors="replace")
    return [*lines, *(f"hint: {hint}\n".encode() for hint in hints(said))]


def hints(text: str) -> list[str]:
    """Return hints for the output of CMake or a compiler: at most three sentences, for the first mistakes.

    >>> hints("a.cpp:2:25: error: expected ‘;’ before ‘}’ token")
    ['a.cpp:2: a statement ends with ; and the one above this place has none.']
    >>> hints("all went well")
    []
    """
    mistakes = sorted(_found(text), key=lambda mistake: mistake[0])
    said = dict.fromkeys(f"{_place(text, at)}{sentence}" for at, sentence in mistakes)
    return list(said)[:3]


def _found(text: str) -> Iterator[tuple[int, str]]:
    taken: set[int] = set()
    for pattern, mending in _RULES:
        for match in re.finditer(pattern, text):
            line = text.count("\n", 0, match.start())
            if line not in taken and (mending is not _BRACES or _in_first_error(text, match.start())):  # the first rule wins
                taken.add(line)
                yield match.start(), mending if isinstance(mending, str) else mending(match)


def _in_first_error(text: str, at: int) -> bool:
    return text.rfind("error:", 0, at + len("error:")) == text.find("error:")


def _place(text: str, at: int) -> str:
    """Return file and line of a match, from its own or an earlier line."""
    lines = text[: text.find("\n", at) if "\n" in text[at:] else len(text)].splitlines()
    for line in reversed(lines[-6:]):
        place = re.match(r"(?:CMake Error at )?([^\s:]+):(\d+)", line)
        if place:
            return f"{Path(place[1]).name}:{place[2]}: "
    return ""


__all__ = ["hints"]
