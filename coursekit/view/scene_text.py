"""A view as text: the displays, their topics and their faults."""

from __future__ import annotations

from coursekit.nodes.rviz.kinds import KINDS

from .displays import Display
from .scene_stage import Stage


def described(stage: Stage) -> str:
    """Return the fixed frame and a line for each display; deterministic on the virtual clock."""
    frame = stage.fixed_frame
    known = stage.buffer.frames or frame != "map"
    guessed = " (guessed)" if known and not stage.config.fixed_frame else ""
    lines = [f"viewer: fixed frame {frame}{guessed}"]
    level, text = stage.global_status()
    if level != "Ok":
        lines.append(f"Global Status: {level}: {text}")
    heads = [_head(display) for display in stage.displays]
    width = max(map(len, heads), default=0)
    for head, display in zip(heads, stage.displays, strict=True):
        lines.append(f"{head:<{width}}  {display.level:<5}  {display.remark if display.config.enabled else ''}".rstrip())
    lines += [f"not known here: {name}" for name in stage.config.skipped]
    return "\n".join(lines)


def _head(display: Display) -> str:
    config = display.config
    name = config.name if config.name == config.kind else f"{config.name} ({config.kind})"
    topic = f" {config.topic}" if KINDS[config.kind].type else ""
    return f"[{'x' if config.enabled else ' '}] {name}{topic}"


__all__ = ["described"]
