"""Messages for tests: for each type, several messages that differ in every field."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from builtin_interfaces.msg import Duration, Time

from . import msg as types

BITS = (8, 16, 32, 64)


def get_msg_builtins() -> list[Any]:
    """A duration and a time."""
    return [types.Builtins(duration_value=Duration(sec=-1, nanosec=123456789), time_value=Time(sec=1, nanosec=987654321))]


def get_msg_empty() -> list[Any]:
    """A message without fields."""
    return [types.Empty()]


def get_msg_basic_types() -> list[Any]:
    """Zeros, the largest numbers, the smallest, and small ones."""
    return [_basic(0, 0.0), _basic(1, 1.125, _largest), _basic(255, -2.125, _smallest), _basic(2, 1.125, lambda name: 1)]


def _largest(name: str) -> int:
    bits = int(name.split("int")[1].split("_")[0])
    return 2**bits - 1 if name.startswith("u") else 2 ** (bits - 1) - 1


def _smallest(name: str) -> int:
    return 0 if name.startswith("u") else -_largest(name) - 1


def _basic(byte: int, real: float, whole: Callable[[str], int] = lambda name: 0) -> Any:
    message = types.BasicTypes(
        bool_value=byte == 1, byte_value=bytes([byte]), char_value=byte, float32_value=real, float64_value=real
    )
    for name in (f"{sign}int{bits}_value" for sign in ("", "u") for bits in BITS):
        setattr(message, name, whole(name))
    return message


def get_msg_constants() -> list[Any]:
    """A message with constants only."""
    return [types.Constants()]


def get_msg_defaults() -> list[Any]:
    """A message with its default values."""
    return [types.Defaults()]


def get_msg_strings() -> list[Any]:
    """An empty text, an ASCII text, a text beyond ASCII, and a text of the maximum length."""
    texts = ("", "Hello world!", "Hell\u00f6 w\u00f6rld!", "abc" * 7)
    return [types.Strings(string_value=text, bounded_string_value=text) for text in texts]


def _filled(message: Any) -> Any:
    """Fill arrays or sequences of three: numbers, texts and messages."""
    basic = get_msg_basic_types()
    message.bool_values, message.byte_values = [False, True, False], [b"\0", b"\1", b"\xff"]
    message.char_values = [0, 1, 255]
    message.float32_values, message.float64_values = [1.125, 0.0, -2.125], [3.1415, 0.0, -3.1415]
    for name in (f"{sign}int{bits}_value" for sign in ("", "u") for bits in BITS):
        setattr(message, name + "s", [0, _largest(name), _smallest(name)])
    message.string_values = ["", "max value", "optional min value"]
    message.basic_types_values = basic[:3]
    message.constants_values = get_msg_constants() * 3
    message.defaults_values = get_msg_defaults() * 3
    message.alignment_check = 2
    return message


def get_msg_arrays() -> list[Any]:
    """Arrays."""
    return [_filled(types.Arrays())]


def get_msg_unbounded_sequences() -> list[Any]:
    """Sequences with three elements, with one, and without any."""
    single = types.UnboundedSequences(bool_values=[True], string_values=["max value"], basic_types_values=[_basic(1, 1.0)])
    return [_filled(types.UnboundedSequences()), single, types.UnboundedSequences(alignment_check=4)]


def get_msg_bounded_sequences() -> list[Any]:
    """Bounded sequences, full and empty."""
    return [_filled(types.BoundedSequences()), types.BoundedSequences(alignment_check=4)]


def get_msg_nested() -> list[Any]:
    """A message in a message."""
    return [types.Nested(basic_types_value=message) for message in get_msg_basic_types()]


def get_msg_multi_nested() -> list[Any]:
    """Messages in arrays and sequences of messages."""
    kinds = {
        "arrays": get_msg_arrays(),
        "bounded_sequences": get_msg_bounded_sequences(),
        "unbounded_sequences": get_msg_unbounded_sequences(),
    }
    message = types.MultiNested()
    for kind, messages in kinds.items():
        setattr(message, f"array_of_{kind}", (messages * 3)[:3])
        setattr(message, f"bounded_sequence_of_{kind}", messages[:2])
        setattr(message, f"unbounded_sequence_of_{kind}", messages)
    return [message]


def get_msg_bounded_plain_sequences() -> list[Any]:
    """Bounded sequences without texts, full and empty."""
    source, full = get_msg_bounded_sequences()[0], types.BoundedPlainSequences(alignment_check=2)
    for name in full.get_fields_and_field_types():
        if name.endswith("_values"):
            setattr(full, name, getattr(source, name))
    return [full, types.BoundedPlainSequences(alignment_check=4)]


def get_msg_wstrings() -> list[Any]:
    """Wide strings, empty and beyond ASCII, alone and in arrays and sequences."""
    many = types.WStrings(array_of_wstrings=["1", "two", "\u4e09"], bounded_sequence_of_wstrings=["one", "\u4e8c"])
    many.unbounded_sequence_of_wstrings = [".", "..", "...", "\u56db"]
    texts = ("ascii", "Hell\u00f6 w\u00f6rld!", "\u30cf\u30ed\u30fc\u30ef\u30fc\u30eb\u30c9")
    return [many, *(types.WStrings(wstring_value=text) for text in texts)]


def get_test_msg(message_name: str) -> list[Any]:
    """The messages of the type with that name; raises ValueError for an unknown name.

    >>> len(get_test_msg("Builtins"))
    1
    """
    makers = {name.replace("_", ""): make for name, make in globals().items() if name.startswith("get_msg_")}
    make = makers.get(f"getmsg{message_name.lower()}")
    if make is None:
        known = ", ".join(sorted(name for name in dir(types) if name[0].isupper()))
        raise ValueError(f"There is no test message '{message_name}' (known: {known})")
    return list(make())
