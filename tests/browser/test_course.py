"""The course as a student opens it: `coursekit lab`, chapter 1, the turtle, a terminal; then chapter 5."""

import os
import re
import secrets
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(420)]
PATIENCE_MS = 120_000
SCREEN = """(wanted) => {
    const buffer = jupyterapp.shell.currentWidget?.content?._term?.buffer.active;
    const lines = [...Array(buffer?.length ?? 0).keys()].map((i) => buffer.getLine(i)?.translateToString(true) ?? '');
    return lines.some((line) => line.trim() && line.includes(wanted));
}"""
"""Whether a line of the terminal in front contains a text."""


@pytest.fixture(scope="module")
def course(tmp_path_factory, browser):
    """`coursekit lab` in an empty folder; the address it answers at."""
    folder = tmp_path_factory.mktemp("student")
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    token = secrets.token_hex(16)
    env = {key: value for key, value in os.environ.items() if not key.startswith(("COURSEKIT_", "ROS_", "AMENT_"))}
    env |= {"ROS_DOMAIN_ID": "211", "COURSEKIT_RUNTIME_DIR": str(folder / "run"), "SHELL": "/bin/bash"}
    env |= {name: str(folder / name.lower()) for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR")}
    command = [str(Path(sys.executable).with_name("coursekit")), "lab", "--no-browser", "--"]
    command += [f"--ServerApp.port={port}", f"--IdentityProvider.token={token}", "--expose-app-in-browser"]
    with open(folder / "server.log", "w") as log:
        server = subprocess.Popen(command, cwd=folder, env=env, stdout=log, stderr=log)
        try:
            _wait_for(f"http://127.0.0.1:{port}/api?token={token}", server)
            yield lambda path: f"http://127.0.0.1:{port}/lab/tree/{path}?token={token}&reset"
        finally:
            server.terminate()
            server.wait(30)


def _wait_for(url, server):
    give_up = time.monotonic() + 90
    while time.monotonic() < give_up and server.poll() is None:
        try:
            urllib.request.urlopen(url, timeout=2).close()
            return
        except OSError:
            time.sleep(0.2)
    raise RuntimeError("coursekit lab did not start")


class Chapter:
    """An open chapter."""

    def __init__(self, page, address):
        self.page = page
        page.goto(address, timeout=PATIENCE_MS)
        page.wait_for_selector(".jp-NotebookPanel .jp-CodeCell", timeout=PATIENCE_MS)
        page.wait_for_function(
            "() => jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel?.connectionStatus === 'connected'",
            timeout=PATIENCE_MS,
        )
        page.evaluate("async () => { await jupyterapp.shell.currentWidget.sessionContext.session.kernel.info; }")

    def run_to(self, text):
        """Run the cells one after the other up to the first that contains `text`, as Shift+Enter does."""
        return self.page.evaluate(
            """async (text) => {
                const panel = jupyterapp.shell.currentWidget;
                const cells = panel.content.widgets;
                const until = cells.findIndex((cell, i) =>
                  cell.model.type === 'code' && cell.model.sharedModel.getSource().includes(text));
                for (let i = panel.courseRun ?? 0; i <= until; i++) {
                    panel.content.activeCellIndex = i;
                    panel.content.deselectAll();
                    await jupyterapp.commands.execute('notebook:run-cell');
                }
                panel.courseRun = until + 1;
                return until;
            }""",
            text,
        )

    def show(self, locator):
        """Bring a part of the page into view."""
        locator.scroll_into_view_if_needed(timeout=PATIENCE_MS)
        return locator

    def close(self):
        self.page.evaluate("async () => { await jupyterapp.shell.currentWidget.sessionContext.shutdown(); }")
        self.page.close()


def heading(chapter):
    """How far the turtle has come, as its window says."""
    text = chapter.page.locator(".ck-turtle .ck-pose").first.inner_text()
    return [float(number) for number in re.findall(r"-?\d+\.\d+", text)]


def test_chapter_1_runs_and_the_turtle_is_driven_by_keys(course, browser, picture):
    chapter = Chapter(browser.new_page(viewport={"width": 1280, "height": 900}), course("01_first_nodes.ipynb"))
    page = chapter.page
    assert chapter.run_to("graph()") > 0
    page.locator(".ck-terminal .ck-screen", has_text="I heard: [Hello World: 1]").wait_for(timeout=PATIENCE_MS)
    page.wait_for_timeout(500)
    picture(page, "chapter1")

    chapter.run_to("turtlesim_window()")
    canvas = chapter.show(page.locator(".ck-turtle canvas").first)
    page.locator('.ck-turtle[data-state="running"]').first.wait_for(timeout=PATIENCE_MS)
    canvas.click(position={"x": 40, "y": 40})
    before = heading(chapter)
    page.keyboard.down("ArrowUp")
    page.wait_for_timeout(1200)
    page.keyboard.up("ArrowUp")
    page.wait_for_timeout(400)
    stopped = heading(chapter)
    page.wait_for_timeout(500)
    assert stopped != before, "the turtle did not move"
    assert heading(chapter) == stopped, "the turtle did not stop when the key was let go"
    picture(page, "turtle")

    opened = page.evaluate(
        "async () => { const made = await jupyterapp.commands.execute('terminal:create-new'); return made.id; }"
    )
    assert opened
    page.locator(".jp-Terminal .xterm-helper-textarea").wait_for(state="attached", timeout=PATIENCE_MS)
    page.wait_for_function(SCREEN, arg="", timeout=60_000)
    page.locator(".jp-Terminal .xterm-screen").click()
    page.keyboard.type("ros2 topic echo /turtle1/pose --once\n")
    page.wait_for_function(SCREEN, arg="linear_velocity:", timeout=60_000)
    page.wait_for_timeout(500)
    picture(page, "terminal")
    page.evaluate("() => jupyterapp.shell.currentWidget.dispose()")
    page.locator(".jp-NotebookPanel").first.wait_for()

    stop = page.locator(".ck-terminal", has_text="turtlesim_node").locator(".ck-stop").first
    chapter.show(stop).click()
    page.locator('.ck-terminal:not([data-state="running"])', has_text="turtlesim_node").first.wait_for(timeout=30_000)
    chapter.close()


def test_chapter_5_runs_to_its_camera(course, browser, picture):
    chapter = Chapter(
        browser.new_page(viewport={"width": 1280, "height": 900}), course("05_parameters_launch_images.ipynb")
    )
    assert chapter.run_to("image_view(") > 0
    image = chapter.show(chapter.page.locator(".ck-picture img").first)
    image.wait_for(timeout=PATIENCE_MS)
    chapter.page.wait_for_timeout(1500)
    picture(chapter.page, "chapter5")
    errors = chapter.page.locator(".jp-OutputArea-output[data-mime-type='application/vnd.jupyter.stderr']").count()
    assert errors == 0
    chapter.close()
