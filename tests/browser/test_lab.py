"""Terminals, graph and panels in a real JupyterLab."""

import json

import pytest

from coursekit.lab.terminal import UPDATE_SECONDS
from tests.browser.page_scripts import BROKEN_WORDS
from tests.browser.pages import set_theme

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(240)]

LAB = "from coursekit.lab import *"
TALKER = "%ros2 run demo_nodes_py talker &"
LISTENER = "%ros2 run demo_nodes_py listener &"
SERVER = "%ros2 run demo_nodes_py add_two_ints_server &"


def terminal(page, title, last=True):
    """The panel of that title: the one in the newest output."""
    terminals = page.locator(".ck-terminal").filter(has=page.locator(f'.ck-title:text-is("{title}")'))
    return terminals.last if last else terminals.first


def reads(page, selector, text, timeout=30_000):
    """Wait until the newest element that matches holds this text."""
    page.wait_for_function(
        "([selector, text]) => [...document.querySelectorAll(selector)].some((one) => one.textContent.includes(text))",
        arg=[selector, text],
        timeout=timeout,
    )


def test_talker_and_listener_speak_stop_and_start_again(notebook, picture):
    opened = notebook(LAB, TALKER, LISTENER, 'terminals("talker", "listener")')
    opened.run()
    page = opened.page
    reads(page, ".ck-screen", "I heard: [Hello World: 2]")
    talker = terminal(page, "talker")
    talker.scroll_into_view_if_needed()
    picture(page.locator(".jp-CodeCell").last, "terminals")

    talker.locator(".ck-stop").click()
    talker.locator(".ck-again").wait_for(timeout=20_000)
    assert talker.get_attribute("data-state") in ("ok", "failed")
    opened.eventually("print(terminal('talker').process.exit_code is None)", "False")

    talker.locator(".ck-again").click()
    page.wait_for_function(
        "() => [...document.querySelectorAll('.ck-terminal[data-state=\"running\"]')].length === 4", timeout=20_000
    )
    reads(page, ".ck-screen", 'Publishing: "Hello World: 1"')
    opened.eventually("print(terminal('talker').state)", "running")


def test_a_page_that_is_loaded_again_shows_what_was_printed(notebook):
    opened = notebook(LAB, TALKER)
    opened.run()
    page = opened.page
    reads(page, ".ck-screen", "Hello World: 2")
    page.evaluate("window.jupyterapp.commands.execute('docmanager:save')")
    page.wait_for_timeout(1000)
    page.reload()
    first = 'Publishing: "Hello World: 1"'  # with its end, for the tenth begins alike
    reads(page, ".ck-screen", first, 60_000)
    text = page.locator(".ck-screen").first.inner_text()
    assert text.count(first) == 1


def test_a_thousand_lines_a_second_do_not_flood_the_page(notebook):
    flood = """
import time
took = []
def main():
    began = time.monotonic()
    for number in range(3000):
        print(f"\\x1b[3{number % 8}mline {number}\\x1b[0m")
        time.sleep(0.001)
    took.append(time.monotonic() - began)
from coursekit.processes.session import current
from coursekit.lab.terminal import Terminal
shown = Terminal(current().start(main, name="flood"), "flood")
sent = []
_send = shown.send
shown.send = lambda message, buffers=None: (sent.append(len(message["text"])), _send(message))
"""
    opened = notebook(LAB + flood, "shown")
    opened.run()
    page = opened.page
    reads(page, ".ck-screen", "line 2999")
    messages, largest, seconds = json.loads(opened.ask("print([len(sent), max(sent), took[0]])"))
    assert messages <= seconds / UPDATE_SECONDS + 5, "besides these updates: the first one, and that of its end"
    assert largest < 100_000
    assert page.locator(".ck-screen").last.evaluate("(one) => one.childElementCount") <= 502
    span = page.locator(".ck-screen span").last
    assert span.evaluate("(one) => one.style.color") != "" and "[3" not in span.inner_text()


def test_the_graph_changes_as_nodes_come_and_go(notebook, picture):
    opened = notebook(LAB, TALKER, "graph(live=True)", LISTENER)
    opened.run()
    page = opened.page
    page.locator('.ck-graph [data-name="/listener"]').wait_for(timeout=20_000)
    page.locator('.ck-graph [data-name="/chatter"]').first.click()
    reads(page, ".ck-graph .ck-details", "Subscription count: 1")
    picture(page.locator(".ck-graph"), "graph")
    terminal(page, "listener").locator(".ck-stop").click()
    page.locator('.ck-graph [data-name="/listener"]').wait_for(state="detached", timeout=20_000)
    page.locator(".ck-graph select").select_option("nodes")
    page.locator('.ck-graph [data-name="/chatter"]').wait_for(state="detached", timeout=20_000)


def test_a_service_is_called_from_its_panel(notebook, picture):
    opened = notebook(LAB, SERVER, "service_caller('/add_two_ints')")
    opened.run()
    page = opened.page
    page.locator('.ck-services option[value="/add_two_ints"]').wait_for(state="attached", timeout=20_000)
    fields = page.locator(".ck-services .ck-field input")
    fields.nth(0).fill("20")
    fields.nth(1).fill("22")
    page.locator(".ck-services .ck-main").click()
    reads(page, ".ck-services .ck-answer", "sum: 42")
    picture(page.locator(".ck-services"), "services")
    fields.nth(0).fill("many")
    page.locator(".ck-services .ck-main").click()
    reads(page, ".ck-services .ck-answer", "'many' is not a whole number")


def test_parameters_topics_and_log_are_seen_and_set(notebook, picture):
    opened = notebook(
        LAB,
        "%ros2 run turtlesim turtlesim_node &",
        "parameter_panel('/turtlesim')",
        "topics = topic_panel('/turtle1/pose')\ntopics",
        "log_console()",
        height=1600,
    )
    opened.run()
    page = opened.page
    row = page.locator(".ck-parameters .ck-row").filter(has_text="background_r")
    assert page.locator(".ck-parameters").evaluate(BROKEN_WORDS) == [], "long names go on after a dot"
    row.locator('input[type="number"]').fill("200")
    row.locator('input[type="number"]').press("Enter")
    reads(page, ".ck-parameters .ck-note", "set")
    reads(page, ".ck-topics td", "Hz")
    other = page.locator(".ck-topics tr").filter(has_text="/turtle1/color_sensor")
    other.locator("input").hover()
    page.mouse.down()
    opened.ask("topics._push()")  # new numbers come while the tick is pressed
    page.mouse.up()
    other.filter(has_text="Hz").wait_for(timeout=20_000)
    reads(page, ".ck-log .ck-said", "Spawning turtle")
    row.locator('input[type="number"]').fill("999")
    row.locator('input[type="number"]').press("Enter")
    page.locator(".ck-parameters .ck-error").first.wait_for(timeout=20_000)
    assert row.locator('input[type="number"]').input_value() == "200"
    for name in ("parameters", "topics", "log"):
        picture(page.locator(f".ck-{name}"), name)
    set_theme(page, light=False)
    page.wait_for_timeout(500)
    picture(page.locator(".jp-NotebookPanel"), "panels_dark")
    set_theme(page, light=True)
