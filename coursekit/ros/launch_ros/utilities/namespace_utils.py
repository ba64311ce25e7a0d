"""Helpers that combine namespaces."""

from __future__ import annotations


def is_root_namespace(ns: str) -> bool:
    """Return whether `ns` is '/'."""
    return ns == "/"


def is_namespace_absolute(ns: str) -> bool:
    """Return whether `ns` begins with '/'."""
    return ns.startswith("/")


def prefix_namespace(base_ns: str | None, ns: str | None) -> str | None:
    """Return `ns` nested in `base_ns`. An absolute `ns` stays unchanged; None and '' add nothing.

    >>> prefix_namespace('/robot1', 'arm'), prefix_namespace('/robot1', '/arm'), prefix_namespace(None, None)
    ('/robot1/arm', '/arm', None)
    """
    if ns is None:
        return base_ns
    if is_root_namespace(ns):
        return ns
    ns = ns.rstrip("/")
    if is_namespace_absolute(ns) or not base_ns:
        return ns
    if not ns:
        return base_ns
    return f"{base_ns.rstrip('/')}/{ns}"


def make_namespace_absolute(ns: str | None) -> str | None:
    """Return `ns` with a leading '/'; None stays None."""
    if ns is None or is_namespace_absolute(ns):
        return ns
    return f"/{ns}"
