"""Figures: what is drawn of numbers that may be anything, and what the page gets to see, hear and show in the dark."""

import math
import re

import numpy as np
import pytest

from coursekit.view.figure import Arrow, Cells, Dots, Figure, Line, Mover, Panel, Words, drawable, view_of
from coursekit.view.figure_html import html
from coursekit.view.figure_style import COLOURS


def plan(*shapes, **options):
    return Figure([Panel(list(shapes), **options)], "a plan")


def test_a_figure_says_what_it_shows_and_needs_neither_script_nor_file():
    markup = html(Figure([Panel([Line([(0, 0), (1, 1)], "own", "a <line>")])], 'a "line" & more'))
    assert 'role="img" aria-label="a &quot;line&quot; &amp; more"' in markup and "a &lt;line&gt;" in markup
    assert "<script" not in markup and "http" not in markup and "url(" not in markup


def test_the_same_figure_is_the_same_text():
    def figure():
        return plan(Cells(np.eye(4, dtype=int), ("free", "wall")), Mover([(0, 0), (3, 0), (3, 3)], "robot1"))

    assert html(figure()) == html(figure())


def test_every_kind_has_a_colour_in_the_light_and_another_in_the_dark():
    markup = html(plan(Line([(0, 0), (1, 1)], "own")))
    for kind, (light, dark) in COLOURS.items():
        assert f"--{kind}:{light}" in markup and markup.count(f"--{kind}:{dark}") >= 2 and light != dark
    assert '[data-jp-theme-light="false"] .ck-drawn,[data-theme="dark"] .ck-drawn' in markup
    assert '@media(prefers-color-scheme:dark){body:not([data-jp-theme-light],[data-theme="light"])' in markup


@pytest.mark.parametrize("paper", [0, 1])
@pytest.mark.parametrize("kind", ["own", "truth", "guess", "bad", "robot4", "ink"])
def test_lines_stand_out_from_free_floor_in_both_themes(kind, paper):
    def light(colour):
        parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
        linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
        return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))

    low, high = sorted(light(COLOURS[colour_kind][paper]) for colour_kind in (kind, "free"))
    assert (high + 0.05) / (low + 0.05) >= 3.0  # as WCAG asks of graphics


def test_points_that_are_none_are_left_out():
    odd = [(0, 0), (math.nan, 1), (1, math.inf), (-math.inf, 0), (1e300, 0), (2, 1)]
    assert drawable(odd) == [(0.0, 0.0), (2.0, 1.0)]
    nowhere = (Arrow(math.nan, 0, 0, "own"), Words(math.inf, 0, "x"), Mover(odd, "own"))
    markup = html(plan(Line(odd, "own"), Dots(odd, "own"), *nowhere))
    assert "nan" not in markup and "inf" not in markup.replace("infinite", "") and "<circle" not in markup


def test_a_ring_that_lies_outside_is_at_the_border_and_one_nowhere_is_not_drawn():
    markup = html(plan(Line([(0, 0), (1, 1)], "own"), rings=[(50, 50), (math.nan, 0)]))
    width = float(re.search(r'<svg width="([\d.]+)"', markup)[1])
    assert markup.count("<circle") == 1 and float(re.search(r'cx="([\d.]+)"', markup)[1]) == width - 10
    assert "what is wrong" in markup


def test_of_many_points_as_many_are_drawn_as_can_be_seen():
    many = [(k, k % 7) for k in range(200_000)]
    assert len(drawable(many)) <= 1502 and drawable(many)[-1] == many[-1]
    assert len(html(plan(Line(many, "own"), Dots(many, "own"), Mover(many, "own")))) < 120_000


def test_the_legend_names_what_is_there_and_nothing_else():
    markup = html(plan(Cells(np.zeros((2, 2), int), ("free", "wall"), ("free", "a wall")), Line([], "own", "a way")))
    assert ">free<" in markup and "a wall" not in markup and "a way" not in markup


def test_nothing_moves_before_the_reader_wants_it():
    markup = html(plan(Mover([(0, 0), (1, 0), (1, 0), (2, 0)], "robot1")))
    assert '<input type="checkbox">' in markup and ":has(input:checked)" in markup and "animation" in markup
    assert "checkbox" not in html(plan(Line([(0, 0), (1, 1)], "own")))


def test_one_who_waits_waits_and_all_arrive_at_their_own_time():
    markup = html(plan(Mover([(0, 0), (1, 0), (1, 0), (1, 0), (2, 0)], "robot1"), Mover([(0, 1)] * 2, "robot2")))
    stops = re.search(r"@keyframes \w+\{(.*?\})\}", markup)[1]
    assert [float(percent) for percent in re.findall(r"([\d.]+)%", stops)] == pytest.approx([0, 23.75, 71.25, 95, 100])


@pytest.mark.parametrize("panel", [Panel(), Panel(axes=("x", "y")), Panel([Line([(1, 1), (1, 1)], "own")])])
def test_a_panel_with_nothing_to_see_is_a_panel_all_the_same(panel):
    left, right, low, high = view_of(panel)
    assert left < right and low < high and "<svg" in html(Figure([panel], "nothing"))


def test_rows_that_grow_downwards_are_drawn_downwards():
    cells = Cells(np.array([[1, 0], [0, 0]]), ("free", "wall"))
    top = html(plan(cells, down=True)).partition('class="fill wall"')[2]
    low = html(plan(cells)).partition('class="fill wall"')[2]
    assert re.search(r'd="M0 0H', top) and re.search(r'd="M0 340H', low)
