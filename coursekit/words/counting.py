"""Numbers with their nouns."""


def counted(number: int, one: str, many: str = "") -> str:
    """Return a number with its noun, in singular or plural.

    >>> counted(1, "notebook"), counted(2, "notebook"), counted(0, "copy", "copies")
    ('1 notebook', '2 notebooks', '0 copies')
    """
    return f"{number} {one if number == 1 else many or one + 's'}"


__all__ = ["counted"]
