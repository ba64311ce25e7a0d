"""Quality of service. In ROS 2: rclpy.qos."""

from __future__ import annotations

import warnings
from enum import Enum, IntEnum
from typing import Any

from rclpy.duration import Duration
from rclpy.impl.qos_check import QoSCompatibility as QoSCompatibility
from rclpy.impl.qos_check import check


class QoSPolicyKind(IntEnum):
    """The policies, as events and overriding parameters name them."""

    INVALID = 1
    DURABILITY = 2
    DEADLINE = 4
    LIVELINESS = 8
    RELIABILITY = 16
    HISTORY = 32
    LIFESPAN = 64
    DEPTH = 128
    LIVELINESS_LEASE_DURATION = 256
    AVOID_ROS_NAMESPACE_CONVENTIONS = 512


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """Return the name of a policy number; ValueError for an unknown number.

    >>> qos_policy_name_from_kind(16)
    'RELIABILITY'
    """
    return QoSPolicyKind(policy_kind).name


class InvalidQoSProfileException(Exception):
    """A profile lacks required settings."""

    def __init__(self, *args: Any) -> None:
        super().__init__("Invalid QoSProfile", *args)


class QoSPolicyEnum(IntEnum):
    """The values of a policy; each has a short key for command lines.

    >>> HistoryPolicy.get_from_short_key("keep_all") is HistoryPolicy.KEEP_ALL.value
    True
    """

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the lower case names."""
        return [name.lower() for name in cls.__members__ if not name.startswith("RMW")]

    @classmethod
    def get_from_short_key(cls, name: str) -> int:
        """Return the value for a lower case name; KeyError if there is none."""
        return cls[name.upper()].value

    @property
    def short_key(self) -> str:
        """The lower case name of the value."""
        return self.name.lower()

    def __str__(self) -> str:
        return f"{type(self).__name__}.{self.name}"

    __format__ = int.__format__  # type: ignore[assignment]


class HistoryPolicy(QoSPolicyEnum):
    """How many messages are kept."""

    SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    RMW_QOS_POLICY_HISTORY_KEEP_LAST = 1
    KEEP_ALL = 2
    RMW_QOS_POLICY_HISTORY_KEEP_ALL = 2
    UNKNOWN = 3
    RMW_QOS_POLICY_HISTORY_UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether a message may be lost."""

    SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT = 0
    RELIABLE = 1
    RMW_QOS_POLICY_RELIABILITY_RELIABLE = 1
    BEST_EFFORT = 2
    RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT = 2
    UNKNOWN = 3
    RMW_QOS_POLICY_RELIABILITY_UNKNOWN = 3


class DurabilityPolicy(QoSPolicyEnum):
    """Whether a late subscription gets earlier messages."""

    SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL = 1
    VOLATILE = 2
    RMW_QOS_POLICY_DURABILITY_VOLATILE = 2
    UNKNOWN = 3
    RMW_QOS_POLICY_DURABILITY_UNKNOWN = 3


class LivelinessPolicy(QoSPolicyEnum):
    """How a publisher shows that it is alive."""

    SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    RMW_QOS_POLICY_LIVELINESS_AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    RMW_QOS_POLICY_LIVELINESS_UNKNOWN = 4


QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy


class _Policy:
    """A type-checked attribute of a profile; an enum attribute also accepts the enum's numbers."""

    def __init__(self, kind: type) -> None:
        self._kind = kind

    def __set_name__(self, owner: type, name: str) -> None:
        self._slot = "_" + name

    def __get__(self, profile: Any, owner: type | None = None) -> Any:
        return self if profile is None else getattr(profile, self._slot)

    def __set__(self, profile: Any, value: Any) -> None:
        if issubclass(self._kind, IntEnum):
            assert isinstance(value, int), f"{self._slot[1:]} must be a {self._kind.__name__}"
            value = self._kind(value)
        assert isinstance(value, self._kind), f"{self._slot[1:]} must be a {self._kind.__name__}"
        setattr(profile, self._slot, value)


