"""The desk beside the notebook: one at a time, through reloads, restarts, and after the student closed it."""

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

CELLS = ("from coursekit.lab import *", "view = viewer()\ndesk(view, pad())", "'below'")
TABS = "() => document.querySelectorAll('.lm-DockPanel .lm-TabBar-tabLabel').length"
NOTEBOOK = "() => [...jupyterapp.shell.widgets('main')].find((one) => one.sessionContext)"
ON_DESK = "document.querySelectorAll('.jupyterlab-sidecar :is(.ck-graph, .ck-pad)')"
OPENED = "document.dispatchEvent(new CustomEvent('coursekit-desk', { detail: { el: document.body, closed() {} } }))"
ON_ONE_LINE = """() => [...document.querySelector('.jp-NotebookPanel-toolbar').children].every((item) =>
    item.offsetTop + item.offsetHeight <= item.parentElement.clientHeight + 2)"""
LIVE = ".jupyterlab-sidecar .ck-viewer[data-messages]"


@pytest.fixture
def opened(notebook):
    """A notebook with a desk, at the size of a small laptop."""
    open_notebook = notebook(*CELLS, width=1366, height=768)
    open_notebook.run()
    open_notebook.page.wait_for_selector(LIVE)
    return open_notebook


def desks(page):
    return [name for name in page.locator(".lm-DockPanel .lm-TabBar-tabLabel").all_inner_texts() if name.startswith("Desk")]


def in_notebook(page, command):
    """Run a command of JupyterLab's with the notebook in front."""
    page.evaluate(f"() => {{ jupyterapp.shell.activateById(({NOTEBOOK})().id); }}")
    page.evaluate(f"void jupyterapp.commands.execute('notebook:{command}')")


def test_panels_stand_beside_the_notebook_and_fill_the_desk(opened, picture):
    page = opened.page
    assert desks(page) == ["Desk: test_panels_stand_beside_the_notebook_and_fill_the_desk"]
    assert "On the desk, beside this notebook: viewer, pad" in opened.text()
    sizes = {name: page.locator(f".jupyterlab-sidecar {name}").bounding_box() for name in (".ck-viewer", ".ck-pad")}
    assert sizes[".ck-viewer"]["height"] > 380, "it takes what the pad leaves"
    assert sizes[".ck-pad"]["y"] + sizes[".ck-pad"]["height"] <= 768
    picture(page, "desk")


def test_the_notebooks_toolbar_stays_on_one_line(opened):
    page = opened.page
    page.evaluate(f"() => {{ ({NOTEBOOK})().toolbar._resizer.invoke = async () => {{}}; }}")  # as JupyterLab at times
    page.set_viewport_size({"width": 800, "height": 768})
    page.wait_for_function(f"() => !({ON_ONE_LINE})()")
    page.evaluate(f"() => {{ delete ({NOTEBOOK})().toolbar._resizer.invoke; }}")
    page.evaluate(OPENED)
    page.wait_for_function(ON_ONE_LINE)


def test_the_toolbar_is_looked_at_again_where_the_desk_takes_long_to_open(opened):
    page = opened.page
    page.evaluate(f"""() => {{
        const {{ toolbar }} = ({NOTEBOOK})(), hide = toolbar.hide.bind(toolbar);
        toolbar.hide = () => {{ hide(); window.fitted = true; }};
    }}""")
    page.evaluate(OPENED)
    page.wait_for_function("() => window.fitted")
    page.evaluate(f"() => {{ ({NOTEBOOK})().toolbar._resizer.invoke = async () => {{}}; }}")
    page.set_viewport_size({"width": 800, "height": 768})
    page.wait_for_function(f"() => !({ON_ONE_LINE})()")
    page.evaluate(f"() => {{ delete ({NOTEBOOK})().toolbar._resizer.invoke; }}")
    page.wait_for_function(ON_ONE_LINE, timeout=20_000)


