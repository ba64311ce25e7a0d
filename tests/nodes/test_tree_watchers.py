"""nav2's tree nodes that watch the path, the goal and the battery; and the trees that come with nav2_bt_navigator."""

from collections import deque
from types import SimpleNamespace

import pytest
from geometry_msgs.msg import PoseStamped, TransformStamped
from nav_msgs.msg import Odometry, Path
from rclpy.time import Time
from sensor_msgs.msg import BatteryState
from tf2_ros import Buffer

from coursekit.geometry.plane import Pose2D
from coursekit.nav.behavior_tree import FAILURE, RUNNING, SUCCESS, TreeError, read_tree
from coursekit.nav.tree_blackboard import SECONDS
from coursekit.nodes.nav2.tree_run import KINDS, board_of, load_tree, text_of


@pytest.fixture
def tree_context():
    topics = {}
    tree_context = SimpleNamespace(now=0.0, topics=topics, service=lambda *_: None, client=lambda *_: None)
    tree_context.seconds = lambda: tree_context.now
    tree_context.listen = lambda topic, *_, most=1: topics.setdefault(topic, deque(maxlen=most))
    return tree_context


@pytest.fixture
def tree(tree_context):
    def made(inner, **board):
        board |= {"node": tree_context}
        return read_tree(f'<root><BehaviorTree ID="Main">{inner}</BehaviorTree></root>', KINDS, board), board

    return made


def pose_at(x, seconds=0):
    pose = PoseStamped()
    pose.pose.position.x, pose.header.stamp.sec = x, seconds
    return pose


def moving(seconds, speed):
    msg = Odometry()
    msg.header.stamp, msg.twist.twist.linear.x = Time(seconds=seconds).to_msg(), speed
    return msg


def straight(metres):
    path = Path(poses=[PoseStamped(), PoseStamped()])
    path.poses[1].pose.position.x = float(metres)
    return path


def test_a_path_expires_when_it_has_been_the_same_for_long(tree_context, tree):
    timer, board = tree('<PathExpiringTimer seconds="2" path="{path}"/>', path=straight(1))
    results = []
    for now, path in ((0, 1), (1.9, 1), (2.0, 1), (2.1, 1), (3.9, 4), (5.8, 4), (5.9, 4)):
        tree_context.now, board["path"] = now, straight(path)
        results.append(timer.tick() == SUCCESS)
    assert results == [False, False, True, False, False, False, True]


def test_the_surroundings_of_a_path_are_what_is_near_the_robot(tree_context, tree):
    path = Path(poses=[straight(x).poses[1] for x in range(20)])
    tree_context.pose = lambda: Pose2D(7.2, 1.0, 0.0)
    local = '<TruncatePathLocal distance_backward="2" distance_forward="3.5" input_path="{path}" output_path="{local}"/>'
    node, board = tree(local, path=path)
    assert node.tick() == SUCCESS
    assert [pose.pose.position.x for pose in board["local"].poses] == [5.0, 6.0, 7.0, 8.0, 9.0, 10.0]
    tree_context.pose = lambda: None
    assert node.tick() == FAILURE


def test_a_transform_is_available_when_both_frames_are_known(tree_context, tree):
    buffer = Buffer()
    tree_context.knows = lambda target, source: buffer.can_transform(target, source, Time())
    node, _ = tree('<TransformAvailable parent="odom" child="base_link"/>')
    assert node.tick() == FAILURE
    transform = TransformStamped(child_frame_id="base_link")
    transform.header.frame_id, transform.transform.rotation.w = "odom", 1.0
    buffer.set_transform_static(transform, "test")
    assert node.tick() == SUCCESS


