"""What the waypoint follower does at each waypoint: it waits, is told to go on, or takes a picture."""

import cv2
import numpy as np
import pytest
from geometry_msgs.msg import PoseStamped
from nav2_msgs.action import FollowWaypoints, NavigateToPose
from rclpy.action import ActionClient, ActionServer
from sensor_msgs.msg import Image
from std_msgs.msg import Empty

from tests.nodes.friend import Friend

SUCCEEDED, ABORTED = 4, 6
PARAMETERS = """waypoint_follower:
  ros__parameters:
    stop_on_failure: {stops}
    waypoint_task_executor_plugin: task
    task: {{plugin: "nav2_waypoint_follower::{plugin}"{settings}}}
"""


@pytest.fixture
def friend(session):
    """A node that goes to any pose at once."""
    new_friend = Friend(session)

    def go(handle):
        handle.succeed()
        return NavigateToPose.Result()

    new_friend.server = ActionServer(new_friend.node, NavigateToPose, "navigate_to_pose", go)
    return new_friend


@pytest.fixture
def follower(run, ros2, tmp_path):
    """follower("InputAtWaypoint", "timeout: 2.0") starts an active waypoint follower with this task."""

    def start(plugin, *settings, stops="false"):
        text = PARAMETERS.format(plugin=plugin, settings="".join(f", {setting}" for setting in settings), stops=stops)
        (tmp_path / "follower.yaml").write_text(text)
        files = ("--ros-args", "--params-file", str(tmp_path / "follower.yaml"))
        node = run("nav2_waypoint_follower", "waypoint_follower", *files)
        for verb in ("configure", "activate"):
            ros2("lifecycle", "set", "/waypoint_follower", verb)
        return node

    return start


def follow(friend, count, seconds=30.0):
    """The status of a trip over so many waypoints, and its result."""
    client = ActionClient(friend.node, FollowWaypoints, "follow_waypoints")
    assert client.wait_for_server(timeout_sec=5.0)
    asked = client.send_goal_async(FollowWaypoints.Goal(poses=[PoseStamped() for _ in range(count)]))
    friend.executor.spin_until_future_complete(asked, timeout_sec=seconds)
    answer = asked.result().get_result_async()
    friend.executor.spin_until_future_complete(answer, timeout_sec=seconds)
    return answer.result().status, answer.result().result


def now(friend):
    return friend.node.get_clock().now().nanoseconds * 1e-9


def test_it_waits(follower, friend):
    follower("WaitAtWaypoint", "waypoint_pause_duration: 1500")
    begin = now(friend)
    assert follow(friend, 2)[0] == SUCCEEDED and 3.0 <= now(friend) - begin < 3.5


def test_a_message_sends_it_on(follower, friend):
    node = follower("InputAtWaypoint", "timeout: 20.0", "input_topic: go_on")
    out = friend.node.create_publisher(Empty, "go_on", 1)
    friend.node.create_timer(1.0, lambda: out.publish(Empty()))
    begin = now(friend)
    status, result = follow(friend, 2)
    assert status == SUCCEEDED and not result.missed_waypoints and now(friend) - begin < 3.0
    assert "Task execution at waypoint 1 succeeded" in node.output


@pytest.mark.parametrize(("stops", "status"), [("false", SUCCEEDED), ("true", ABORTED)])
def test_without_a_message_the_task_fails_and_the_trip_goes_on_or_ends(follower, friend, stops, status):
    node = follower("InputAtWaypoint", "timeout: 2.0", stops=stops)
    assert follow(friend, 2)[0] == status
    assert "Unable to get external input at wp 0. Moving on." in node.output
    assert ("at wp 1" in node.output) is (status == SUCCEEDED)


def test_pictures_are_saved_in_their_colors(follower, friend, tmp_path):
    follower("PhotoAtWaypoint", f"save_dir: '{(tmp_path / 'photos').as_posix()}'", "image_topic: camera")
    red = np.zeros((4, 6, 3), np.uint8)
    red[..., 0] = 255
    picture = Image(height=4, width=6, encoding="rgb8", step=18, data=red.tobytes())
    out = friend.node.create_publisher(Image, "camera", 10)
    friend.node.create_timer(0.2, lambda: out.publish(picture))
    friend.spin(1.0)
    assert follow(friend, 2)[0] == SUCCEEDED
    assert sorted(path.name for path in (tmp_path / "photos").iterdir()) == ["0_0.png", "1_0.png"]
    assert cv2.imread(str(tmp_path / "photos/1_0.png"))[0, 0].tolist() == [0, 0, 255]


def test_no_picture_is_a_failure_that_names_the_topic(follower, friend, tmp_path):
    node = follower("PhotoAtWaypoint", f"save_dir: '{tmp_path.as_posix()}'", "image_topic: nowhere", stops="true")
    assert follow(friend, 1)[0] == ABORTED
    assert "Make sure that the image topic named: nowhere is valid and active!" in node.output


def test_an_unknown_task_is_refused_with_those_that_exist(follower):
    node = follower("DanceAtWaypoint")
    assert "DanceAtWaypoint with base class type nav2_core::WaypointTaskExecutor does not exist" in node.output
    assert "nav2_waypoint_follower::PhotoAtWaypoint" in node.output