def test_a_narrow_desk_cuts_nothing_off_the_pad(opened):
    page = opened.page
    page.set_viewport_size({"width": 700, "height": 900})
    over = """() => {
        const pad = document.querySelector('.jupyterlab-sidecar .ck-pad'), end = pad.getBoundingClientRect().right;
        return [...pad.querySelectorAll('*')].every((one) => one.getBoundingClientRect().right <= end + 1);
    }"""
    page.wait_for_function(over, timeout=20_000)


def test_the_list_of_displays_folds_where_there_is_little_room(opened):
    page = opened.page
    listed, button = page.locator(".jupyterlab-sidecar .ck-list"), page.get_by_role("button", name="Displays")
    assert not listed.is_visible() and button.get_attribute("aria-expanded") == "false"
    button.click()
    assert listed.is_visible()


def test_a_reload_and_a_restart_leave_one_desk_that_lives(opened):
    opened.load_again()
    opened.page.wait_for_selector(LIVE)
    assert len(desks(opened.page)) == 1
    opened.page.evaluate(f"async () => {{ await ({NOTEBOOK})().sessionContext.session.kernel.restart(); }}")
    opened.page.wait_for_selector(".jupyterlab-sidecar .ck-veil", state="attached")
    opened._wait_until_it_answers()
    in_notebook(opened.page, "run-all-cells")
    opened.page.wait_for_selector(".jupyterlab-sidecar .ck-veil", state="detached")
    opened.page.wait_for_selector(LIVE)
    assert len(desks(opened.page)) == 1


def test_a_desk_that_was_closed_opens_again_with_its_cell(opened):
    page = opened.page
    page.get_by_title("Close Desk:").click()
    page.wait_for_function(f"() => ({TABS})() === 1")
    page.locator(".jp-NotebookPanel .jp-CodeCell").nth(1).click()
    in_notebook(page, "run-cell")
    page.wait_for_selector(LIVE)
    assert len(desks(page)) == 1


def test_the_wheel_scrolls_the_page_until_the_picture_is_clicked(notebook):
    opened = notebook(CELLS[0], "view = viewer()\nview")
    opened.run()
    opened.page.wait_for_selector(".ck-viewer[data-messages]")
    place = "() => document.querySelector('.ck-viewer').viewer.view.camera.position.length()"
    stage = opened.page.locator(".ck-viewer .ck-stage")
    before = opened.page.evaluate(place)
    stage.hover()
    opened.page.mouse.wheel(0, 400)
    opened.page.wait_for_selector(".ck-wheel.ck-seen")
    assert opened.page.evaluate(place) == before
    stage.click()
    opened.page.mouse.wheel(0, 400)
    opened.page.wait_for_function(f"() => ({place})() !== {before}")


def test_the_button_of_a_panel_puts_it_on_the_desk(notebook, picture):
    opened = notebook(CELLS[0], "graph(live=True)", "pad()", "terminals()", width=1366, height=768)
    opened.run()
    page = opened.page
    page.wait_for_selector(".jp-NotebookPanel .ck-pad .ck-to-desk")
    picture(page, "to-desk")
    for count, panel in enumerate((".ck-graph", ".ck-pad"), 1):
        page.locator(f".jp-NotebookPanel {panel} .ck-to-desk").click()
        page.wait_for_selector(f".jupyterlab-sidecar {panel}")
        assert page.evaluate(f"() => {ON_DESK}.length") == count
    assert len(desks(page)) == 1
    assert not page.locator(".jupyterlab-sidecar .ck-to-desk").first.is_visible()
    page.locator(".jp-NotebookPanel .ck-graph .ck-to-desk").click()
    page.wait_for_function(f"() => {ON_DESK}[0]?.classList.contains('ck-pad')")  # what was asked for last is the lowest
    assert page.evaluate(f"() => {ON_DESK}.length") == 2
    picture(page, "on-the-desk")
