"""Views whose kernel or session has gone: a still and what to do, never an error or a pad that looks alive."""

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(240)]

CELLS = ("%ros2 run turtlesim turtlesim_node &", "pad()", "turtlesim_window()", "view = viewer(displays=['Grid'])\nview")
RESTART = "async () => { await jupyterapp.shell.currentWidget.sessionContext.session.kernel.restart(); }"
SAVE = "async () => { await jupyterapp.commands.execute('docmanager:save'); }"
RUN_LAST = """async () => {
    const { content } = jupyterapp.shell.currentWidget;
    content.activeCellIndex = content.widgets.length - 1;
    content.deselectAll();
    await jupyterapp.commands.execute('notebook:run-cell');
}"""


def opened_with_views(notebook):
    """A page on which all of CELLS show, without an import cell."""
    opened = notebook(*CELLS, height=2400)
    opened.run()
    opened.page.wait_for_function("() => document.querySelector('.ck-viewer')?.dataset.messages", timeout=30_000)
    opened.page.evaluate(SAVE)
    return opened


def test_after_a_restart_every_view_says_so_and_takes_no_input(notebook, picture):
    opened = opened_with_views(notebook)
    page = opened.page
    page.evaluate(RESTART)
    page.wait_for_function("() => document.querySelectorAll('.ck-veil').length === 4", timeout=30_000)
    assert page.locator(".ck-pad").evaluate("(one) => one.closest('[inert]') !== null")
    said = {"The kernel was restarted. Run its cell again to have it live."}
    assert set(page.locator(".ck-veil").all_inner_texts()) == said
    picture(page, "gone-restarted")
    page.evaluate(RUN_LAST)
    page.wait_for_function("() => document.querySelectorAll('.ck-veil').length === 3", timeout=60_000)


def test_after_a_restart_terminals_stand_side_by_side_as_they_did(notebook, picture):
    opened = notebook("%ros2 run demo_nodes_py talker &", "%ros2 run demo_nodes_py listener &", "terminals()")
    opened.run()
    page, places = opened.page, "all => all.map(one => one.getBoundingClientRect()).map(({ left, top }) => [left, top])"
    page.wait_for_function("() => document.querySelectorAll('.widget-gridbox .ck-terminal').length === 2", timeout=30_000)
    page.evaluate(RESTART)
    page.wait_for_function("() => document.querySelectorAll('.widget-gridbox .ck-veil').length === 2", timeout=30_000)
    (left, top), (right, beside) = page.locator(".widget-gridbox .ck-veil").evaluate_all(places)
    assert left < right and top == beside
    picture(page, "gone-terminals")


def test_a_page_that_is_opened_with_a_new_kernel_shows_stills(notebook, picture):
    opened = opened_with_views(notebook)
    page = opened.page
    page.evaluate(RESTART)
    page.wait_for_timeout(1000)
    page.reload()
    page.wait_for_function("() => document.querySelectorAll('.ck-still').length === 4", timeout=60_000)
    page.wait_for_timeout(1000)
    assert "model not found" not in page.locator(".jp-Notebook").inner_text()
    assert page.locator(".ck-still img").count() >= 1
    assert "[pad /cmd_vel" in page.locator(".ck-still").nth(1).inner_text()
    picture(page, "gone-reopened")


def test_reset_leaves_the_viewer_s_picture_also_for_a_page_that_is_loaded_again(notebook, picture):
    opened = opened_with_views(notebook)
    page = opened.page
    opened.ask("reset()")
    veil = page.locator(".jp-OutputArea-output:has(.ck-viewer) .ck-veil")
    veil.wait_for(timeout=20_000)
    assert veil.inner_text() == "It ended with reset(). Run its cell again to have it live."
    picture(page, "gone-reset")
    page.reload()
    page.locator(".ck-still img").wait_for(timeout=60_000)
    assert page.locator(".ck-veil").count() == 1
    picture(page, "gone-reset-reloaded")
