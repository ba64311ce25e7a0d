"""Liveliness tokens: the announcements of nodes, publishers, subscriptions, servers and clients."""

from __future__ import annotations

import re
from typing import NamedTuple

from .names import dds_type, demangle, mangle, ros_type
from .quality import Quality, read_quality

ADMIN = "@ros2_lv"
NODE, PUBLISHER, SUBSCRIPTION, SERVER, CLIENT = "NN", "MP", "MS", "SS", "SC"
KINDS = (NODE, PUBLISHER, SUBSCRIPTION, SERVER, CLIENT)
LONGEST = 2048
"""Maximum length of a token in characters; ROS allows names of 255."""
_ID = re.compile(r"[0-9a-zA-Z_]{1,64}")
_NODE_NAME = re.compile(r"[A-Za-z_]\w{0,254}", re.ASCII)
_HASH = re.compile(r"[0-9A-Za-z_]{1,128}")


class Token(NamedTuple):
    """An announcement; `session` is the id of the Zenoh session, `node` and `entity` count within it."""

    domain_id: int
    session: str
    node: str
    entity: str
    kind: str
    namespace: str
    node_name: str
    name: str = ""
    type_name: str = ""
    type_hash: str = ""
    quality: Quality = Quality()

    @property
    def full_node_name(self) -> str:
        """For example '/robot1/camera'."""
        return f"{self.namespace.rstrip('/')}/{self.node_name}"

    def text(self) -> str:
        """Return the key under which it is announced.

        >>> Token(0, "a1", "1", "2", "MP", "/", "talker", "/chatter", "std_msgs/msg/String", "RIHS01_0").text()
        '@ros2_lv/0/a1/1/2/MP/%/%/talker/%chatter/std_msgs::msg::dds_::String_/RIHS01_0/::,:,:,:,,'
        """
        parts = [ADMIN, str(self.domain_id), self.session, self.node, self.entity, self.kind, "%"]
        parts += [mangle(self.namespace), self.node_name]
        if self.kind != NODE:
            parts += [mangle(self.name), dds_type(self.type_name), self.type_hash, self.quality.text()]
        return "/".join(parts)


def read_token(text: str) -> Token:
    """Parse a peer's announcement.

    Raises:
        ValueError: for a malformed token, with the reason.

    >>> token = Token(0, "a1", "1", "2", "MP", "/", "talker", "/chatter", "std_msgs/msg/String", "RIHS01_0")
    >>> read_token(token.text()) == token
    True
    """
    parts = text.split("/")
    if len(text) > LONGEST or parts[0] != ADMIN or len(parts) not in (9, 13):
        raise ValueError(f"'{text[:80]}' is no token")
    domain, session, node, entity, kind, _enclave, namespace, node_name = parts[1:9]
    if kind not in KINDS or (kind == NODE) != (len(parts) == 9):
        raise ValueError(f"'{kind[:20]}' is no kind of token with {len(parts)} parts")
    if not (domain.isascii() and domain.isdecimal() and len(domain) <= 9):
        raise ValueError(f"'{domain[:20]}' is no domain")
    for number in (session, node, entity):
        _need(_ID, number, "id")
    _need(_NODE_NAME, node_name, "name of a node")
    where = "/" if namespace in ("%", "") else demangle(namespace)
    head = Token(int(domain), session, node, entity, kind, where, node_name)
    if kind == NODE:
        return head
    name, type_name, type_hash, quality = parts[9:]
    _need(_HASH, type_hash, "hash of a type")
    return head._replace(
        name=demangle(name), type_name=ros_type(type_name), type_hash=type_hash, quality=read_quality(quality)
    )


def gid_of(token: str) -> bytes:
    """Return the 16 bytes that identify a publisher in messages: the XXH3 of its token."""
    import xxhash

    digest: bytes = xxhash.xxh3_128_intdigest(token.encode()).to_bytes(16, "little")
    return digest


def _need(pattern: re.Pattern[str], text: str, what: str) -> None:
    if not pattern.fullmatch(text):
        raise ValueError(f"'{text[:40]}' is no {what}")
