"""JupyterLab on loopback and a headless Chromium that looks at it; skipped, loudly, without Chromium."""

import contextlib
import os
import shutil
import sys
import warnings
from pathlib import Path

import pytest

from tests.browser.pages import Notebook, close, lab_in, open_page, serving, write_notebook, write_settings


def chromium():
    """The browser's file, None where there is none."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


_OPENED: pytest.StashKey[list[Notebook]] = pytest.StashKey()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item, call):
    """A failure tells what stood on the pages."""
    report = yield
    if call.when == "call" and report.failed:
        for opened in item.stash.get(_OPENED, []):
            with contextlib.suppress(Exception):
                report.sections.append((opened.name, opened.report()))
    return report


@pytest.fixture(scope="session")
def sync_playwright():
    """Playwright, and Chromium's file."""
    playwright = pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
    path = chromium()
    if path is None:
        warnings.warn("No Chromium: the browser tests did NOT run (apt-get install chromium)", stacklevel=1)
        pytest.skip("no Chromium: apt-get install --no-install-recommends chromium")
    return playwright.sync_playwright, path


@pytest.fixture(scope="module")
def browser(sync_playwright):
    """A headless Chromium, whose pages share what they have loaded and compiled of JupyterLab.

    It is not kept for longer, because Playwright's loop counts as the thread's running one.
    """
    start, path = sync_playwright
    with start() as driver:
        opened = driver.chromium.launch(executable_path=path, args=["--no-sandbox"])
        yield opened.new_context()
        opened.close()


@pytest.fixture(scope="session")
def server(tmp_path_factory, sync_playwright):
    """JupyterLab, with a ROS domain of its own: one for all files of tests."""
    with lab_in(tmp_path_factory.mktemp("lab"), 100 + os.getpid() % 100) as served:
        yield served


@pytest.fixture(scope="module")
def lab(server, browser):
    """The same with settings that no other file of tests has changed."""
    write_settings(server.folder)
    return server


@pytest.fixture(scope="module")
def course(tmp_path_factory, browser):
    """`coursekit lab` in an empty folder, as a student starts it."""
    folder = tmp_path_factory.mktemp("student")
    env = {key: value for key, value in os.environ.items() if not key.startswith(("COURSEKIT_", "ROS_", "AMENT_"))}
    env |= {"ROS_DOMAIN_ID": str(200 + os.getpid() % 32), "SHELL": "/bin/bash"}
    command = [str(Path(sys.executable).with_name("coursekit")), "lab", "--no-browser", "--"]
    with serving(folder, command, env) as served:
        yield served


@pytest.fixture
def notebook(lab, browser, request):
    """notebook("cell 1", "cell 2", ...) writes a notebook, opens it and waits for its kernel."""
    pages, opened = [], request.node.stash.setdefault(_OPENED, [])

    def open_(*cells: str, width: int = 1100, height: int = 1000) -> Notebook:
        name = f"{request.node.name}.ipynb"
        write_notebook(lab.folder / name, cells)
        pages.append(open_page(browser, width, height))
        opened.append(Notebook(pages[-1], lab, name))
        return opened[-1]

    yield open_
    for page in pages:
        close(page)


@pytest.fixture
def chapter(course, browser, request):
    """chapter("01_first_nodes.ipynb") opens a chapter of the student's copy."""
    pages, opened = [], request.node.stash.setdefault(_OPENED, [])

    def open_(name: str) -> Notebook:
        pages.append(open_page(browser, 1280, 900))
        opened.append(Notebook(pages[-1], course, name))
        return opened[-1]

    yield open_
    for page in pages:
        close(page)


@pytest.fixture
def picture(request):
    """picture(locator, "name") keeps a screenshot where COURSEKIT_PICTURES says, if it says so."""

    def keep(locator, name: str) -> None:
        folder = os.environ.get("COURSEKIT_PICTURES")
        if folder:
            Path(folder).mkdir(parents=True, exist_ok=True)
            locator.screenshot(path=str(Path(folder) / f"{name}.png"))

    return keep
