"""The panels pass axe's audit: contrast, names of controls, roles; in the light and in the dark."""

import pytest

from tests.browser.pages import set_theme

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

LAB = "from coursekit.lab import *"
START = """%ros2 run turtlesim turtlesim_node &
%ros2 launch gazebo_ros gazebo.launch.py world:=office &"""
PANELS = {
    "viewer": "viewer(displays=['Grid', 'TF', 'LaserScan /nothing'])",
    "world": "world_view()",
    "pad": "pad()",
    "turtle": "turtlesim_window()",
    "graph": "graph()",
    "topics": "topic_panel()",
    "services": "service_caller()",
    "publisher": "message_publisher('turtle1/cmd_vel')",
    "parameters": "parameter_panel('turtlesim')",
    "log": "log_console()",
    "frames": "frames()",
    "network": "network_panel()",
    "plot": "plot('/turtle1/pose.x:y')",
    "timeline": "timeline()",
}
RULES = {"runOnly": {"type": "tag", "values": ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"]}}


@pytest.fixture
def opened(notebook):
    open_notebook = notebook(LAB, START, *PANELS.values(), width=1366, height=6500)
    open_notebook.run()
    open_notebook.page.wait_for_selector(".ck-world[data-messages]")
    return open_notebook


def faults_of(axe, page):
    """What axe says against what stands below the cells, a line for each element."""
    audit = axe.run(page, context={"include": [[".jp-OutputArea-output"]]}, options=RULES).response
    assert len(audit["passes"]) > 5, "it looked at something"
    return [
        f"{violation['id']}: {node['html'][:120]} {' '.join(node['failureSummary'].split())[:240]}"
        for violation in audit["violations"]
        for node in violation["nodes"]
    ]


def test_panels_have_no_fault(opened, picture):
    axe = pytest.importorskip("axe_playwright_python.sync_playwright").Axe()
    page = opened.page
    for light in (True, False):
        set_theme(page, light=light)
        picture(page, f"accessible-{'light' if light else 'dark'}")
        faults = faults_of(axe, page)
        assert not faults, "\n".join(["light" if light else "dark", *faults])
