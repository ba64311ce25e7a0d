"""The MIME bundle of a widget, which the lab extends with forms that need no browser."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable
from typing import Any


def forms_of(bundle: Any) -> dict[str, Any] | None:
    """Return the forms in the result of a widget's `_repr_mimebundle_`; None when the widget shows nothing.

    >>> forms_of(({"text/plain": "a"}, {}))
    {'text/plain': 'a'}
    """
    forms: dict[str, Any] | None = bundle[0] if isinstance(bundle, tuple) else bundle
    return forms


def with_text(bundle: Any, text: str) -> Any:
    """Return the bundle with `text` as its plain-text form.

    >>> with_text({"text/plain": "Box()"}, "[pad /cmd_vel]")
    {'text/plain': '[pad /cmd_vel]'}
    """
    forms = forms_of(bundle)
    if forms is not None:
        forms["text/plain"] = text
    return bundle


def with_picture(bundle: Any, png: Callable[[], bytes]) -> Any:
    """Return the bundle with a PNG form; `png` is not called when the widget shows nothing.

    >>> with_picture({"text/plain": "Box()"}, lambda: b"PNG")["image/png"]
    'UE5H'
    """
    forms = forms_of(bundle)
    if forms is not None:
        forms["image/png"] = b64encode(png()).decode()
    return bundle


__all__ = ["forms_of", "with_picture", "with_text"]
