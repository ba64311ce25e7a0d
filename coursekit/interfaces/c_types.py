"""C types of fields, as in rosidl_generator_c."""

from __future__ import annotations

from coursekit.interfaces.model import FieldType

TEXTS = {"string": "rosidl_runtime_c__String", "wstring": "rosidl_runtime_c__U16String"}
_IN_SEQUENCES = {"bool": "boolean", "byte": "octet", "char": "uint8", "float32": "float", "float64": "double"}


def c_name(full_name: str) -> str:
    """Return the name of a message's structure.

    >>> c_name("std_msgs/msg/String")
    'std_msgs__msg__String'
    """
    return full_name.replace("/", "__")


def owner_type(kind: FieldType) -> str:
    """Return the type with functions of its own that a field has, or each element of a fixed array; "" for numbers.

    >>> owner_type(FieldType("float32", is_array=True)), owner_type(FieldType("float32"))
    ('rosidl_runtime_c__float__Sequence', '')
    """
    element = TEXTS.get(kind.base, "" if kind.is_primitive else c_name(kind.base))
    if not kind.is_sequence:
        return element
    return f"{element or 'rosidl_runtime_c__' + _IN_SEQUENCES.get(kind.base, kind.base)}__Sequence"
