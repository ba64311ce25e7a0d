"""Chapter 10 as a student sees it: a robot on a network, the question before it moves, and a link that is cut."""

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(420)]

PATIENCE_MS = 120_000
BEGIN = """(text) => {
    const content = jupyterapp.shell.currentWidget.content;
    content.activeCellIndex = content.widgets.findIndex((cell) =>
      cell.model.type === 'code' && cell.model.sharedModel.getSource().includes(text));
    content.deselectAll();
    void jupyterapp.commands.execute('notebook:run-cell');
}"""
"""Runs the first cell that contains the text, and does not wait for it."""


def test_a_student_drives_a_robot_on_a_network_until_the_link_is_cut(chapter, picture):
    opened = chapter("10_a_real_robot.ipynb")
    page = opened.page
    page.set_viewport_size({"width": 1500, "height": 900})
    opened.run_to("vera = practice_robot()")
    terminal = page.locator(".ck-terminal", has_text="Wheels and laser are ready")
    terminal.wait_for(timeout=PATIENCE_MS)
    opened.run_to("desk(view, hand)")
    page.wait_for_selector(".jupyterlab-sidecar .ck-viewer[data-messages]", timeout=PATIENCE_MS)
    page.locator(".jupyterlab-sidecar .ck-list", has_text="points").wait_for(state="attached", timeout=PATIENCE_MS)
    picture(page, "real-robot")

    page.evaluate(BEGIN, "%network off\n%network {vera.address}")
    asked = page.locator(".jp-Stdin-input")
    asked.wait_for(timeout=PATIENCE_MS)
    asked.press("Enter")
    page.locator(".jp-OutputArea-output", has_text="Not joined: /pad_cmd_vel publishes").wait_for(timeout=PATIENCE_MS)

    page.evaluate(BEGIN, "link = weak_link(vera.address)")
    page.locator(".jp-OutputArea-output", has_text="[weak link: good]").wait_for(timeout=PATIENCE_MS)
    page.evaluate(BEGIN, 'me = rclpy.create_node("laptop")')
    page.evaluate(BEGIN, "threading.Timer(1.0, link.cut)")
    gone = page.locator(".jupyterlab-sidecar .ck-pad", has_text="is gone")
    gone.wait_for(timeout=PATIENCE_MS)
    picture(page, "link-gone")