def test_a_child_is_ticked_once_for_each_goal(tree):
    once, board = tree('<GoalUpdatedController><SetBlackboard value="yes" output_key="planned"/></GoalUpdatedController>')
    assert once.tick() == SUCCESS and board.pop("planned") == "yes"
    assert once.tick() == RUNNING and "planned" not in board
    board["goal"] = pose_at(1.0)
    assert once.tick() == SUCCESS and board.pop("planned") == "yes"
    assert once.tick() == RUNNING and "planned" not in board
    once.halt()
    assert once.tick() == SUCCESS and "planned" in board


def test_a_goal_is_updated_when_it_is_not_the_one_of_the_last_tick(tree):
    updated, board = tree("<GoalUpdated/>", goal=pose_at(1.0))
    assert [updated.tick() for _ in range(2)] == [FAILURE, FAILURE]
    board["goal"] = pose_at(2.0)
    assert [updated.tick() for _ in range(2)] == [SUCCESS, FAILURE]
    board["goal"] = pose_at(3.0)
    updated.halt()
    assert updated.tick() == FAILURE, "it begins with the goal that there is"


def test_a_new_goal_plans_again_only_then(tree):
    """The upper half of nav2's navigate_w_replanning_only_if_goal_is_updated.xml."""
    planned = '<SetBlackboard value="yes" output_key="planned"/>'
    running = "<KeepRunningUntilFailure><AlwaysSuccess/></KeepRunningUntilFailure>"
    drive, board = tree(
        f"<PipelineSequence><Fallback><Inverter><GlobalUpdatedGoal/></Inverter>{planned}</Fallback>{running}</PipelineSequence>",
        goal=pose_at(1.0),
    )
    plans = []
    for goal in (1.0, 1.0, 2.0, 2.0):
        board["goal"] = pose_at(goal)
        assert drive.tick() == RUNNING
        plans.append(board.pop("planned", "no"))
    assert plans == ["yes", "no", "yes", "no"]


def test_a_recovery_beside_goal_updated_is_told_of_no_goal(tree):
    """BehaviorTree.CPP lets what stands before a running child begin anew with each tick (nav2's issue 6082)."""
    running = "<KeepRunningUntilFailure><AlwaysSuccess/></KeepRunningUntilFailure>"
    recovery, board = tree(f"<ReactiveFallback><GoalUpdated/>{running}</ReactiveFallback>", goal=pose_at(1.0))
    assert recovery.tick() == RUNNING
    board["goal"] = pose_at(2.0)
    assert recovery.tick() == RUNNING


def test_a_child_is_ticked_the_more_often_the_faster_the_robot_drives(tree_context, tree):
    count = '<SetBlackboard value="1" output_key="n"/>'
    rates = 'min_rate="0.5" max_rate="2" max_speed="1.0"'
    speedy, board = tree(f"<SpeedController {rates}>{count}</SpeedController>", goal=pose_at(1.0))
    board[SECONDS] = lambda: tree_context.now

    def ticks(begin, speed):
        tree_context.speed, at = lambda: speed, []
        for tenth in range(begin * 10, begin * 10 + 60):
            tree_context.now = tenth / 10
            speedy.tick()
            if board.pop("n", None):
                at.append(tree_context.now)
        return at

    assert ticks(0, 0.0) == [0.0, 0.5, 2.5, 4.5]  # the first period is the shortest one
    assert ticks(6, 1.0) == [6.5, 7.0, 7.5, 8.0, 8.5, 9.0, 9.5, 10.0, 10.5, 11.0, 11.5]
    board["goal"] = pose_at(2.0)
    assert ticks(12, 0.0)[:3] == [12.0, 12.5, 14.5], "a new goal is told at once"


def test_a_rate_of_nothing_is_refused(tree):
    with pytest.raises(TreeError, match="SpeedController node cannot have rate <= 0.0"):
        tree('<SpeedController min_rate="0"><AlwaysSuccess/></SpeedController>')


