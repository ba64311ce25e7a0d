"""RViz's panels by mouse and keys: displays are added, changed and removed; things are selected, measured, followed."""

import json

import pytest

from .pages import set_theme
from .test_accessible import faults_of
from .test_viewer import OBJECTS, appears, drawn
from .test_viewer_tools import PIXEL

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

LAB = "from coursekit.lab import *"
TALK = """
import rclpy, threading
from geometry_msgs.msg import TransformStamped
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import LaserScan
from tf2_ros import StaticTransformBroadcaster
from visualization_msgs.msg import Marker
rclpy.init()
talker = rclpy.create_node("talker")
frames = StaticTransformBroadcaster(talker)
def put(x):
    msg = TransformStamped(child_frame_id="robot")
    msg.header.frame_id, msg.transform.translation.x = "map", x
    frames.sendTransform(msg)
put(1.0)
cube = Marker(ns="shop", id=7, type=Marker.CUBE)
cube.header.frame_id, cube.pose.position.y, cube.pose.position.z = "map", 1.0, 0.25
cube.scale.x = cube.scale.y = cube.scale.z = 0.5
cube.color.b = cube.color.a = 1.0
marks = talker.create_publisher(Marker, "/marks", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
scans = talker.create_publisher(LaserScan, "/front/scan", 5)
def look():
    scan = LaserScan(ranges=[2.0] * 40, angle_min=-1.0, angle_increment=0.05, range_max=5.0)
    scan.header.frame_id = "map"
    marks.publish(cube)
    scans.publish(scan)
talker.create_timer(0.2, look)
threading.Thread(target=rclpy.spin, args=(talker,), daemon=True).start()
""".strip()
VIEWER = """
shown = viewer(fixed_frame="map", displays=["Grid", "TF", "Marker /marks"],
               view={"distance": 8.0, "yaw": -1.2, "pitch": 0.8, "target": [1.0, 0.5, 0.0]})
shown
""".strip()
NAMES = "() => [...document.querySelectorAll('.ck-viewer .ck-text')].filter((one) => one.offsetParent).length"
TARGET = "() => document.querySelector('.ck-viewer').viewer.lookedFrom().target"


@pytest.fixture
def panel(notebook):
    """The viewer of a notebook whose picture is drawn; with `panel.opened`."""
    opened = notebook(LAB, TALK, VIEWER, width=1366, height=768)
    opened.run()
    viewer = opened.page.locator(".ck-viewer")
    viewer.scroll_into_view_if_needed()
    all_there = f"() => ({OBJECTS})() === 5"  # the grid, the axes of two frames, an arrow and the cube
    opened.page.wait_for_function(all_there, timeout=60_000)
    viewer.opened = opened
    return viewer


def click_floor(panel, x, y):
    """Click a place of the floor [m]."""
    panel.page.mouse.click(*panel.page.evaluate(PIXEL, [x, y]))


def looks_at(page, x, y):
    """Wait until the camera looks at a place of the floor [m]."""
    near = f"([a, b]) => Math.hypot(a - {x}, b - {y}) < 0.05"
    page.wait_for_function(f"() => ({near})(({TARGET})())", timeout=20_000)


def test_a_display_is_added_by_its_topic_changed_and_removed(panel, picture):
    page, opened = panel.page, panel.opened
    before = page.evaluate(OBJECTS)
    panel.get_by_role("button", name="Add", exact=True).click()
    dialog = panel.get_by_role("dialog", name="Add a display")
    dialog.get_by_role("button", name="By topic").click()
    offer = dialog.get_by_role("button", name="/front/scan LaserScan")
    offer.wait_for(timeout=20_000)
    picture(panel, "viewer_add")
    offer.click()
    dialog.wait_for(state="hidden")
    row = panel.locator(".ck-row[data-name=LaserScan]")
    row.locator(".ck-say", has_text="Showing 40 points").wait_for(timeout=20_000)
    page.wait_for_function(f"() => ({OBJECTS})() === {before + 1}", timeout=20_000)

    row.get_by_role("button", name="Properties of LaserScan").click()
    row.get_by_label("Style of LaserScan").select_option("Boxes")
    row.get_by_label("Size (m) of LaserScan").fill("0.25")
    row.get_by_label("Size (m) of LaserScan").press("Enter")
    row.get_by_label("Color of LaserScan").fill("#0000ff")
    options = "o = shown.stage.find('LaserScan').options; print(o['style'], o['size'], o['color'])"
    opened.eventually(options, "Boxes 0.25 [0, 0, 255]")
    picture(panel, "viewer_properties")

    row.get_by_role("button", name="Remove this display").click()
    row.wait_for(state="detached", timeout=20_000)
    page.wait_for_function(f"() => ({OBJECTS})() === {before}", timeout=20_000)
    opened.eventually("print(shown.displays)", "['Grid', 'TF', 'Marker']")


