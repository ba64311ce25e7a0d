"""Reads the keys of an untrusted YAML mapping: every value is checked, every error names its key."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from coursekit.bag.errors import BagError
from coursekit.bag.yaml_text import dump

_MISSING = object()


class Fields:
    """One mapping, at a location named in errors.

    >>> Fields({"version": 5}, "top", "metadata.yaml").integer("version")
    5
    """

    def __init__(self, values: Any, place: str, where: str) -> None:
        self._place, self._where = place, where
        if not isinstance(values, dict):
            raise self._error(f"'{place}' is {_kind(values)}, and should be keys with values")
        self._values: dict[Any, Any] = values

    def _error(self, text: str) -> BagError:
        return BagError(f"{self._where}: {text}")

    def _get(self, key: str, default: Any = _MISSING) -> Any:
        value = self._values.get(key, default)
        if value is _MISSING:
            raise self._error(f"'{key}' is missing in '{self._place}'")
        return value

    def _wrong(self, key: str, value: Any, wish: str) -> BagError:
        return self._error(f"'{key}' in '{self._place}' is {_kind(value)}, and should be {wish}")

    def integer(self, key: str) -> int:
        """Return a 64-bit integer."""
        value = self._get(key)
        if not isinstance(value, int) or isinstance(value, bool) or not -(2**63) <= value < 2**63:
            raise self._wrong(key, value, "a whole number of 64 bits")
        return value

    def text(self, key: str, default: Any = _MISSING) -> str:
        """Return a string; for an optional key, null means the default.

        >>> Fields({"storage_identifier": 3}, "top", "metadata.yaml").text("storage_identifier")
        Traceback (most recent call last):
        coursekit.bag.errors.BagError: metadata.yaml: 'storage_identifier' in 'top' is int 3, and should be a text
        """
        value = self._get(key, default)
        if value is None and default is not _MISSING:
            return str(default)
        if not isinstance(value, str):
            raise self._wrong(key, value, "a text")
        return value

    def texts(self, key: str) -> list[str]:
        """Return a list of strings."""
        value = self._get(key)
        if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
            raise self._wrong(key, value, "a list of texts")
        return value

    def text_or_yaml(self, key: str) -> str:
        """Return a string; since version 9 also a list, which is converted to a YAML string."""
        value = self._get(key, "")
        if isinstance(value, list):
            return dump(value) if value else ""
        return self.text(key, "")

    def mapping_of_texts(self, key: str) -> dict[str, str]:
        """Return strings by name; none when the key is missing."""
        value = self._get(key, None)
        if value is None:
            return {}
        if not isinstance(value, dict):
            raise self._wrong(key, value, "keys with texts")
        return {str(name): str(text) for name, text in value.items()}

    def inside(self, key: str) -> Fields:
        """Return the mapping under a key."""
        return Fields(self._get(key), key, self._where)

    def each(self, key: str, optional: bool = False) -> Iterator[Fields]:
        """Yield the mappings of a list.

        >>> files = Fields({"files": [{"path": "a.db3"}, {"path": "b.db3"}]}, "top", "metadata.yaml")
        >>> [one.text("path") for one in files.each("files")]
        ['a.db3', 'b.db3']
        """
        value = self._get(key, [] if optional else _MISSING)
        if value is None and optional:
            return
        if not isinstance(value, list):
            raise self._wrong(key, value, "a list")
        for number, item in enumerate(value):
            yield Fields(item, f"{key}[{number}]", self._where)


def _kind(value: Any) -> str:
    shown = repr(value)
    return f"{type(value).__name__} {shown if len(shown) < 60 else shown[:57] + '...'}"
