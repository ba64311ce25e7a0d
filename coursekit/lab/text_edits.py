"""Repeatable changes to a text: an addition that is already present is not made again. Uses neither files nor Jupyter."""

from __future__ import annotations


def edited(text: str, old: str, new: str) -> str | None:
    """Return `text` with `new` in place of `old`, or unchanged if that was done before; None if `old` is missing.

    >>> once = edited("scripts: [", "[", "[ a,")
    >>> once == edited(once, "[", "[ a,")
    True
    """
    if is_done(text, old, new):
        return text
    return text.replace(old, new, 1) if old in text else None


def is_done(text: str, old: str, new: str) -> bool:
    r"""Whether `new` is present; an addition also counts if lines or words were since inserted into it.

    >>> is_done("import rclpy\nimport math\n", "import rclpy\n", "import rclpy\nimport math\n")
    True
    """
    if new in text:
        return True
    above, anchor, below = text.partition(old)
    if not old or not anchor:
        return _has_lines(new, _lines(old)) and _has_lines(text, _lines(new))
    before, adds, after = new.partition(old)
    return bool(adds) and _has_lines(above, _lines(before)) and _has_lines(below, _lines(after))


def undone(text: str, old: str, new: str) -> str:
    r"""Return `text` as it was before `old` became `new`; unchanged if that cannot be determined.

    >>> undone("speed = 0.5\n", "speed = 0.2", "speed = 0.5")
    'speed = 0.2\n'
    """
    if new in text:
        return text.replace(new, old, 1)
    before, middle, after = new.partition(old)
    for part in (before, after):
        if middle and part.strip() and text.count(part) == 1:
            text = text.replace(part, "")
    return text


def appended(text: str, piece: str, former: str | None) -> str:
    """Return `text` with `piece` at its end, or in place of the former piece of the same cell.

    >>> appended("a\\nb\\nc\\n", "B\\n", former="b\\n")
    'a\\nB\\nc\\n'
    """
    if former and former in text:
        above, _, below = text.rpartition(former)
        return above + piece + below
    return text if piece and piece in text else text + piece


def _lines(text: str) -> list[str]:
    return [line.strip() for line in text.splitlines() if line.strip()]


def _has_lines(text: str, wanted: list[str]) -> bool:
    """Whether these lines are in `text` in this order; extra words within a line are allowed."""
    rest = iter(_lines(text))
    return all(any(_within(line, there) for there in rest) for line in wanted)


def _within(line: str, there: str) -> bool:
    words = iter(there.split())
    return all(word in words for word in line.split())


__all__ = ["appended", "edited", "is_done", "undone"]
