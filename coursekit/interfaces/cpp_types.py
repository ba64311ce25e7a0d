"""C++ types and values of fields and constants, as in rosidl_generator_cpp."""

from __future__ import annotations

import json

from coursekit.interfaces.model import FieldType

_CPP = {
    "bool": "bool", "byte": "unsigned char", "char": "unsigned char", "float32": "float", "float64": "double",
    "string": "std::string", "wstring": "std::u16string",
    **{f"{sign}int{bits}": f"{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32, 64)},
}  # fmt: skip


def cpp_type(kind: FieldType) -> str:
    """Return the C++ type of a field.

    >>> cpp_type(FieldType('float64', is_array=True, size=36))
    'std::array<double, 36>'
    """
    element = element_type(kind)
    if kind.is_fixed:
        return f"std::array<{element}, {kind.size}>"
    if kind.is_upper_bound:
        return f"rosidl_runtime_cpp::BoundedVector<{element}, {kind.size}>"
    return f"std::vector<{element}>" if kind.is_array else element


def element_type(kind: FieldType) -> str:
    """Return the C++ type of a single value of a field.

    >>> element_type(FieldType('geometry_msgs/msg/Point', is_array=True))
    'geometry_msgs::msg::Point'
    """
    return _CPP[kind.base] if kind.is_primitive else "::".join(kind.base.split("/"))


def constant_type(kind: FieldType) -> str:
    """Return the C++ type of a constant.

    >>> constant_type(FieldType('string'))
    'const char *'
    """
    return {"string": "const char *", "wstring": "const char16_t *"}.get(kind.base, element_type(kind))


def literal(kind: FieldType, value: object) -> str:
    """Return a value as a C++ literal.

    >>> literal(FieldType('uint64'), 3), literal(FieldType('float32'), 0.5)
    ('3ull', '0.5f')
    """
    if isinstance(value, list):
        return "{" + ", ".join(literal(kind.element, item) for item in value) + "}"
    if kind.base == "bool":
        return "true" if value else "false"
    if kind.base in ("string", "wstring"):
        return ("u" if kind.base == "wstring" else "") + json.dumps(value, ensure_ascii=False)
    if kind.base in ("float32", "float64"):
        return f"{value!r}{'f' if kind.base == 'float32' else ''}"
    if kind.base == "int64" and value == -(2**63):
        return "INT64_MIN"
    return f"{value}{'u' if kind.base.startswith('u') else ''}{'ll' if kind.base.endswith('64') else ''}"
