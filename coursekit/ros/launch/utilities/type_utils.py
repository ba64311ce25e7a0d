"""Types of launch values: scalars, uniform lists, and substitutions that result in them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, get_args, get_origin

import yaml

from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from .normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from .perform_substitutions_impl import perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext

ScalarTypesTuple = (int, float, bool, str)
ScalarValueType = int | float | bool | str
ListValueType = list[int] | list[float] | list[bool] | list[str]
AllowedTypesTuple = (*ScalarTypesTuple, list[int], list[float], list[bool], list[str])
AllowedTypesType = Any
AllowedValueType = ScalarValueType | ListValueType
SomeValueType = SomeSubstitutionsType | ScalarValueType | Sequence[Any]
StrSomeValueType = ScalarValueType | Sequence[Any]
NormalizedValueType = Any


def is_typing_list(data_type: Any) -> bool:
    """Return whether `data_type` is a `List[...]`."""
    return get_origin(data_type) is list


def is_valid_scalar_type(data_type: Any) -> bool:
    """Return whether `data_type` is one of the scalar types of launch values."""
    return data_type in ScalarTypesTuple


def extract_type(data_type: Any) -> tuple[Any, bool]:
    """Return (type of the items, whether it is a list).

    >>> extract_type(list[int]), extract_type(str)
    ((<class 'int'>, True), (<class 'str'>, False))

    Raises:
        ValueError: for a type that is not allowed for launch values.
    """
    is_list = is_typing_list(data_type)
    scalar = next(iter(get_args(data_type)), None) if is_list else data_type
    if not is_valid_scalar_type(scalar):
        raise ValueError(f"Unrecognized data type: {data_type}")
    return scalar, is_list


def is_instance_of_valid_type(value: Any, can_be_str: bool = False) -> bool:
    """Return whether `value` is a scalar or a uniform list; with `can_be_str`, the items may include text."""
    if not isinstance(value, list):
        return isinstance(value, ScalarTypesTuple)
    kinds = {type(item) for item in value}
    if can_be_str and len(kinds) > 1:
        kinds.discard(str)
    return len(kinds) == 1 and is_valid_scalar_type(kinds.pop())


def is_instance_of(value: Any, data_type: Any, can_be_str: bool = False) -> bool:
    """Return whether `value` has `data_type`; with `can_be_str`, text is also accepted."""
    if data_type is None:
        return is_instance_of_valid_type(value, can_be_str)
    scalar, is_list = extract_type(data_type)
    kinds = (scalar, str) if can_be_str else (scalar,)
    if is_list:
        return isinstance(value, list) and all(type(item) in kinds for item in value)
    return type(value) in kinds


def coerce_to_type(value: str, data_type: Any = None, can_be_str: bool = False) -> Any:
    """Return the text `value` as `data_type`; None: the type that YAML's rules determine.

    Numbers are read as Python reads them (`1e-3`, `inf`), booleans and lists as YAML does.

    >>> coerce_to_type('2', float), coerce_to_type('off'), coerce_to_type('a b')
    (2.0, False, 'a b')

    Raises:
        TypeError: if `value` is not text.
        ValueError: if the text is not a value of that type.
    """
    if not isinstance(value, str):
        raise TypeError(f"Got '{value}' of type '{type(value).__name__}' where a text was expected")
    if data_type is str or (data_type is None and not value):
        return value
    try:
        read = data_type(value) if data_type in (int, float) else yaml.safe_load(value)
    except (ValueError, yaml.YAMLError) as error:
        if can_be_str:
            return value
        raise ValueError(f"Failed to convert '{value}' to '{_type_name(data_type)}': {error}") from error
    if is_instance_of(read, data_type):
        return read
    if can_be_str:
        return read if is_instance_of(read, data_type, can_be_str) else value
    raise ValueError(f"Failed to convert '{value}' to '{_type_name(data_type)}'")


def _type_name(data_type: Any) -> str:
    if data_type is None:
        return "a value by YAML's rules"
    return getattr(data_type, "__name__", None) if isinstance(data_type, type) else str(data_type)  # type: ignore


def coerce_list(value: Iterable[str], data_type: Any = None, can_be_str: bool = False) -> list[Any]:
    """Return each text of a list as `data_type`; if that is None, all must have the same type.

    Raises:
        TypeError: if `value` is not a list of texts.
        ValueError: if an item is not a value of that type, or if the items have several types.
    """
    items = [value] if isinstance(value, str) else list(value)
    if isinstance(value, str) or not all(isinstance(item, str) for item in items):
        raise TypeError(f"Got '{value}' where a list of texts was expected")
    read = [coerce_to_type(item, data_type, can_be_str) for item in items]
    if not is_instance_of(read, data_type if data_type is None else list[data_type], can_be_str):
        raise ValueError(f"The items of {items} are of several types: {read}")
    return read


def get_typed_value(value: str | Sequence[str], data_type: Any, can_be_str: bool = True) -> Any:
    """Return text, or a list of texts, as `data_type`.

    Raises:
        TypeError: if a list is given for a single value.
        ValueError: if the conversion is not possible.
    """
    if isinstance(value, str):
        return coerce_to_type(value, data_type, can_be_str)
    if data_type is None:
        return coerce_list(value, None, can_be_str)
    scalar, is_list = extract_type(data_type)
    if not is_list:
        raise TypeError(f"Got a list '{value}' where one {_type_name(data_type)} was expected")
    return coerce_list(value, scalar, can_be_str)


def is_substitution(value: Any) -> bool:
    """Return whether `value` is a substitution or a list that contains one."""
    if isinstance(value, Substitution):
        return True
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes)):
        return any(isinstance(item, Substitution) for item in value)
    return False


def is_normalized_substitution(value: Any) -> bool:
    """Return whether `value` is a list of only substitutions."""
    return isinstance(value, list) and bool(value) and all(isinstance(item, Substitution) for item in value)


def normalize_typed_substitution(value: Any, data_type: Any) -> Any:
    """Check and return `value`: typed values stay unchanged, substitutions become lists of substitutions.

    Raises:
        TypeError: if a value that is not a substitution has another type than `data_type`.
    """
    if isinstance(value, Substitution) or _is_one_text(value):
        return normalize_to_list_of_substitutions(value)
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes)):
        return _normalize_typed_list(list(value), data_type)
    if not is_instance_of(value, data_type):
        advice = f"; write {value}.0" if data_type is float and type(value) is int else ""
        raise TypeError(f"Got a value of type '{type(value)}' for '{value}', expected '{data_type}'{advice}")
    return value


def _is_one_text(value: Any) -> bool:
    """Return whether `value` is a list of substitutions and texts that together form one text."""
    return is_substitution(value) and all(isinstance(item, (Substitution, str)) for item in value)


def _normalize_typed_list(items: list[Any], data_type: Any) -> list[Any]:
    if any(is_substitution(item) for item in items):
        return [normalize_to_list_of_substitutions(item) if is_substitution(item) else item for item in items]
    wants_floats = data_type is not None and extract_type(data_type)[0] is float
    if wants_floats or {type(item) for item in items} == {int, float}:
        items = [float(item) if type(item) is int else item for item in items]
    if not is_instance_of(items, data_type):
        raise TypeError(f"Got the list '{items}', expected a uniform list of type '{data_type}'")
    return items


def perform_typed_substitution(context: LaunchContext, value: Any, data_type: Any) -> Any:
    """Return the value of a normalized typed substitution in `context`.

    Raises:
        TypeError: if a value that is not a substitution has another type than `data_type`.
        ValueError: if the text of the substitution cannot be converted to `data_type`.
    """
    if is_substitution(value):
        return coerce_to_type(perform_substitutions(context, value), data_type)
    if isinstance(value, list) and any(is_substitution(item) for item in value):
        return _perform_list(context, value, data_type)
    if not is_instance_of(value, data_type):
        raise TypeError(f"Got a value of type '{type(value)}' for '{value}', expected '{data_type}'")
    return value


def _perform_list(context: LaunchContext, items: list[Any], data_type: Any) -> list[Any]:
    scalar = extract_type(data_type)[0] if data_type is not None else None
    texts = [perform_substitutions(context, item) if is_substitution(item) else item for item in items]
    return coerce_list([item if isinstance(item, str) else str(item) for item in texts], scalar)