class QoSProfile:
    """The QoS that a publisher offers or a subscription requests.

    `history` or `depth` must be given; KEEP_LAST needs a depth. Raises InvalidQoSProfileException if one is missing.

    >>> QoSProfile(depth=5).history
    <HistoryPolicy.KEEP_LAST: 1>
    """

    __slots__ = (
        "_avoid_ros_namespace_conventions",
        "_deadline",
        "_depth",
        "_durability",
        "_history",
        "_lifespan",
        "_liveliness",
        "_liveliness_lease_duration",
        "_reliability",
    )

    history = _Policy(HistoryPolicy)
    depth = _Policy(int)
    reliability = _Policy(ReliabilityPolicy)
    durability = _Policy(DurabilityPolicy)
    lifespan = _Policy(Duration)
    deadline = _Policy(Duration)
    liveliness = _Policy(LivelinessPolicy)
    liveliness_lease_duration = _Policy(Duration)
    avoid_ros_namespace_conventions = _Policy(bool)

    def __init__(self, **kwargs: Any) -> None:
        unknown = [name for name in kwargs if name not in _DEFAULTS]
        assert not unknown, f"Invalid arguments passed to constructor: {unknown}"
        if "history" not in kwargs:
            if "depth" not in kwargs:
                raise InvalidQoSProfileException("History and/or depth settings are required.")
            kwargs["history"] = HistoryPolicy.KEEP_LAST
        elif kwargs["history"] == HistoryPolicy.KEEP_LAST and "depth" not in kwargs:
            raise InvalidQoSProfileException("History set to KEEP_LAST without a depth setting.")
        for name, default in _DEFAULTS.items():
            setattr(self, name, kwargs.get(name, default))
        if self.history == HistoryPolicy.KEEP_LAST and self.depth == 0:
            warnings.warn(
                "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
                "This will be interpreted as SYSTEM_DEFAULT",
                stacklevel=2,
            )

    def get_c_qos_profile(self) -> QoSProfile:
        """Return the profile itself: there is no C object behind it."""
        return self

    def to_dict(self) -> dict[str, Any]:
        """The policies by name, as the C profile returns them: `QoSProfile(**profile.to_dict())` is an equal profile."""
        return {name.lstrip("_"): getattr(self, name) for name in self.__slots__}

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return False
        return all(getattr(self, name) == getattr(other, name) for name in _DEFAULTS)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        inside = ", ".join(f"{name}={getattr(self, name)!s}" for name in _DEFAULTS)
        return f"{type(self).__name__}({inside})"


_DEFAULTS: dict[str, Any] = {
    "history": HistoryPolicy.SYSTEM_DEFAULT,
    "depth": 0,
    "reliability": ReliabilityPolicy.RELIABLE,
    "durability": DurabilityPolicy.VOLATILE,
    "lifespan": Duration(),
    "deadline": Duration(),
    "liveliness": LivelinessPolicy.SYSTEM_DEFAULT,
    "liveliness_lease_duration": Duration(),
    "avoid_ros_namespace_conventions": False,
}

qos_profile_unknown = QoSProfile(
    history=HistoryPolicy.UNKNOWN,
    depth=0,
    reliability=ReliabilityPolicy.UNKNOWN,
    durability=DurabilityPolicy.UNKNOWN,
    liveliness=LivelinessPolicy.UNKNOWN,
)
qos_profile_default = QoSProfile(depth=10)
_qos_profile_default = qos_profile_default
qos_profile_system_default = QoSProfile(
    history=HistoryPolicy.SYSTEM_DEFAULT,
    reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
    durability=DurabilityPolicy.SYSTEM_DEFAULT,
)
qos_profile_sensor_data = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
qos_profile_services_default = QoSProfile(depth=10)
qos_profile_parameters = QoSProfile(depth=1000)
qos_profile_parameter_events = QoSProfile(depth=1000)
qos_profile_action_status_default = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class PredefinedProfiles:
    """The class that programs access as rmw_qos_profile_t of rclpy's C module."""

    @staticmethod
    def predefined(name: str) -> QoSProfile:
        """Return a profile by its variable name, for example 'qos_profile_default'; ValueError for an unknown name."""
        profile = globals().get(name)
        if not isinstance(profile, QoSProfile):
            known = ", ".join(word for word, value in globals().items() if isinstance(value, QoSProfile) and word[0] != "_")
            raise ValueError(f"Requested unknown rmw_qos_profile: '{name}' is none of {known}")
        return profile


class QoSPresetProfiles(Enum):
    """The named profiles, for command lines and YAML."""

    UNKNOWN = qos_profile_unknown
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the lower case names."""
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """Return the profile for a lower case name; KeyError if there is none."""
        return cls[name.upper()].value


def qos_check_compatible(
    publisher_qos: QoSProfile, subscription_qos: QoSProfile
) -> tuple[QoSCompatibility, str]:
    """Return whether the two profiles are compatible, and the reasons if they may not be.

    >>> best_effort = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    >>> qos_check_compatible(best_effort, QoSProfile(depth=1))
    (<QoSCompatibility.ERROR: 2>, 'ERROR: Best effort publisher and reliable subscription;')
    """
    return check(publisher_qos, subscription_qos)
