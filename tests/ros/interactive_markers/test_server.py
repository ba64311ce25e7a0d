"""interactive_markers: clients learn of changes, programs of what clients do, and one client at a time moves a marker."""

import pytest
import rclpy
from geometry_msgs.msg import Pose
from interactive_markers import InteractiveMarkerServer, MenuHandler
from std_msgs.msg import Header
from visualization_msgs.msg import InteractiveMarker, InteractiveMarkerFeedback, InteractiveMarkerUpdate, MenuEntry
from visualization_msgs.srv import GetInteractiveMarkers

from coursekit.processes.session import Session

Feedback = InteractiveMarkerFeedback
MOVED = Feedback.POSE_UPDATE


class Client:
    """What a viewer does: it asks for all markers, hears updates, and sends feedback."""

    def __init__(self, node):
        self.node, self.updates = node, []
        self.asked = node.create_client(GetInteractiveMarkers, "stage/get_interactive_markers")
        self.out = node.create_publisher(Feedback, "stage/feedback", 10)
        node.create_subscription(InteractiveMarkerUpdate, "stage/update", self.updates.append, 10)

    def spin(self, seconds=0.1):
        rclpy.spin_until_future_complete(self.node, rclpy.task.Future(), timeout_sec=seconds)

    def all(self):
        future = self.asked.call_async(GetInteractiveMarkers.Request())
        rclpy.spin_until_future_complete(self.node, future, timeout_sec=2.0)
        return future.result()

    def send(self, name, kind=MOVED, client="me", x=0.0, frame="map", entry=0):
        msg = Feedback(marker_name=name, event_type=kind, client_id=client, menu_entry_id=entry)
        msg.header.frame_id, msg.pose.position.x = frame, x
        self.out.publish(msg)
        self.spin()


@pytest.fixture
def stage():
    """A server with the marker `box` that is one second old, and a client."""
    with Session(virtual=True).use():
        rclpy.init()
        node = rclpy.create_node("stage")
        server, client = InteractiveMarkerServer(node, "stage"), Client(node)
        server.insert(marker("box"))
        server.applyChanges()
        client.spin(1.1)
        yield server, client
        server.shutdown()
        rclpy.shutdown()


def marker(name, frame="map"):
    return InteractiveMarker(name=name, header=Header(frame_id=frame))


def pose(x):
    new_pose = Pose()
    new_pose.position.x = x
    return new_pose


def test_changes_count_when_they_are_applied_and_a_new_client_gets_all(stage):
    server, client = stage
    server.insert(marker("ball"))
    assert [shown_marker.name for shown_marker in client.all().markers] == ["box"] and server.get("ball").name == "ball"
    server.applyChanges()
    answer = client.all()
    assert [shown_marker.name for shown_marker in answer.markers] == ["box", "ball"]
    assert answer.sequence_number == client.updates[-1].seq_num == 2
    assert [shown_marker.name for shown_marker in client.updates[-1].markers] == ["ball"]
    server.applyChanges()
    client.spin()
    assert len(client.updates) == 2, "nothing has changed"


def test_a_marker_moves_in_its_frame_or_another(stage):
    server, client = stage
    assert server.setPose("box", pose(1.0)) and server.get("box").pose.position.x == 1.0
    server.applyChanges()
    client.spin()
    assert client.updates[-1].poses[0].header.frame_id == "map" and not client.updates[-1].markers
    assert server.setPose("box", pose(2.0), Header(frame_id="odom"))
    server.applyChanges()
    assert client.all().markers[0].header.frame_id == "odom"
    assert not server.setPose("nobody", pose(1.0))


def test_markers_are_erased_one_by_one_and_together(stage):
    server, client = stage
    server.insert(marker("ball"))
    server.applyChanges()
    assert server.erase("box") and server.get("box") is None and not server.erase("nobody")
    server.applyChanges()
    client.spin()
    assert client.updates[-1].erases == ["box"]
    server.clear()
    server.applyChanges()
    assert not client.all().markers


def test_feedback_moves_a_marker_and_goes_to_the_function_of_its_type_or_the_default(stage):
    server, client = stage
    clicks, others = [], []
    assert server.setCallback("box", others.append) and not server.setCallback("nobody", others.append)
    server.setCallback("box", clicks.append, Feedback.BUTTON_CLICK)
    client.send("box", Feedback.BUTTON_CLICK)
    client.send("box", x=3.0, frame="odom")
    client.send("nobody", x=3.0)
    assert [len(clicks), len(others)] == [1, 1]
    assert server.get("box").pose.position.x == 3.0
    server.applyChanges()
    assert client.all().markers[0].header.frame_id == "odom"
    server.setCallback("box", None, Feedback.BUTTON_CLICK)
    client.send("box", Feedback.BUTTON_CLICK)
    assert [len(clicks), len(others)] == [1, 2]


def test_a_second_client_has_to_wait_until_the_first_has_let_go(stage):
    server, client = stage
    client.send("box", x=1.0, client="first")
    client.send("box", x=2.0, client="second")
    assert server.get("box").pose.position.x == 1.0
    client.spin(1.0)
    client.send("box", x=2.0, client="second")
    assert server.get("box").pose.position.x == 2.0


def test_a_menu_calls_what_was_chosen_and_shows_its_boxes(stage):
    server, client = stage
    menu, chosen = MenuHandler(), []
    top = menu.insert("Drive")
    fast = menu.insert("Fast", parent=top, callback=lambda feedback: chosen.append(feedback.menu_entry_id))
    hidden = menu.insert("Secret", parent=top)
    menu.setVisible(hidden, False)
    menu.setCheckState(fast, MenuHandler.UNCHECKED)
    assert menu.apply(server, "box") and not menu.apply(server, "nobody")
    server.applyChanges()
    entries = client.all().markers[0].menu_entries
    assert [(entry.title, entry.parent_id, entry.command_type) for entry in entries] == [
        ("Drive", 0, MenuEntry.FEEDBACK), ("[ ] Fast", top, MenuEntry.FEEDBACK)
    ]  # fmt: skip
    client.send("box", Feedback.MENU_SELECT, entry=fast)
    client.send("box", Feedback.MENU_SELECT, entry=top)
    assert chosen == [fast]
    menu.setCheckState(fast, MenuHandler.CHECKED)
    assert menu.reApply(server) and menu.getCheckState(fast) == MenuHandler.CHECKED and menu.getTitle(99) is None
    server.applyChanges()
    assert client.all().markers[0].menu_entries[1].title == "[x] Fast"


def test_an_entry_below_none_is_refused(capfd):
    assert MenuHandler().insert("Fast", parent=7) is None
    assert "Parent menu entry 7 not found." in capfd.readouterr().err
