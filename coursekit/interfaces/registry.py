"""Interface classes, created once per definition and looked up by name."""

from __future__ import annotations

import linecache
import re
import sys
import threading
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType
from typing import Any

from coursekit.interfaces.compound import action_parts, make_action, make_service
from coursekit.interfaces.errors import InterfaceError, UnknownInterface
from coursekit.interfaces.find import find_definition, split_name
from coursekit.interfaces.model import Action, Interface, Message, Service
from coursekit.interfaces.parser import parse_file
from coursekit.interfaces.source import alias, message_source


@dataclass
class _Entry:
    """The classes created from one file, with its path, its stamp and the parsed definition."""

    path: Path
    stamp: tuple[int, int]
    interface: Interface
    classes: dict[str, Any] = field(default_factory=dict)
    parts: dict[str, Any] = field(default_factory=dict)


_entries: dict[str, _Entry] = {}
_lock = threading.RLock()
_SUFFIX = re.compile(
    r"(_SendGoal|_GetResult)?(_Request|_Response)$|_(Goal|Result|Feedback|FeedbackMessage|SendGoal|GetResult)$"
)


def load(name: str) -> Any:
    """Return the class of 'package/msg/Name', 'package/Name', 'package/srv/Name' or 'package/action/Name'.

    A definition file that changed on disk since it was last read is read again.
    Raises UnknownInterface or InterfaceError.

    >>> load('std_msgs/String')(data='hello').data
    'hello'
    """
    package, kind, short = split_name(name)
    stem = short if kind == "msg" else _SUFFIX.sub("", short)
    with _lock:
        entry = _entry(f"{package}/{kind}/{stem}", ())
        if f"{package}/{kind}/{short}" not in entry.classes:
            raise UnknownInterface(name, entry.classes)
        return entry.classes[f"{package}/{kind}/{short}"]


def interface_of(name: str) -> Interface:
    """Return the parsed definition of an interface.

    >>> [f.name for f in interface_of('geometry_msgs/msg/Point').fields]
    ['x', 'y', 'z']
    """
    package, kind, short = split_name(name)
    with _lock:
        return _entry(f"{package}/{kind}/{short}", ()).interface


def _entry(name: str, above: tuple[str, ...]) -> _Entry:
    path = find_definition(name)
    status = path.stat()
    stamp = (status.st_mtime_ns, status.st_size)
    known = _entries.get(name)
    interface = known.interface if known and (known.path, known.stamp) == (path, stamp) else None
    if interface is None:
        interface = parse_file(name.split("/")[0], path)
        known = None
    parts = _dependencies(interface, (*above, name))
    if known is None or any(known.parts[part] is not cls for part, cls in parts.items()):
        known = _entries[name] = _Entry(path, stamp, interface, _make(interface), parts)
    return known


def _dependencies(interface: Interface, above: tuple[str, ...]) -> dict[str, Any]:
    messages = [interface] if isinstance(interface, Message) else list(interface.messages())
    parts = {}
    for message in messages:
        for f in message.fields:
            if not f.type.is_primitive and f.type.base not in parts:
                parts[f.type.base] = _dependency(message, f.type.base, f.line, above)
    return parts


def _dependency(message: Message, base: str, line: int, above: tuple[str, ...]) -> Any:
    try:
        if base in above:
            raise UnknownInterfaceLoop(base)
        return _entry(base, above).classes[base]
    except UnknownInterfaceLoop:
        why = f"'{base}' contains itself"
    except UnknownInterface as error:
        why = f"unknown type: {error}"
    source = linecache.getline(message.file, line).rstrip("\n") if message.file else ""
    raise InterfaceError(why, file=message.file, line=line, source=source)


class UnknownInterfaceLoop(UnknownInterface):
    """A message that would contain itself."""


def _make(interface: Interface) -> dict[str, Any]:
    if isinstance(interface, Message):
        return {interface.full_name: make_message(interface)}
    classes = {m.full_name: make_message(m, interface.name) for m in interface.messages()}
    if isinstance(interface, Service):
        make_service(interface.full_name, classes, _module(interface.package, "srv", interface.name).__name__)
    else:
        _make_action(interface, classes)
    _publish(interface, classes)
    return classes


def _make_action(action: Action, classes: dict[str, Any]) -> None:
    module = _module(action.package, "action", action.name).__name__
    for message in action_parts(action):
        classes[message.full_name] = make_message(message, action.name, classes)
    make_action(action.full_name, classes, module, load)


def _publish(interface: Interface, classes: dict[str, Any]) -> None:
    kind = "srv" if isinstance(interface, Service) else "action"
    vars(_module(interface.package, kind, interface.name)).update(
        {name.rsplit("/", 1)[1]: cls for name, cls in classes.items()}
    )


def make_message(message: Message, owner: str | None = None, parts: dict[str, Any] | None = None) -> Any:
    """Create the class of one message; `owner` is the service or action whose module contains it."""
    module = _module(message.package, message.kind, owner or message.name)
    source = message_source(message, parts or ())
    filename = f"<coursekit {message.full_name}>"
    linecache.cache[filename] = (len(source), None, source.splitlines(True), filename)
    namespace = {"__name__": module.__name__, **{alias(n): c for n, c in (parts or {}).items()}}
    exec(compile(source, filename, "exec"), namespace)
    message_class = namespace[message.name]
    message_class._DEFINITION = message
    message_class._PARTS = {name: namespace[alias(name)] for name in message.dependencies()}
    setattr(module, message.name, message_class)
    setattr(module, f"Metaclass_{message.name}", namespace[f"Metaclass_{message.name}"])
    return message_class


def module_name(package: str, kind: str, name: str) -> str:
    """Return the name of the module that a class claims to come from.

    >>> module_name('std_msgs', 'msg', 'UInt8MultiArray')
    'std_msgs.msg._u_int8_multi_array'
    """
    snake = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    snake = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", snake).lower()
    return f"{package}.{kind}._{snake}"


class _LazyModule(ModuleType):
    """Module of one interface, such as std_msgs.msg._string: creates its classes on demand."""

    _interface = ""

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("__") and self._interface:
            load(self._interface)
            if name in self.__dict__:
                return self.__dict__[name]
        raise AttributeError(f"module '{self.__name__}' has no attribute '{name}'")


def _module(package: str, kind: str, name: str) -> ModuleType:
    full = module_name(package, kind, name)
    module = sys.modules.get(full)
    if module is None:
        module = sys.modules[full] = _LazyModule(full)
        module._interface = f"{package}/{kind}/{name}"
    return module


register_module = _module
