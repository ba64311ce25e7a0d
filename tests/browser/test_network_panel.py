"""The network's panel: it shows what comes from a robot, and its button leaves."""

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

CELLS = (
    "from coursekit.lab import *\nvera = practice_robot()",
    "%network {vera.address} --yes",
    "from sensor_msgs.msg import LaserScan\nimport rclpy\nrclpy.init()\nme = rclpy.create_node('laptop')\nheard = []\n"
    "_ = me.create_subscription(LaserScan, '/scan', heard.append, 10)\nwhile len(heard) < 5:\n    rclpy.spin_once(me)",
    "network_panel()",
)
PATIENCE_MS = 60_000


def test_the_panel_shows_what_a_robot_sends_and_leaves(notebook, picture):
    opened = notebook(*CELLS, width=1366, height=900)
    opened.run()
    page = opened.page
    panel = page.locator(".ck-network")
    panel.locator("td", has_text="/scan").wait_for(timeout=PATIENCE_MS)
    panel.scroll_into_view_if_needed()
    picture(page, "network-panel")
    assert "joined" in panel.locator("[role=status]").inner_text()
    panel.get_by_role("button", name="Leave").click()
    panel.get_by_text("%network ADDRESS").wait_for(timeout=PATIENCE_MS)
    assert panel.locator("[role=status]").inner_text() == "not joined"
    picture(page, "network-left")