def test_a_robot_that_brakes_harder_than_it_can_is_stuck(tree_context, tree):
    stuck, _ = tree("<IsStuck/>")
    results = []
    for k, speed in enumerate((0.5, 0.0, 0.5, 0.45, 0.0, 0.0)):
        tree_context.topics["odom"].append(moving(k * 0.02, speed))
        results.append(stuck.tick())
    assert results == [FAILURE, FAILURE, FAILURE, FAILURE, SUCCESS, FAILURE]


def test_a_goal_on_the_topic_replaces_an_older_one_only(tree_context, tree):
    updater, board = tree('<GoalUpdater input_goal="{goal}" output_goal="{out}"><AlwaysSuccess/></GoalUpdater>')
    board["goal"] = pose_at(1.0, seconds=10)
    updater.tick()
    assert board["out"] == board["goal"]
    tree_context.topics["goal_update"].append(pose_at(2.0, seconds=11))
    updater.tick()
    assert board["out"] == pose_at(2.0, seconds=11)
    board["goal"] = pose_at(3.0, seconds=12)
    updater.tick()
    assert board["out"] == board["goal"]


def test_time_and_distance_are_counted_from_the_first_tick_after_a_halt(tree_context, tree):
    tree_context.pose = lambda: Pose2D(tree_context.now, 0.0, 0.0)
    for kind in ('TimeExpired seconds="2"', 'DistanceTraveled distance="2"'):
        tree_context.now = 0.0
        condition, _ = tree(f"<{kind}/>")
        results = []
        for tree_context.now in (0.0, 1.9, 2.0, 3.9, 4.0):
            results.append(condition.tick() == SUCCESS)
        condition.halt()
        for tree_context.now in (9.0, 10.0, 11.0):
            results.append(condition.tick() == SUCCESS)
        assert results == [False, False, True, False, True, False, False, True], kind


def test_a_goal_is_new_once_however_often_a_sequence_ends(tree):
    branch, _ = tree("<ReactiveSequence><Inverter><GlobalUpdatedGoal/></Inverter><AlwaysSuccess/></ReactiveSequence>")
    assert [branch.tick() for _ in range(3)] == [FAILURE, SUCCESS, SUCCESS]


@pytest.mark.parametrize(
    ("before", "after", "expected"), [(2, 5, FAILURE), (2, 3, SUCCESS), (4, 20, SUCCESS), (2, 2, SUCCESS)]
)
def test_a_much_longer_path_near_the_goal_is_told(tree, before, after, expected):
    watch, board = tree('<PathLongerOnApproach path="{path}"><AlwaysFailure/></PathLongerOnApproach>', path=straight(before))
    assert watch.tick() == SUCCESS
    board["path"] = straight(after)
    assert watch.tick() == expected
    assert watch.tick() == SUCCESS  # of the same path once


@pytest.mark.parametrize(
    ("ports", "expected"),
    [('min_battery="0.2"', FAILURE), ('min_battery="0.4"', SUCCESS), ('min_battery="11.5" is_voltage="true"', SUCCESS)],
)
def test_a_battery_is_low_by_its_charge_or_its_voltage(tree_context, tree, ports, expected):
    condition, _ = tree(f'<IsBatteryLow battery_topic="/battery" {ports}/>')
    assert condition.tick() == FAILURE
    tree_context.topics["/battery"].append(BatteryState(percentage=0.3, voltage=11.4))
    assert condition.tick() == expected


@pytest.mark.parametrize(
    "name",
    [
        "nav_to_pose_with_consistent_replanning_and_if_path_becomes_invalid",
        "navigate_w_replanning_only_if_goal_is_updated",
        "navigate_w_replanning_only_if_path_becomes_invalid",
        "odometry_calibration",
        "navigate_to_pose_w_replanning_and_recovery",
    ],
)
def test_nav2s_trees_are_there_under_their_names_on_a_robot(tree_context, name):
    file = f"/opt/ros/humble/share/nav2_bt_navigator/behavior_trees/{name}.xml"
    assert load_tree(file, text_of(file), board_of(tree_context)).children
