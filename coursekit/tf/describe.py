"""All frames as text: as lines, as YAML, and in Graphviz's language, in tf2's formats."""

from __future__ import annotations

from collections.abc import Mapping

from .cache import FrameCache
from .errors import seconds_text

Frames = Mapping[str, "FrameCache | None"]
NOBODY = "no recorded authority"


def as_string(frames: Frames) -> str:
    """A line for each frame that has a parent.

    >>> robot = FrameCache("robot", 10**10, static=True)
    >>> _ = robot.insert(0, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), "map")
    >>> print(as_string({"map": None, "robot": robot}), end="")
    Frame robot exists with parent map.
    """
    return "".join(
        f"Frame {name} exists with parent {cache.parent or 'NO_PARENT'}.\n"
        for name, cache in frames.items()
        if cache is not None
    )


def rate(cache: FrameCache) -> float:
    """Samples per second, as tf2 counts them (10000 for a single sample).

    >>> odom, here = FrameCache("odom", 10**10), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    >>> for tenth in range(1, 12):
    ...     _ = odom.insert(tenth * 10**8, here, "map")
    >>> rate(odom)  # eleven samples within one second
    11.0
    """
    return len(cache.stamps) * 1e9 / max(cache.newest - cache.oldest, 100_000)


def as_yaml(frames: Frames, authorities: Mapping[str, str], now: int = 0) -> str:
    """Each frame with its parent, broadcaster, rate and times; `now` (ns) adds the delay."""
    if not frames:
        return "[]"
    text = ""
    for name, cache in frames.items():
        if cache is None or not cache.stamps:
            continue
        text += f"{name}: \n  parent: '{cache.parent}'\n  broadcaster: '{authorities.get(name, NOBODY)}'\n"
        text += f"  rate: {rate(cache):.3f}\n  most_recent_transform: {seconds_text(cache.newest)}\n"
        text += f"  oldest_transform: {seconds_text(cache.oldest)}\n"
        if now:
            text += f"  transform_delay: {(now - cache.newest) / 1e9:.3f}\n"
        text += f"  buffer_length: {(cache.newest - cache.oldest) / 1e9:.3f}\n"
    return text


def as_dot(frames: Frames, authorities: Mapping[str, str], now: int = 0) -> str:
    """The tree as a Graphviz graph."""
    lines = ["digraph G {"] if frames else ['digraph G {\n"no tf data recieved"']
    parents: dict[str, str] = {}
    for name, cache in frames.items():
        if cache is None or cache.parent is None:
            continue
        parents[name] = cache.parent
        old = f"( {(now - cache.newest) / 1e9:.3f} sec old)" if now else ""
        lines.append(
            f'"{cache.parent}" -> "{name}"[label="Broadcaster: {authorities.get(name, NOBODY)}\\n'
            f"Average rate: {rate(cache):.3f} Hz\\nMost recent transform: {seconds_text(cache.newest)} {old}\\n"
            f'Buffer length: {(cache.newest - cache.oldest) / 1e9:.3f} sec\\n"];'
        )
    for name in frames:
        if name not in parents:
            lines.append("edge [style=invis];")
            if now:
                lines.append(
                    ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";\n'
                    f'"Recorded at time: {seconds_text(now)}"[ shape=plaintext ] ;\n }}'
                )
                lines[-1] += f'->"{name}";'
    return "\n".join([*lines, "}"])