def test_the_choice_of_the_fixed_frame_has_the_ink_of_what_can_be_used(panel):
    ink = "(node) => getComputedStyle(node).color"
    head = panel.locator(".ck-head")
    assert head.locator("select").first.evaluate(ink) == head.locator("button").first.evaluate(ink)
    assert head.locator("select").first.evaluate(ink) != head.locator("label").first.evaluate(ink)


def test_the_list_is_used_with_keys_alone(panel):
    page, opened = panel.page, panel.opened
    panel.get_by_role("button", name="Add", exact=True).focus()
    page.keyboard.press("Enter")
    dialog = panel.get_by_role("dialog", name="Add a display")
    dialog.get_by_role("button", name="Axes", exact=False).first.wait_for(timeout=20_000)
    page.keyboard.press("Escape")
    dialog.wait_for(state="hidden")
    assert page.evaluate("document.activeElement.textContent") == "Add", "where it was opened"
    page.keyboard.press("Enter")
    search = dialog.get_by_label("Search displays and topics")
    search.fill("three axes")
    offer = dialog.locator(".ck-offer:visible")
    offer.first.wait_for(timeout=20_000)
    assert offer.count() == 1
    offer.focus()
    page.keyboard.press("Enter")
    opened.eventually("print(shown.displays[-1])", "Axes")
    box = panel.locator(".ck-row[data-name=Axes]").get_by_role("checkbox", name="Axes")
    box.focus()
    page.keyboard.press("Space")
    opened.eventually("print(shown.stage.find('Axes').config.enabled)", "False")
    drawn(page, 5)
    assert page.evaluate("document.activeElement.type") == "checkbox", "news in the list do not take the focus away"


def test_what_opens_in_the_viewer_passes_the_audit_in_the_light_and_in_the_dark(panel):
    axe = pytest.importorskip("axe_playwright_python.sync_playwright").Axe()
    page = panel.page
    panel.get_by_role("button", name="Properties of TF").click()
    panel.get_by_label("Marker Scale of TF").wait_for(timeout=20_000)
    panel.get_by_role("button", name="Select").click()
    click_floor(panel, 0.0, 0.9)
    panel.locator(".ck-picked dd").first.wait_for(timeout=20_000)
    panel.get_by_role("button", name="Views").click()
    panel.get_by_label("Name of this view").fill("mine")
    panel.get_by_label("Name of this view").press("Enter")
    panel.get_by_role("button", name="mine", exact=True).wait_for(timeout=20_000)
    for light in (False, True):
        set_theme(page, light=light)
        faults = faults_of(axe, page)
        panel.get_by_role("button", name="Add", exact=True).click()
        panel.locator(".ck-offer").first.wait_for(timeout=20_000)
        faults += faults_of(axe, page)
        page.keyboard.press("Escape")
        assert not faults, "\n".join(["light" if light else "dark", *faults])


def test_a_view_is_saved_to_a_file_that_opens_again(panel):
    opened = panel.opened
    panel.get_by_role("button", name="Save…").click()
    name = panel.get_by_role("textbox", name="File")
    name.fill("mine.rviz")
    name.press("Enter")
    panel.locator(".ck-told", has_text='viewer("mine.rviz")').wait_for(timeout=20_000)
    assert opened.ask("print(viewer('mine.rviz').displays)").strip() == "['Grid', 'TF', 'Marker']"


def test_a_thing_is_selected_looked_at_and_measured(panel, picture):
    page = panel.page
    panel.get_by_role("button", name="Select").click()
    click_floor(panel, 0.0, 0.9)  # in front of it from here is the cube
    picked = panel.locator(".ck-picked")
    picked.locator("dd", has_text="CUBE").wait_for(timeout=20_000)
    assert "/marks" in picked.inner_text() and "shop" in picked.inner_text()
    page.wait_for_function("() => document.querySelector('.ck-viewer').selection.box.visible", timeout=20_000)
    picture(panel, "viewer_select")
    page.keyboard.press("Escape")
    picked.wait_for(state="hidden", timeout=20_000)

    panel.get_by_role("button", name="Measure").click()
    click_floor(panel, 1.0, -1.0)
    click_floor(panel, 3.0, -1.0)
    length = panel.locator(".ck-length", has_text=" m")
    length.wait_for(timeout=20_000)
    assert float(length.inner_text().split()[0]) == pytest.approx(2.0, abs=0.05)
    picture(panel, "viewer_measure")
    page.keyboard.press("Escape")
    length.wait_for(state="hidden", timeout=20_000)

    page.keyboard.press("c")  # RViz's key of Focus Camera
    click_floor(panel, 2.5, -1.0)
    looks_at(page, 2.5, -1.0)


