"""Messages filled with values drawn from a random generator."""

from coursekit.interfaces import definition as d
from coursekit.interfaces import load


def fill(message, random):
    """Set every field to a random value; return the message."""
    for name, kind in zip(message.get_fields_and_field_types(), message.SLOT_TYPES, strict=True):
        setattr(message, name, _value(kind, random))
    return message


def _value(kind, random):
    if isinstance(kind, d.Array):
        return [_element(kind.value_type, random) for _ in range(kind.size)]
    if isinstance(kind, d.AbstractSequence):
        most = kind.maximum_size if isinstance(kind, d.BoundedSequence) else 3
        return [_element(kind.value_type, random) for _ in range(random.randint(0, most))]
    return _element(kind, random)


def _element(kind, random):
    if isinstance(kind, d.NamespacedType):
        return fill(load("/".join(kind.namespaced_name()))(), random)
    if isinstance(kind, d.AbstractGenericString):
        most = kind.maximum_size if kind.has_maximum_size() else 12
        return "".join(random.choice("abc xyzäö😀") for _ in range(random.randint(0, most)))
    return _number(kind.typename, random)


def _number(typename, random):
    if typename == "boolean":
        return random.random() < 0.5
    if typename == "octet":
        return bytes([random.randrange(256)])
    if typename in ("float", "double"):
        return random.randrange(-8000, 8000) / 8
    bits = int(typename.lstrip("uint"))
    return (
        random.randrange(2**bits)
        if typename.startswith("u")
        else random.randrange(-(2 ** (bits - 1)), 2 ** (bits - 1))
    )
