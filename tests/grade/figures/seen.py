"""What is in a figure."""

from coursekit.grade.checking import judge
from coursekit.grade.exercise import find
from coursekit.grade.illustration import Illustration
from coursekit.view.figure import Cells


def handed_out(name, **functions):
    """The figure that the check of an exercise hands out, with its rings, and whether the work passed."""
    illustration = Illustration()
    verdict = judge(find(name), functions, None, illustration=illustration)
    figure = illustration.figure()
    assert illustration.html()
    return figure, verdict.passed


def labels(figure):
    """The labels of what there is to see."""
    shapes = [shape for panel in figure.panels for shape in panel.shapes if not isinstance(shape, Cells)]
    return {shape.label for shape in shapes if getattr(shape, "label", "") and len(getattr(shape, "points", "x")) > 0}


def count(figure, kind):
    """How many cells of the last panel are of a kind."""
    cells = next(shape for shape in figure.panels[-1].shapes if isinstance(shape, Cells))
    return int((cells.codes == cells.kinds.index(kind)).sum())