def test_the_camera_goes_with_a_frame_and_views_are_kept(panel, picture):
    page, opened = panel.page, panel.opened
    panel.get_by_role("button", name="Views").click()
    views = panel.get_by_role("dialog", name="Views")
    views.get_by_label("Target frame").select_option("robot")
    looks_at(page, 1.0, 0.0)
    opened.ask("put(3.0)")
    looks_at(page, 3.0, 0.0)
    views.get_by_label("Name of this view").fill("at the robot")
    views.get_by_label("Name of this view").press("Enter")
    kept = views.get_by_role("button", name="at the robot", exact=True)
    kept.wait_for(timeout=20_000)
    picture(panel, "viewer_views")
    panel.get_by_role("button", name="Reset view").click()
    looks_at(page, 1.0, 0.5)
    opened.ask("put(2.0)")
    kept.click()
    looks_at(page, 2.0, 0.0)
    assert json.loads(opened.ask("import json; print(json.dumps(shown.views))")) == ["at the robot"]


def test_from_straight_above_parallel_lines_stay_parallel_and_tools_hit_the_floor(panel, picture):
    page = panel.page
    panel.get_by_role("button", name="Views").click()
    views = panel.get_by_role("dialog", name="Views")
    views.get_by_label("Type").select_option("TopDownOrtho")
    page.wait_for_function("() => document.querySelector('.ck-viewer').viewer.flat", timeout=20_000)
    where = "(at) => { const { x, y } = document.querySelector('.ck-viewer').viewer.pixel(at); return [x, y]; }"
    (low, high), ahead = (page.evaluate(where, [1.0, 0.0, z]) for z in (0.0, 1.0)), page.evaluate(where, [0.0, 1.0, 0.0])
    middle = page.evaluate(where, [0.0, 0.0, 0.0])
    wide = low[0] - middle[0]
    assert wide > 20 and abs(low[1] - middle[1]) < 1, "x is to the right"
    assert abs(low[0] - high[0]) < 0.02 * wide, "height moves nothing"
    assert middle[1] - ahead[1] == pytest.approx(wide, rel=0.01) and abs(ahead[0] - middle[0]) < 1, "y is up"
    arrow = "(line) => [line.x2.baseVal.value, line.y2.baseVal.value]"
    x, y, z = (panel.locator(f".ck-compass .ck-{axis} line").evaluate(arrow) for axis in "xyz")
    assert x[0] > 14 and y[1] < -14 and max(map(abs, z)) < 1, "the arrows in the corner say so, too"
    picture(panel, "viewer_above")
    panel.get_by_role("button", name="Views").click()
    panel.get_by_role("button", name="Focus").click()
    click_floor(panel, 1.5, -0.5)
    looks_at(page, 1.5, -0.5)
    panel.get_by_role("button", name="Reset view").click()
    page.wait_for_function("() => !document.querySelector('.ck-viewer').viewer.flat", timeout=20_000)


def test_a_camera_that_was_moved_is_kept_over_a_reload(panel):
    page, opened = panel.page, panel.opened
    panel.get_by_role("button", name="Focus").click()
    click_floor(panel, 2.5, -1.0)
    looks_at(page, 2.5, -1.0)
    opened.eventually("print(round(shown.stage.camera().target[0]))", "2", "3")
    page.evaluate("window.jupyterapp.commands.execute('docmanager:save')")
    page.wait_for_function("() => !jupyterapp.shell.currentWidget.context.model.dirty")
    page.reload()
    appears(page)
    looks_at(page, 2.5, -1.0)


def test_the_sky_follows_the_theme_and_small_names_do_not_cover_each_other(panel, picture):
    page = panel.page
    sky = "() => document.querySelector('.ck-viewer').viewer.view.scene_tree.find(['Background']).object.top_color[0]"
    set_theme(page, light=False)
    page.wait_for_function(f"() => ({sky})() < 100", timeout=20_000)
    picture(panel, "viewer_dark")
    set_theme(page, light=True)  # also for those that come after
    page.wait_for_function(f"() => ({sky})() > 200", timeout=20_000)
    seen = panel.locator(".ck-text:not(.ck-big):visible")
    seen.filter(has_text="robot").wait_for(timeout=20_000)
    panel.opened.ask("put(0.0)")  # where the map is
    page.wait_for_function(f"() => ({NAMES})() === 1", timeout=20_000)
