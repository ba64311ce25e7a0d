"""The state of a running launch: configurations, environment, locals, handlers and events."""

from __future__ import annotations

import asyncio
import os
from collections import deque
from collections.abc import Callable, Iterable, Mapping, MutableMapping
from typing import Any

from .event import Event
from .event_handler import BaseEventHandler
from .substitution import Substitution


class LaunchContext:
    """The state of one launch, which is passed to substitutions and actions.

    >>> context = LaunchContext(argv=['speed:=2'])
    >>> context.launch_configurations['speed'] = '2'
    >>> context.argv
    ['speed:=2']
    """

    def __init__(self, *, argv: Iterable[str] | None = None, noninteractive: bool = False) -> None:
        self.__argv = list(argv) if argv is not None else []
        self.__noninteractive = noninteractive
        self._event_queue = EventQueue()
        self._event_handlers: deque[BaseEventHandler] = deque()
        self.__handlers_by_event: dict[tuple[type, Any], tuple[BaseEventHandler, ...]] = {}
        self._completion_futures: list[asyncio.Future[Any]] = []
        self.__globals: dict[str, Any] = {}
        self.__locals_stack: list[dict[str, Any]] = []
        self.__locals: dict[str, Any] = {}
        self.__configurations_stack: list[dict[str, str]] = []
        self.__configurations: dict[str, str] = {}
        self.__environment_stack: list[dict[str, str]] = []
        self.__environment_at_start = dict(os.environ)
        self._launched_processes: list[Any] = []
        self._process_count = 0
        self._at_end: list[Callable[[], None]] = []
        self.__is_shutdown = False
        self.__asyncio_loop: asyncio.AbstractEventLoop | None = None

    @property
    def argv(self) -> list[str]:
        """The launch arguments of the command line."""
        return self.__argv

    @property
    def noninteractive(self) -> bool:
        """Whether there is no terminal that also sends Ctrl-C to the launched processes."""
        return self.__noninteractive

    def _set_is_shutdown(self, state: bool) -> None:
        self.__is_shutdown = state

    @property
    def is_shutdown(self) -> bool:
        """Whether the launch is shutting down."""
        return self.__is_shutdown

    def _set_asyncio_loop(self, loop: asyncio.AbstractEventLoop | None) -> None:
        self.__asyncio_loop = loop

    @property
    def asyncio_loop(self) -> asyncio.AbstractEventLoop | None:
        """The loop on which the launch runs; None if it is not running."""
        return self.__asyncio_loop

    def add_completion_future(self, future: asyncio.Future[Any]) -> None:
        """Make the launch wait for `future` before it ends; an exception of the future ends the launch."""
        self._completion_futures.append(future)
        self._event_queue.stir()

    # -- locals

    def _push_locals(self) -> None:
        self.__locals_stack.append(dict(self.__locals))

    def _pop_locals(self) -> None:
        if not self.__locals_stack:
            raise RuntimeError("locals stack unexpectedly empty")
        self.__locals = self.__locals_stack.pop()

    def get_locals_as_dict(self) -> dict[str, Any]:
        """Return globals and locals together."""
        return {**self.__globals, **self.__locals}

    @property
    def locals(self) -> _Locals:
        """Globals and locals as attributes, for example `context.locals.event`."""
        return _Locals(self.get_locals_as_dict())

    def extend_globals(self, extensions: Mapping[str, Any]) -> None:
        """Add values that are visible everywhere in this launch."""
        self.__globals.update(extensions)

    def extend_locals(self, extensions: Mapping[str, Any]) -> None:
        """Add values that are visible until the current event has been handled."""
        self.__locals.update(extensions)

    # -- launch configurations

    def _push_launch_configurations(self) -> None:
        self.__configurations_stack.append(dict(self.__configurations))

    def _pop_launch_configurations(self) -> None:
        if not self.__configurations_stack:
            raise RuntimeError("launch configurations stack unexpectedly empty")
        _restore(self.__configurations, self.__configurations_stack.pop())

    def _reset_launch_configurations(self, launch_configurations: Mapping[str, str]) -> None:
        _restore(self.__configurations, dict(launch_configurations))

    @property
    def launch_configurations(self) -> dict[str, str]:
        """The launch configurations that are set, by name."""
        return self.__configurations

    # -- environment

    def _push_environment(self) -> None:
        self.__environment_stack.append(dict(os.environ))

    def _pop_environment(self) -> None:
        if not self.__environment_stack:
            raise RuntimeError("environment stack unexpectedly empty")
        _restore(os.environ, self.__environment_stack.pop())

    def _reset_environment(self) -> None:
        _restore(os.environ, self.__environment_at_start)

    @property
    def environment(self) -> MutableMapping[str, str]:
        """The environment that started processes get."""
        return os.environ

    # -- events

    def would_handle_event(self, event: Event) -> bool:
        """Return whether a handler accepts `event`."""
        return any(handler.matches(event) for handler in self._event_handlers)

    def register_event_handler(self, event_handler: BaseEventHandler, append: bool = False) -> None:
        """Add a handler: before all others, or with `append` after them."""
        if append:
            self._event_handlers.append(event_handler)
        else:
            self._event_handlers.appendleft(event_handler)
        self.__handlers_by_event.clear()

    def unregister_event_handler(self, event_handler: BaseEventHandler) -> None:
        """Remove a handler.

        Raises:
            ValueError: if it is not registered.
        """
        self._event_handlers.remove(event_handler)
        self.__handlers_by_event.clear()

    def _handlers_for(self, event: Event) -> tuple[BaseEventHandler, ...]:
        """The handlers that may accept `event`, in order."""
        return self._handlers_of(type(event), getattr(event, "action", None))

    def _handlers_of(self, kind: type[Event], action: Any) -> tuple[BaseEventHandler, ...]:
        """The handlers that may accept events of this class about this action."""
        handlers = self.__handlers_by_event.get((kind, action))
        if handlers is None:
            mine = [handler for handler in self._event_handlers if issubclass(kind, handler._event_class)]
            handlers = tuple(handler for handler in mine if handler._action in (None, action))
            self.__handlers_by_event[kind, action] = handlers
        return handlers

    def emit_event_sync(self, event: Event) -> None:
        """Queue an event; call it from the launch's own loop."""
        self._event_queue.put_nowait(event)

    async def emit_event(self, event: Event) -> None:
        """Queue an event, from a coroutine."""
        self._event_queue.put_nowait(event)

    def perform_substitution(self, sub: Substitution) -> str:
        """Return the text of a substitution in this context."""
        return sub.perform(self)


