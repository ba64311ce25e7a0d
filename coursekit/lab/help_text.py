"""The help of a kernel (Shift-Tab, `name?`): types of parameters stand there as they are written, without quotes."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

from IPython.core.interactiveshell import InteractiveShell

from coursekit.processes.patching import KERNEL, Patch


class _Plain(str):
    """A type that a module keeps as text; text would be shown in quotes."""

    def __repr__(self) -> str:
        return str(self)


def unquoted(signature: inspect.Signature) -> inspect.Signature:
    """Return a signature that is shown without quotes around types.

    >>> def turn(angle: float = 0.5, how: str = "left") -> bool: ...
    >>> inspect.signature(turn)
    <Signature (angle: 'float' = 0.5, how: 'str' = 'left') -> 'bool'>
    >>> unquoted(inspect.signature(turn))
    <Signature (angle: float = 0.5, how: str = 'left') -> bool>
    """
    parameters = [part.replace(annotation=_plain(part.annotation)) for part in signature.parameters.values()]
    return signature.replace(parameters=parameters, return_annotation=_plain(signature.return_annotation))


def _plain(annotation: Any) -> Any:
    return _Plain(annotation) if isinstance(annotation, str) else annotation


def _signature(real: Callable[[Any], inspect.Signature]) -> Callable[[Any], inspect.Signature]:
    return lambda function: unquoted(real(function))


_PATCH = Patch(
    "IPython.core.oinspect.signature",
    _signature,
    "help shows types of parameters without quotes",
    "tests/lab/test_help_text.py",
    KERNEL,
)


def install(_shell: InteractiveShell) -> None:
    """Change the shell's help."""
    _PATCH.put()


def patches() -> list[Patch]:
    """Return the change, which lasts as long as the kernel."""
    return [_PATCH]
