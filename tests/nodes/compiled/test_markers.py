"""Compiled programs: interactive markers are shown, dragged, and have menus."""

from __future__ import annotations

import rclpy
from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerUpdate
from visualization_msgs.srv import GetInteractiveMarkers

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program


class Viewer:
    """Who shows the markers."""

    def __init__(self, session):
        self.clock = session.clock
        rclpy.init()
        self.node = rclpy.create_node("viewer")
        self.updates = []
        self.node.create_subscription(InteractiveMarkerUpdate, "/handles/update", self.updates.append, 10)
        self.feedback = self.node.create_publisher(InteractiveMarkerFeedback, "/handles/feedback", 10)
        self.client = self.node.create_client(GetInteractiveMarkers, "/handles/get_interactive_markers")

    def wait(self, seconds):
        end = self.clock.now() + int(seconds * 1e9)
        while self.clock.now() < end:
            rclpy.spin_once(self.node, timeout_sec=0.05)

    def markers(self):
        future = self.client.call_async(GetInteractiveMarkers.Request())
        rclpy.spin_until_future_complete(self.node, future)
        return future.result()

    def tell(self, kind, client="viewer", entry=0, x=0.0):
        message = InteractiveMarkerFeedback(client_id=client, marker_name="knob", event_type=kind, menu_entry_id=entry)
        message.pose.position.x = x
        self.feedback.publish(message)
        self.wait(0.1)


def test_a_marker_is_shown_dragged_and_its_menu_obeyed(session, build):
    viewer = Viewer(session)
    process = session.launch(make_process(session, build("markers", program("markers.cpp")), name="markers"))
    viewer.wait(0.5)
    shown = viewer.markers()
    [marker] = shown.markers
    assert (shown.sequence_number, marker.name, marker.description) == (1, "knob", "A knob")
    entries = [(entry.id, entry.parent_id, entry.title) for entry in marker.menu_entries]
    assert entries == [(1, 0, "[x] First"), (2, 1, "[ ] Below")]

    viewer.tell(InteractiveMarkerFeedback.POSE_UPDATE, x=1.5)
    assert [(pose.name, pose.pose.position.x, pose.header.frame_id) for pose in viewer.updates[-1].poses] == [
        ("knob", 1.5, "base_link")
    ]
    viewer.tell(InteractiveMarkerFeedback.POSE_UPDATE, client="another", x=9.0)  # not while the first one drags
    assert viewer.markers().markers[0].pose.position.x == 1.5
    viewer.tell(InteractiveMarkerFeedback.MENU_SELECT, entry=1)
    assert viewer.updates[-1].markers[0].menu_entries[0].title == "[ ] First"
    assert [update.seq_num for update in viewer.updates] == [1, 2, 3]

    viewer.wait(4.0)
    assert list(viewer.updates[-1].erases) == ["knob"] and not viewer.markers().markers
    process.interrupt()
    assert process.wait(5.0) == 0
    said = [line for line in process.output.splitlines() if "signal_handler" not in line]
    assert said == ["1001000", "kind 1 of knob at 1.5", "chosen First checked"]