class EventQueue:
    """A queue of events, with a future that is done when there is an event."""

    def __init__(self) -> None:
        self.__events: deque[Event] = deque()
        self.__waiting: asyncio.Future[None] | None = None

    def put_nowait(self, event: Event) -> None:
        """Add an event."""
        self.__events.append(event)
        self.stir()

    def stir(self, _done: object = None) -> None:
        """Complete the future that is waited for."""
        if self.__waiting is not None and not self.__waiting.done():
            self.__waiting.set_result(None)

    def get_nowait(self) -> Event:
        """Take the oldest event."""
        return self.__events.popleft()

    def empty(self) -> bool:
        """Return whether there is no event."""
        return not self.__events

    def qsize(self) -> int:
        """Return the number of events."""
        return len(self.__events)

    def stirred(self, loop: asyncio.AbstractEventLoop) -> asyncio.Future[None]:
        """Return a future that is done as soon as there is an event, or `stir` is called."""
        self.__waiting = loop.create_future()
        if self.__events:
            self.__waiting.set_result(None)
        return self.__waiting


class _Locals:
    """A dictionary whose items are attributes."""

    def __init__(self, values: dict[str, Any]) -> None:
        self.__dict__.update(values)
        self.__dict__["_names"] = sorted(values)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(
            f"'LaunchContext.locals' has no attribute '{name}' (known: {', '.join(self.__dict__['_names'])})"
        )

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"can't set attribute '{name}', locals are read-only; use extend_locals")


def _restore(mapping: MutableMapping[str, str], values: Mapping[str, str]) -> None:
    """Make `mapping` equal to `values`, changing only the differences."""
    for key in [key for key in mapping if key not in values]:
        del mapping[key]
    for key, value in values.items():
        if mapping.get(key) != value:
            mapping[key] = value
