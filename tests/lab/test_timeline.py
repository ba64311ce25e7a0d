"""`timeline()`: panels go back together over what they have shown, and on again to what happens."""

import pytest
from geometry_msgs.msg import TransformStamped, Twist
from tf2_ros import TransformBroadcaster

from coursekit.lab.frames_panel import frames
from coursekit.lab.graph_panel import graph
from coursekit.lab.panel_history import PanelHistory
from coursekit.lab.plot_panel import plot
from coursekit.lab.timeline import timeline
from coursekit.lab.viewer import viewer


class Drive:
    """A frame that moves one metre a second along x, and a speed that is its distance."""

    def __init__(self, talker):
        self.node, self.x = talker, 0.0
        self.frames, self.speed = TransformBroadcaster(talker), talker.create_publisher(Twist, "cmd_vel", 10)

    def go(self, session, seconds):
        for _ in range(round(seconds * 10)):
            message = TransformStamped()
            message.header.frame_id, message.child_frame_id = "odom", "base"
            message.header.stamp = self.node.get_clock().now().to_msg()
            message.transform.translation.x, message.transform.rotation.w = self.x, 1.0
            self.frames.sendTransform(message)
            speed = Twist()
            speed.linear.x = self.x
            self.speed.publish(speed)
            session.clock.sleep(0.1)
            self.x += 0.1


@pytest.fixture
def drive(talker):
    return Drive(talker)


def told(page, kind):
    return [message for message in page.heard if message["type"] == kind]


def place_of(moment, panel):
    """Where the frame is in a moment that a viewer keeps."""
    number = panel.stage.scene.things[panel.stage.find("TF").key, "axes base"].number
    return moment[0][number].pose[0]


def open_viewer(page):
    panel = viewer(fixed_frame="odom", displays=["TF"])
    does = page(panel)
    does("ready")
    does("open")
    return panel, does


def test_a_viewer_shows_where_a_frame_was_and_where_it_is_again(session, drive, page):
    panel, does = open_viewer(page)
    line = timeline()
    for _ in range(30):
        drive.go(session, 0.1)
        does("drawn", n=10**6)
    line.back(2.0)
    session.clock.sleep(0.1)
    shown = told(does, "scene")[-1]
    assert shown["past"] and shown["whole"] and shown["view"] is None
    assert place_of(panel.past.at(line.cursor.time), panel) == pytest.approx(0.9, abs=0.25)
    does("drawn", n=10**6)
    line.live()
    session.clock.sleep(0.1)
    assert not told(does, "scene")[-1]["past"]


def test_what_is_shown_stays_while_it_is_paused_and_all_goes_on_beneath(session, drive, page):
    panel, does = open_viewer(page)
    line = timeline()
    drive.go(session, 1.0)
    line.pause()
    time = line.cursor.time
    drive.go(session, 1.0)
    assert line.cursor.time == time and line.ago == pytest.approx(1.0, abs=0.01)
    before = len(told(does, "scene"))
    does("drawn", n=10**6)
    drive.go(session, 0.5)
    assert len(told(does, "scene")) <= before + 1  # the page is at rest
    assert place_of(panel.past.at(session.clock.steady()), panel) > place_of(panel.past.at(time), panel) + 0.9


def test_it_plays_on_until_it_shows_what_happens(session, drive, page):
    open_viewer(page)
    line = timeline()
    drive.go(session, 3.0)
    line.back(2.0)
    line.play()
    drive.go(session, 1.0)
    assert line.cursor.time is not None and line.ago == pytest.approx(2.0, abs=0.15)  # both go on at the same pace
    line.live()
    assert line.ago == 0.0 and line.cursor.time is None


def test_graph_and_frames_show_what_there_was(session, talker, drive, page):
    pictures = {graph(live=True, hidden=True): "talker", frames(live=True): "base"}
    pages = {panel: page(panel) for panel in pictures}
    for does in pages.values():
        does("ready")
    drive.go(session, 1.0)
    late = session.clock.steady()
    talker.create_publisher(Twist, "late", 1)
    session.clock.sleep(1.0)
    line = timeline()
    line.back((session.clock.steady() - late) * 1e-9)
    for panel, does in pages.items():
        assert told(does, "past")[-1]["on"] and pictures[panel] in told(does, "shown")[-1]["svg"]
    [drawn] = [told(does, "shown")[-1]["svg"] for panel, does in pages.items() if pictures[panel] == "talker"]
    assert "/late" not in drawn
    line.live()
    [drawn] = [told(does, "shown")[-1]["svg"] for panel, does in pages.items() if pictures[panel] == "talker"]
    assert "/late" in drawn


def test_a_plot_goes_back_with_the_others_and_leads_them(session, drive, page):
    panel = plot("/cmd_vel.linear.x")
    does = page(panel)
    does("ready")
    line = timeline()
    drive.go(session, 3.0)
    line.back(1.0)
    assert told(does, "look")[-1]["at"] == pytest.approx(2.0, abs=0.05)
    does("go", at=0.5)
    assert line.ago == pytest.approx(2.5, abs=0.05)
    does("go", at=None)
    assert line.cursor.time is None and told(does, "look")[-1]["at"] is None
    does("go", at=0.5)
    panel.close()
    assert line.cursor.time is None, "the others are not left in the past"


def test_what_a_page_says_is_checked_and_without_a_time_line_all_is_live(session, drive, page):
    line = timeline()
    does = page(line)
    does("ready")
    for wrong in ("soon", None, float("nan")):
        does("go", ago=wrong)
    does("press", button="close")
    assert line.cursor.time is None
    drive.go(session, 0.5)
    does("go", ago=1e9)
    assert line.cursor.time is not None
    line.close()
    assert line.cursor.time is None


def test_the_text_says_where_the_panels_are(session, drive, page):
    open_viewer(page)
    line = timeline()
    drive.go(session, 2.0)
    line.back(0.5)
    assert str(line) == "time line of 2.0 s: 0.5 s ago"
    line.live()
    assert str(line) == "time line of 2.0 s: now"


def test_the_past_is_bounded_in_time_and_in_memory():
    past = PanelHistory(seconds=10.0, largest=1000)
    for second in range(100):
        past.keep(second * 10**9, second, 1)
    assert past.span() == (89 * 10**9, 99 * 10**9)
    past.keep(100 * 10**9, "large", 999)
    assert past.at(0) == 99 and past.at(10**12) == "large"
    past.keep(101 * 10**9, "larger", 5000)
    assert past.at(0) == "larger"
    assert PanelHistory().at(0) is None and PanelHistory().span() is None
