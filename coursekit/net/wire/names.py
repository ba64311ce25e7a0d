"""The spelling of topic and type names in keys."""

from __future__ import annotations

import re

NO_HASH = "TypeHashNotSupported"
"""Humble's placeholder for a type's hash, which later distributions compute."""
ANY_HASH = "*"
_TYPE = re.compile(r"(\w+)::(msg|srv|action)::dds_::(\w+)_")
_NAME = re.compile(r"(/[A-Za-z_~{}][\w~{}]*)+")


def dds_type(name: str) -> str:
    """Return a type in DDS spelling.

    >>> dds_type("std_msgs/msg/String")
    'std_msgs::msg::dds_::String_'
    """
    package, kind, short = name.split("/")
    return f"{package}::{kind}::dds_::{short}_"


def ros_type(name: str) -> str:
    """Return a type in ROS spelling; ValueError for an invalid one.

    >>> ros_type("std_msgs::msg::dds_::String_")
    'std_msgs/msg/String'
    """
    match = _TYPE.fullmatch(name)
    if match is None or not name.isascii():
        raise ValueError(f"'{name[:80]}' is no type")
    return "/".join(match.groups())


def mangle(name: str) -> str:
    """Return a name as one part of a key.

    >>> mangle("/robot/scan")
    '%robot%scan'
    """
    return name.replace("/", "%")


def demangle(name: str) -> str:
    """Invert `mangle`; ValueError for an invalid topic name.

    >>> demangle("%robot%scan")
    '/robot/scan'
    """
    topic = name.replace("%", "/")
    if not _NAME.fullmatch(topic) or not topic.isascii():
        raise ValueError(f"'{topic[:80]}' is no name of a topic")
    return topic


def data_key(domain_id: int, name: str, type_name: str, type_hash: str = ANY_HASH) -> str:
    """Return the key of a topic's messages or of a service's requests.

    >>> data_key(0, "/chatter", "std_msgs/msg/String", NO_HASH)
    '0/chatter/std_msgs::msg::dds_::String_/TypeHashNotSupported'
    """
    return f"{domain_id}/{name.strip('/')}/{dds_type(type_name)}/{type_hash}"
