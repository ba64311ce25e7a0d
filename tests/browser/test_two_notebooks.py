"""Two chapters are open, as is usual: no import cell is needed, and terminals follow the chapter that was run last."""

import time

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

RUN = """async (text) => {
    const { content } = jupyterapp.shell.currentWidget;
    content.activeCellIndex = content.widgets.findIndex((one) => one.model.sharedModel.getSource().startsWith(text));
    content.deselectAll();
    await jupyterapp.commands.execute('notebook:run-cell');
}"""
RESTART = "async () => { await jupyterapp.shell.currentWidget.sessionContext.session.kernel.restart(); }"
TERMINAL = "async () => { await jupyterapp.commands.execute('terminal:create-new'); }"
TO_NOTEBOOK = "jupyterapp.shell.activateById([...jupyterapp.shell.widgets('main')].find((one) => one.sessionContext).id)"
TURTLE = "%ros2 run turtlesim turtlesim_node &"


def typed(page, folder, line, wanted):
    """Type a line into the terminal until the file `said.txt` holds what is wanted."""
    file = next(folder.glob("course"), folder) / "said.txt"
    give_up = time.monotonic() + 60
    while time.monotonic() < give_up:
        file.unlink(missing_ok=True)
        page.keyboard.type(f"{line} > said.txt\n")
        for _ in range(40):
            page.wait_for_timeout(100)
            if file.exists() and file.read_text().split() == wanted:
                return
    raise AssertionError(f"{line}: {file.read_text() if file.exists() else 'nothing'}, not {wanted}")


def test_terminals_follow_the_chapter_in_which_a_cell_was_run_last(chapter, picture):
    zero = chapter("00_start_here.ipynb")
    picture(zero.page, "chapter-0-first-words")
    zero.page.evaluate(RUN, TURTLE)
    zero.eventually("print(terminal('turtlesim_node').state)", "running")
    first_nodes = chapter("01_first_nodes.ipynb")
    first_nodes.ask("%ros2 run demo_nodes_py talker &")
    first_nodes.eventually("print(terminal('talker').state)", "running")

    page = zero.page
    page.evaluate(TERMINAL)
    page.locator(".jp-Terminal .xterm").wait_for(timeout=60_000)
    page.wait_for_timeout(2000)
    page.locator(".jp-Terminal .xterm").click()
    folder = zero.lab.folder
    typed(page, folder, "ros2 node list", ["/talker"])
    page.keyboard.type("ros2 topic list\n")
    page.wait_for_timeout(3000)
    picture(page, "terminal-says-which")
    first_nodes.ask("reset()")
    typed(page, folder, "ros2 node list", [])
    page.evaluate(TO_NOTEBOOK)
    page.wait_for_timeout(500)
    page.evaluate(RUN, "wait(0.5)")
    page.locator(".jp-OutputArea-output .ck-turtle").first.wait_for(timeout=60_000)
    page.evaluate(TERMINAL)
    page.wait_for_timeout(3000)
    page.locator(".jp-Terminal:visible .xterm").last.click()
    typed(page, folder, "ros2 node list", ["/turtlesim"])


def test_after_a_restart_the_magics_and_names_are_there_without_an_import(chapter):
    opened = chapter("00_start_here.ipynb")
    opened.page.evaluate(RESTART)
    opened.eventually("print(callable(graph) and callable(check))", "True", patience=60)
    opened.page.evaluate(RUN, TURTLE)
    opened.eventually("print(terminal('turtlesim_node').state)", "running")
