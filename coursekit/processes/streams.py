"""Per-process views of interpreter-wide state: sys.stdout, sys.argv, os.environ, signals, sleep."""

from __future__ import annotations

import signal
import sys
import time
import types
from collections.abc import Callable, Iterator, MutableMapping
from typing import Any

from coursekit.systems.letter_case import variable_name

from .current_session import virtual_session_here
from .process import Process, current_process

_real_sleep = time.sleep
_real_signal = signal.signal
_real_getsignal = signal.getsignal


class StreamProxy:
    """A replacement of sys.stdout: writes go to the calling process, or outside of processes to the replaced stream."""

    def __init__(self, name: str, real: Any) -> None:
        self.__dict__.update(_name=name, _real=real, _replaced=None)

    def _target(self) -> Any:
        process = current_process()
        if process is None or process.exit_code is not None:
            return self._real
        return process.stdin if self._name == "stdin" else ProcessStream(process, self._name)

    @property
    def write(self) -> Callable[[str], int]:
        """The write function; a replacement (IPython's while a cell runs) gets the interpreter's own output."""
        replaced = self._replaced
        return replaced if replaced is not None and current_process() is None else self._write

    @write.setter
    def write(self, value: Callable[[str], int]) -> None:
        self.__dict__["_replaced"] = None if value == self._write else value

    def _write(self, text: str) -> int:
        process = current_process()
        if process is None:
            return self._real.write(text)
        if not isinstance(text, str):
            raise TypeError(f"write() argument must be str, not {type(text).__name__}")
        if process.exit_code is None:
            process.out.write(self._name, text)
        return len(text)

    def flush(self) -> None:
        if current_process() is None:
            self._real.flush()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._target(), name)

    def __setattr__(self, name: str, value: Any) -> None:
        if hasattr(type(self), name):
            object.__setattr__(self, name, value)
        else:
            setattr(self._real, name, value)

    def __iter__(self) -> Iterator[str]:
        return iter(self._target())


class ProcessStream:
    """The text stream of one process."""

    encoding = "utf-8"
    errors = "strict"
    closed = False
    newlines = None
    line_buffering = True

    def __init__(self, process: Process, name: str) -> None:
        self._process = process
        self.name = f"<{name}>"
        self._name = name

    @property
    def buffer(self) -> BytesView:
        return BytesView(self)

    def write(self, text: str) -> int:
        self._process.out.write(self._name, text)
        return len(text)

    def writelines(self, lines: Any) -> None:
        for line in lines:
            self.write(line)

    def flush(self) -> None:
        """Do nothing: there is no buffer."""

    def reconfigure(self, **_options: Any) -> None:
        """Do nothing: buffering options have no effect here."""

    def isatty(self) -> bool:
        return self._process.tty

    def readable(self) -> bool:
        return False

    def writable(self) -> bool:
        return True

    def fileno(self) -> int:
        raise OSError(f"the {self._name} of a process that runs inside the session has no file number")


class BytesView:
    """`sys.stdout.buffer` of a process."""

    def __init__(self, stream: ProcessStream) -> None:
        self._stream = stream

    def write(self, data: bytes) -> int:
        self._stream.write(bytes(data).decode("utf-8", "replace"))
        return len(data)

    def flush(self) -> None:
        """Do nothing: there is no buffer."""


class Environ(MutableMapping[str, str]):
    """os.environ: a process sees its own variables, other code the real ones."""

    def __init__(self, real: Any) -> None:
        self._real = real

    def _own(self) -> Any:
        process = current_process()
        return self._real if process is None else process.env

    def __getitem__(self, key: str) -> str:
        return self._own()[_named(key)]

    def __setitem__(self, key: str, value: str) -> None:
        if not isinstance(value, str):
            raise TypeError(f"str expected, not {type(value).__name__}")
        self._own()[_named(key)] = value

    def __delitem__(self, key: str) -> None:
        del self._own()[_named(key)]

    def __iter__(self) -> Iterator[str]:
        return iter(dict(self._own()))

    def __len__(self) -> int:
        return len(self._own())

    def __repr__(self) -> str:
        return f"environ({dict(self._own())!r})"

    def __or__(self, other: Any) -> dict[str, str]:
        return dict(self) | dict(other)

    def __ror__(self, other: Any) -> dict[str, str]:
        return dict(other) | dict(self)

    def __ior__(self, other: Any) -> Environ:
        """Update in place: `|=` would otherwise replace the environment by a plain dict."""
        self.update(other)
        return self

    def copy(self) -> dict[str, str]:
        return dict(self)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._real, name)


def _named(key: Any) -> Any:
    """Normalize a variable name; non-strings are rejected later by the look-up, as in Python."""
    return variable_name(key) if isinstance(key, str) else key


class _Sys(types.ModuleType):
    """The sys module with an argv for each process."""

    @property
    def argv(self) -> list[str]:
        process = current_process()
        return self.__dict__["_real_argv"] if process is None else process.argv

    @argv.setter
    def argv(self, value: list[str]) -> None:
        process = current_process()
        if process is None:
            self.__dict__["_real_argv"] = value
        else:
            process.argv = value


def sleep(seconds: float) -> None:
    process = current_process()
    session = process.session if process is not None else virtual_session_here()
    if session is None or sys._getframe(1).f_globals.get("__name__") == "subprocess":
        _real_sleep(seconds)  # waiting for a child process takes real time
        return
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    session.clock.sleep(seconds)


def set_handler(signum: int, handler: Any) -> Any:
    process = current_process()
    if process is None:
        return _real_signal(signum, handler)
    previous = process.handlers.get(signum, _default_handler(signum))
    process.handlers[signum] = handler
    return previous


def handler_of(signum: int) -> Any:
    process = current_process()
    if process is None:
        return _real_getsignal(signum)
    return process.handlers.get(signum, _default_handler(signum))


def _default_handler(signum: int) -> Any:
    return signal.default_int_handler if signum == signal.SIGINT else signal.SIG_DFL


def input_of(real: Callable[..., str]) -> Callable[..., str]:
    """Wrap `input` for each process; `real` is used outside of processes."""

    def read_line(prompt: object = "", /) -> str:
        process = current_process()
        if process is None:
            return real(prompt)
        process.out.write("stdout", str(prompt))
        line = process.stdin.readline()
        if not line:
            raise EOFError("EOF when reading a line")
        return line.removesuffix("\n")

    return read_line


def proxy_of(name: str) -> Callable[[Any], StreamProxy]:
    """Return the function that wraps the stream `sys.NAME` in a proxy."""
    return lambda real: StreamProxy(name, real)


def bare(value: Any) -> Any:
    """Unwrap a stream or environment from its per-process view."""
    while isinstance(value, (StreamProxy, Environ)):
        value = value._real
    return value


def own_arguments(_nothing: object = None) -> Callable[[], None]:
    """Give each process its own sys.argv; return the function that undoes it."""
    kind = sys.__class__
    sys.__dict__["_real_argv"] = sys.__dict__.pop("argv")
    sys.__class__ = _Sys

    def undo() -> None:
        sys.__class__ = kind
        sys.__dict__["argv"] = sys.__dict__.pop("_real_argv")

    return undo
