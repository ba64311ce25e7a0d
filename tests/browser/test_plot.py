"""A plot in the page: curves of a turtle, back over the time line, live again, and in the dark."""

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

CELLS = (
    "from coursekit.lab import *\n%ros2 run turtlesim turtlesim_node &",
    "plot('/turtle1/pose.x:y:theta')",
    "%ros2 topic pub -r 10 /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 2.0}, angular: {z: 1.0}}' &",
    "wait(8)",
)
PATIENCE_MS = 60_000
MANY = "() => Number(document.querySelector('.ck-plot canvas')?.dataset.points) > 900"


def test_a_plot_is_live_goes_back_and_is_live_again(notebook, picture):
    opened = notebook(*CELLS, width=1366, height=768)
    opened.run()
    page = opened.page
    panel = page.locator(".ck-plot")
    page.wait_for_function(MANY, timeout=PATIENCE_MS)
    panel.scroll_into_view_if_needed()
    picture(page, "plot-live")
    assert "now" in panel.locator(".ck-when").inner_text()
    line = panel.get_by_label("time line")
    panel.get_by_label("how much is shown").select_option("5")
    line.evaluate("(slider) => { slider.value = 6; slider.dispatchEvent(new Event('input')); }")
    assert panel.locator(".ck-when").inner_text().startswith("6.0 of ")
    canvas = panel.locator("canvas")
    canvas.hover(position={"x": 300, "y": 120})
    picture(page, "plot-back")
    assert "/turtle1/pose.theta" in panel.locator(".ck-legend").inner_text()
    panel.get_by_role("button", name="Live").click()
    assert "now" in panel.locator(".ck-when").inner_text()
