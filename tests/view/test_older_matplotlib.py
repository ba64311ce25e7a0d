"""What programs for Matplotlib 3.5, which robots with Humble have, do in a plot, where a newer Matplotlib lacks it."""

import subprocess
import sys

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib import cm
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from coursekit.processes.session import Session
from coursekit.view import plots


@pytest.fixture(autouse=True)
def session():
    with Session(virtual=True).use() as virtual_session:
        plt.switch_backend("agg")  # not a window of the desktop
        plots.install()
        yield virtual_session
    plt.close("all")


@pytest.fixture
def figure():
    figure = Figure(figsize=(2, 1), dpi=10)
    FigureCanvasAgg(figure)
    return figure


def test_gca_makes_the_axes_that_it_is_told(figure):
    axes = figure.gca(projection="3d")
    assert axes.name == "3d" and figure.gca(projection="3d") is axes and figure.gca() is axes
    assert figure.gca(projection="polar").name == "polar" and len(figure.axes) == 2
    assert figure.gca(polar=True).name == "polar" and len(figure.axes) == 2
    plt.figure()
    assert plt.gca(projection="3d").name == "3d" and plt.gca().name == "3d"


def test_a_line_of_one_point_is_moved_by_two_numbers(figure):
    (line,) = figure.gca().plot([], [])
    line.set_data(1.0, 2.0)
    assert (list(line.get_xdata()), list(line.get_ydata())) == ([1.0], [2.0])
    line.set_data([1, 2], np.array([3, 4]))
    assert list(line.get_ydata()) == [3, 4]


def test_a_grid_is_switched_by_b(figure):
    axes = figure.gca()
    axes.grid(b=True, color="red")
    assert axes.xaxis.get_gridlines()[0].get_visible() and axes.xaxis.get_gridlines()[0].get_color() == "red"
    axes.grid(False)
    assert not axes.xaxis.get_gridlines()[0].get_visible()


def test_colour_maps_are_got_by_name_and_number():
    assert cm.get_cmap("jet", 5).N == 5 and cm.get_cmap("jet")(0.0) == plt.get_cmap("jet")(0.0)
    assert cm.get_cmap(plt.get_cmap("jet")).name == "jet" and cm.get_cmap().name == plt.rcParams["image.cmap"]


def test_a_figure_gives_its_picture(figure):
    figure.canvas.draw()
    picture = np.frombuffer(figure.canvas.tostring_rgb(), np.uint8).reshape(10, 20, 3)
    assert (picture == 255).all()
    figure.canvas.set_window_title("a figure without a window has no title")


def test_what_was_drawn_is_taken_from_the_axes_lists(figure):
    axes = figure.gca()
    first, second, third, _last = (axes.plot([0, 1], [n, n])[0] for n in range(4))
    assert axes.lines.pop(0) is first
    axes.lines.remove(second)
    assert axes.lines[0] is third
    axes.lines.clear()
    assert len(axes.lines) == 0


def test_contours_and_legends_say_their_parts(figure):
    axes = figure.gca()
    contours = axes.contour([[0, 1], [1, 2]])
    for collection in contours.collections:
        collection.remove()
    assert len(axes.collections) == 0
    axes.plot([0], [0], label="scan")
    assert len(axes.legend().legendHandles) == 1


def test_styles_and_stems_are_known_as_in_3_5(figure):
    with plt.style.context("seaborn-whitegrid"):
        assert plt.rcParams["axes.grid"] is True
    assert len(figure.gca().stem([0, 1], [1, 2], use_line_collection=True).get_children()) > 0


PLAIN = """
import matplotlib
matplotlib.use("agg")
import matplotlib.pyplot as plt
import rclpy
plt.style.use("seaborn")
print(plt.figure().gca(projection="3d").name, plt.cm.get_cmap("jet", 3).N)
"""


def test_a_plain_script_does_so_above_its_first_node():
    done = subprocess.run([sys.executable, "-c", PLAIN], capture_output=True, encoding="utf-8")
    assert done.stdout.split() == ["3d", "3"], done.stderr
