"""The types of fields, as shown in a message's SLOT_TYPES.

In ROS 2: rosidl_parser.definition.
"""

from __future__ import annotations

from collections.abc import Iterable

SIGNED_NONEXPLICIT_INTEGER_TYPES = ("short", "long", "long long")
UNSIGNED_NONEXPLICIT_INTEGER_TYPES = ("unsigned short", "unsigned long", "unsigned long long")
NONEXPLICIT_INTEGER_TYPES = SIGNED_NONEXPLICIT_INTEGER_TYPES + UNSIGNED_NONEXPLICIT_INTEGER_TYPES
FLOATING_POINT_TYPES = ("float", "double", "long double")
CHARACTER_TYPES = ("char", "wchar")
BOOLEAN_TYPE = "boolean"
OCTET_TYPE = "octet"
SIGNED_EXPLICIT_INTEGER_TYPES = ("int8", "int16", "int32", "int64")
UNSIGNED_EXPLICIT_INTEGER_TYPES = ("uint8", "uint16", "uint32", "uint64")
EXPLICIT_INTEGER_TYPES = SIGNED_EXPLICIT_INTEGER_TYPES + UNSIGNED_EXPLICIT_INTEGER_TYPES
SIGNED_INTEGER_TYPES = SIGNED_NONEXPLICIT_INTEGER_TYPES + SIGNED_EXPLICIT_INTEGER_TYPES
UNSIGNED_INTEGER_TYPES = UNSIGNED_NONEXPLICIT_INTEGER_TYPES + UNSIGNED_EXPLICIT_INTEGER_TYPES
INTEGER_TYPES = SIGNED_INTEGER_TYPES + UNSIGNED_INTEGER_TYPES
BASIC_TYPES = (*INTEGER_TYPES, *FLOATING_POINT_TYPES, *CHARACTER_TYPES, BOOLEAN_TYPE, OCTET_TYPE)
EMPTY_STRUCTURE_REQUIRED_MEMBER_NAME = "structure_needs_at_least_one_member"
CONSTANT_MODULE_SUFFIX = "_Constants"
SERVICE_REQUEST_MESSAGE_SUFFIX = "_Request"
SERVICE_RESPONSE_MESSAGE_SUFFIX = "_Response"
ACTION_GOAL_SUFFIX = "_Goal"
ACTION_RESULT_SUFFIX = "_Result"
ACTION_FEEDBACK_SUFFIX = "_Feedback"
ACTION_GOAL_SERVICE_SUFFIX = "_SendGoal"
ACTION_RESULT_SERVICE_SUFFIX = "_GetResult"
ACTION_FEEDBACK_MESSAGE_SUFFIX = "_FeedbackMessage"


class AbstractType:
    """Any type; two are equal when their classes and their parts are equal."""

    __slots__: tuple[str, ...] = ()

    def _parts(self) -> tuple[object, ...]:
        return tuple(
            getattr(self, name) for kind in type(self).__mro__ for name in getattr(kind, "__slots__", ())
        )

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._parts() == other._parts()

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._parts()))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(map(repr, self._parts()))})"


class AbstractNestableType(AbstractType):
    """A type that can be the element of an array or a sequence."""

    __slots__ = ()


class BasicType(AbstractNestableType):
    """A number, a boolean or an octet, under its IDL name (float64 is 'double').

    >>> BasicType('double')
    BasicType('double')
    """

    __slots__ = ("typename",)

    def __init__(self, typename: str) -> None:
        if typename not in BASIC_TYPES:
            raise AssertionError(f"'{typename}' is no basic type; known: {', '.join(BASIC_TYPES)}")
        self.typename = typename


class NamedType(AbstractNestableType):
    """A type known by its bare name."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        self.name = name


class NamespacedType(AbstractNestableType):
    """A message type: namespaces ['std_msgs', 'msg'] and name 'String'.

    >>> NamespacedType(["std_msgs", "msg"], "String").namespaced_name()
    ('std_msgs', 'msg', 'String')
    """

    __slots__ = ("namespaces", "name")  # noqa: RUF023 (the order of the constructor)

    def __init__(self, namespaces: Iterable[str], name: str) -> None:
        self.namespaces = list(namespaces)
        self.name = name

    def __hash__(self) -> int:
        return hash(self.namespaced_name())

    def namespaced_name(self) -> tuple[str, ...]:
        """Return e.g. ('std_msgs', 'msg', 'String')."""
        return (*self.namespaces, self.name)


class AbstractGenericString(AbstractNestableType):
    """Any string."""

    __slots__ = ()

    def has_maximum_size(self) -> bool:
        """Return whether the string is bounded."""
        return False


class AbstractString(AbstractGenericString):
    """Any string of 8-bit characters."""

    __slots__ = ()


class AbstractWString(AbstractGenericString):
    """Any string of 16-bit characters."""

    __slots__ = ()


class _Bounded(AbstractGenericString):
    __slots__ = ()

    def has_maximum_size(self) -> bool:
        return True


class BoundedString(_Bounded, AbstractString):
    """`string<=N`; N counts characters.

    >>> BoundedString(10).has_maximum_size(), UnboundedString().has_maximum_size()
    (True, False)
    """

    __slots__ = ("maximum_size",)

    def __init__(self, maximum_size: int) -> None:
        self.maximum_size = int(maximum_size)


class UnboundedString(AbstractString):
    """`string`."""

    __slots__ = ()


class BoundedWString(_Bounded, AbstractWString):
    """`wstring<=N`; N counts characters."""

    __slots__ = ("maximum_size",)

    def __init__(self, maximum_size: int) -> None:
        self.maximum_size = int(maximum_size)


class UnboundedWString(AbstractWString):
    """`wstring`."""

    __slots__ = ()


class AbstractNestedType(AbstractType):
    """An array or a sequence of `value_type`."""

    __slots__ = ("value_type",)

    def __init__(self, value_type: AbstractNestableType) -> None:
        self.value_type = value_type

    def has_maximum_size(self) -> bool:
        """Return whether the number of elements is bounded."""
        return True


class Array(AbstractNestedType):
    """`type[N]`: always N elements.

    >>> Array(BasicType("double"), 36).size, Array(BasicType("double"), 36) == Array(BasicType("double"), 9)
    (36, False)
    """

    __slots__ = ("size",)

    def __init__(self, value_type: AbstractNestableType, size: int) -> None:
        super().__init__(value_type)
        self.size = size


class AbstractSequence(AbstractNestedType):
    """Any number of elements, possibly up to a bound."""

    __slots__ = ()


class BoundedSequence(AbstractSequence):
    """`type[<=N]`: up to N elements."""

    __slots__ = ("maximum_size",)

    def __init__(self, value_type: AbstractNestableType, maximum_size: int) -> None:
        super().__init__(value_type)
        self.maximum_size = maximum_size


class UnboundedSequence(AbstractSequence):
    """`type[]`: any number of elements."""

    __slots__ = ()

    def has_maximum_size(self) -> bool:
        return False
