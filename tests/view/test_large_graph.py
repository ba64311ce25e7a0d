"""A graph of hundreds of nodes is drawn by what takes a second for it, not a minute."""

import cv2
import numpy as np
from matplotlib.backends import backend_agg

from coursekit.view.drawing_fast import MOST_POINTS
from coursekit.view.graph import GraphPicture

from .graphs import empty, node


def large(count):
    graph = empty()
    for number in range(count):
        node(graph, f"/node_{number}", publishes=(f"/t{number}",), hears=(f"/t{number - 1}",) if number % 10 else ())
    return GraphPicture(graph)


def image_of(picture):
    return cv2.imdecode(np.frombuffer(picture.png(), np.uint8), cv2.IMREAD_COLOR)


def test_three_hundred_nodes_are_drawn_without_matplotlib(monkeypatch):
    monkeypatch.setattr(backend_agg, "FigureCanvasAgg", None)
    picture = large(300)
    image = image_of(picture)
    drawing = picture.drawing()
    assert image.shape[0] * image.shape[1] <= MOST_POINTS * 1.01
    assert abs(image.shape[1] / image.shape[0] - drawing.width / drawing.height) < 0.02
    assert len(np.unique(image.reshape(-1, 3), axis=0)) > 20  # boxes, lines and letters in their colours


def test_a_small_graph_keeps_its_fine_letters(monkeypatch):
    monkeypatch.setattr("coursekit.view.drawing_fast.png", None)
    image_of(large(12))
