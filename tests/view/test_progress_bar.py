"""A bar comes for long work only, tells how far it is, and goes."""

import threading
from types import SimpleNamespace

import pytest

from coursekit.view import progress_bar
from coursekit.view.progress_bar import ProgressBar


class Page:
    """Takes the place of the notebook's page: what it was told to show, one after the other."""

    def __init__(self):
        self.told, self.drawn = [], threading.Event()

    def update(self, shown):
        self.told.append(shown.data)
        self.drawn.set()

    def display(self, shown, display_id):
        self.update(shown)
        return self


@pytest.fixture
def page(monkeypatch):
    own_page = Page()
    monkeypatch.setattr("IPython.display.display", own_page.display)
    monkeypatch.setattr(progress_bar, "_has_a_page", lambda: True)
    return own_page


def test_long_work_has_a_bar_that_goes(page, monkeypatch):
    monkeypatch.setattr(progress_bar, "PATIENCE_SECONDS", 0.0)
    with ProgressBar("Driving <home>") as bar:
        bar.share = 0.25
        assert page.drawn.wait(10)
    assert "Driving &lt;home&gt;" in page.told[0] and "<progress" in page.told[0]
    assert page.told[-1] == "", "nothing is left of it"


def test_short_work_has_none(page):
    with ProgressBar("A moment"):
        pass
    assert page.told == []


def test_it_goes_also_when_the_work_fails(page, monkeypatch):
    monkeypatch.setattr(progress_bar, "PATIENCE_SECONDS", 0.0)
    with pytest.raises(ValueError), ProgressBar("Driving"):
        assert page.drawn.wait(10)
        raise ValueError
    assert page.told[-1] == ""


def test_how_far_it_is():
    bar = ProgressBar("Driving")
    assert "value" not in bar.html().replace("vertical", "")
    bar.share = 0.25
    assert 'value="0.250"' in bar.html()
    bar.share = 7.0
    assert 'value="1.000"' in bar.html()


@pytest.mark.parametrize("kernel", [None, SimpleNamespace()], ids=["no kernel", "grading"])
def test_without_a_page_there_is_none(kernel, monkeypatch):
    monkeypatch.setattr("IPython.get_ipython", lambda: SimpleNamespace(kernel=kernel))
    assert not progress_bar._has_a_page()


def test_work_that_lasts_says_what_to_do_once_it_is_late(monkeypatch):
    bar = ProgressBar("Trying out", late="Stop it with <b>")
    assert "Stop it" not in bar.html()
    monkeypatch.setattr(progress_bar, "LATE_SECONDS", 0.0)
    assert "Stop it with &lt;b&gt;" in bar.html()
    assert "<br>" not in ProgressBar("Driving").html()
