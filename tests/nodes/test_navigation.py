"""Navigation as a user starts it, on the virtual clock: bringup_launch.py, goals, and a program with a BasicNavigator."""

import math
from itertools import pairwise

import pytest
from nav2_msgs.action import ComputePathThroughPoses, NavigateThroughPoses, NavigateToPose
from nav2_msgs.msg import BehaviorTreeLog
from nav_msgs.msg import Odometry, Path
from rclpy.action import ActionClient

from coursekit.geometry.plane import Pose2D
from coursekit.lab.viewer import viewer
from coursekit.sim import Prism
from coursekit.sim.world import Thing
from tests.nodes.nav2_stage import Mover, Stage

START = Pose2D(0.0, 0.0, 0.0)
PROGRAM = """
import rclpy
from geometry_msgs.msg import PoseStamped
from nav2_simple_commander.robot_navigator import BasicNavigator, TaskResult


def pose(navigator, x, y):
    made = PoseStamped()
    made.header.frame_id = "map"
    made.header.stamp = navigator.get_clock().now().to_msg()
    made.pose.position.x, made.pose.position.y, made.pose.orientation.w = x, y, 1.0
    return made


def finish(navigator):
    while not navigator.isTaskComplete():
        feedback = navigator.getFeedback()
    return navigator.getResult().name


rclpy.init()
navigator = BasicNavigator()
here = pose(navigator, 0.0, 0.0)
navigator.setInitialPose(here)
navigator.waitUntilNav2Active()
path = navigator.getPath(here, pose(navigator, 2.0, 0.0))
print("path", path.header.frame_id, len(path.poses) > 30, len(navigator.smoothPath(path).poses) == len(path.poses))
navigator.goToPose(pose(navigator, 2.0, 0.0))
print("go", finish(navigator), navigator.getFeedback().distance_remaining < 0.5)
navigator.spin(1.57)
print("spin", finish(navigator))
navigator.backup(0.15, 0.1)
print("backup", finish(navigator))
navigator.goThroughPoses([pose(navigator, 1.0, 0.0), pose(navigator, 3.5, 0.0)])
navigator.isTaskComplete()
navigator.cancelTask()
print("cancel", finish(navigator))
navigator.clearAllCostmaps()
costs = navigator.getGlobalCostmap()
print("costmap", costs.metadata.size_x * costs.metadata.size_y == len(costs.data))
rclpy.shutdown()
"""
PLAN_AND_FOLLOW = """
<PipelineSequence>
  <RateController hz="1.0"><ComputePathToPose goal="{goal}" path="{path}" planner_id="GridBased"/></RateController>
  <FollowPath path="{path}" controller_id="FollowPath"/>
</PipelineSequence>
"""


@pytest.fixture
def stage(session, tmp_path):
    new_stage = Stage(session, tmp_path)
    yield new_stage
    new_stage.close()


def give(stage, client, pose):
    handle = stage.until(client.send_goal_async(NavigateToPose.Goal(pose=stage.stamped(pose))))
    assert handle.accepted
    return handle


def check_plans(stage, plans, driven):
    """Where the commands were to lead, and the rest of the path: from where the robot was, to where it came."""
    local, rest = ([msg for topic, msg in plans if topic == name] for name in ("local_plan", "transformed_global_plan"))
    assert {msg.header.frame_id for _, msg in plans} == {"odom"} and len(local) == len(rest) > 50
    begins, ends = ([(msg.poses[k].pose.position.x, msg.poses[k].pose.position.y) for msg in local] for k in (0, -1))
    way = [(place.x, place.y) for place in driven]
    assert all(min(math.dist(begin, place) for place in way) < 0.1 for begin in begins[:: len(begins) // 20])
    assert max(math.dist(begin, end) for begin, end in zip(begins, ends, strict=True)) > 0.3, "they lead on"
    assert math.dist(way[-1], (rest[-1].poses[-1].pose.position.x, rest[-1].poses[-1].pose.position.y)) < 0.4


def test_goals_are_reached_replaced_cancelled_and_refused(stage):
    stage.tell_pose(START)
    client = ActionClient(stage.node, NavigateToPose, "navigate_to_pose")
    assert client.wait_for_server(timeout_sec=5.0)
    first = give(stage, client, Pose2D(8.0, 0.5, 0.0))
    stage.spin(4.0)
    there = Pose2D(3.0, 1.0, 1.5)
    second = give(stage, client, there)
    plans, driven = [], []
    for topic in ("local_plan", "transformed_global_plan"):
        stage.node.create_subscription(Path, topic, lambda msg, topic=topic: plans.append((topic, msg)), 10)
    stage.node.create_subscription(Odometry, "odom", lambda msg: driven.append(msg.pose.pose.position), 10)
    assert stage.until(first.get_result_async()).status == 6  # aborted: replaced
    assert stage.until(second.get_result_async()).status == 4
    assert stage.distance_to(there) < 0.4 and abs(stage.robot.place.theta - 1.5) < 0.4
    check_plans(stage, plans, driven)
    third = give(stage, client, Pose2D(8.0, 0.5, 0.0))
    stage.spin(3.0)
    assert stage.robot.velocity[0] > 0.2
    stage.until(third.cancel_goal_async())
    assert stage.until(third.get_result_async()).status == 5
    stage.spin(0.5)
    assert abs(stage.robot.velocity[0]) < 0.01
    assert stage.touched == {}
    output = stage.launch.output
    assert "Begin navigating from current location" in output and "Goal succeeded" in output
    refused = give(stage, client, Pose2D(1.2, 40.0, 0.0))
    assert stage.until(refused.get_result_async()).status == 6
    assert "is off the global costmap, which reaches from" in stage.launch.output


def test_trees_of_goals_are_gone_and_those_that_are_none_refused(stage, tmp_path):
    stage.tell_pose(START)
    client = ActionClient(stage.node, NavigateToPose, "navigate_to_pose")
    assert client.wait_for_server(timeout_sec=5.0)

    def status(text, pose):
        file = tmp_path / "tree.xml"
        file.write_text(f'<root main_tree_to_execute="M"><BehaviorTree ID="M">{text}</BehaviorTree></root>')
        goal = NavigateToPose.Goal(pose=stage.stamped(pose), behavior_tree=str(file))
        return stage.until(stage.until(client.send_goal_async(goal)).get_result_async()).status

    assert status(PLAN_AND_FOLLOW, Pose2D(1.5, 0.0, 0.0)) == 4 and stage.distance_to(Pose2D(1.5, 0.0, 0.0)) < 0.4
    heading, changes = stage.robot.place.theta, []
    log = "behavior_tree_log"
    heard = stage.node.create_subscription(BehaviorTreeLog, log, lambda msg: changes.extend(msg.event_log), 10)
    assert status('<Sequence><Spin spin_dist="1.0"/><Wait wait_duration="1"/></Sequence>', START) == 4
    assert stage.robot.place.theta - heading == pytest.approx(1.0, abs=0.1)
    told = [f"{one.uid} {one.node_name} {one.current_status}" for one in changes if one.current_status != "IDLE"]
    of_children = [f"{child} {status}" for child in ("2 Spin", "3 Wait") for status in ("RUNNING", "SUCCESS")]
    assert told == ["1 Sequence RUNNING", *of_children, "1 Sequence SUCCESS"]
    assert 0.9 < changes[-1].timestamp.sec - changes[0].timestamp.sec < 10, "each change has its time"
    stage.node.destroy_subscription(heard)
    assert status(PLAN_AND_FOLLOW, Pose2D(1.2, 40.0, 0.0)) == 6
    assert status("<Dance/>", START) == 6
    assert "has a node 'Dance', which is not known here; known are: AlwaysFailure" in stage.launch.output


@pytest.mark.parametrize("when", ["path_becomes_invalid", "goal_is_updated"])
def test_trees_of_nav2_are_driven_under_their_names_on_a_robot(stage, when):
    stage.tell_pose(START)
    client = ActionClient(stage.node, NavigateToPose, "navigate_to_pose")
    assert client.wait_for_server(timeout_sec=5.0)
    file = f"/opt/ros/humble/share/nav2_bt_navigator/behavior_trees/navigate_w_replanning_only_if_{when}.xml"
    for pose in (Pose2D(2.5, 0.5, 0.0), Pose2D(1.0, 0.0, 0.0)):
        goal = NavigateToPose.Goal(pose=stage.stamped(pose), behavior_tree=file)
        assert stage.until(stage.until(client.send_goal_async(goal)).get_result_async()).status == 4
        assert stage.distance_to(pose) < 0.4


def test_a_goal_with_another_tree_is_refused_and_the_first_one_goes_on(stage, tmp_path):
    stage.tell_pose(START)
    client, through = (ActionClient(stage.node, kind, name) for kind, name in (
        (NavigateToPose, "navigate_to_pose"), (NavigateThroughPoses, "navigate_through_poses")))  # fmt: skip
    assert client.wait_for_server(timeout_sec=5.0) and through.wait_for_server(timeout_sec=5.0)
    there = Pose2D(3.0, 1.0, 0.0)
    first = give(stage, client, there)
    stage.spin(3.0)
    assert stage.robot.velocity[0] > 0.2
    pose = stage.stamped(Pose2D(8.0, 0.5, 0.0))
    goal = NavigateToPose.Goal(pose=pose, behavior_tree=str(tmp_path / "other.xml"))
    for refused in (client.send_goal_async(goal), through.send_goal_async(NavigateThroughPoses.Goal(poses=[pose]))):
        assert stage.until(stage.until(refused).get_result_async()).status == 6
    assert stage.until(first.get_result_async()).status == 4 and stage.distance_to(there) < 0.4
    output = stage.launch.output
    assert "Preemption request was rejected since the requested BT XML file is not the same" in output
    assert "Requested navigation from navigate_through_poses while another navigator is processing" in output


def test_a_tree_goes_on_with_a_new_goal_and_knows_it(stage, tmp_path):
    file = tmp_path / "tree.xml"
    planned = '<Sequence><Wait wait_duration="0"/><ComputePathToPose goal="{goal}" path="{path}"/></Sequence>'
    file.write_text(
        '<root main_tree_to_execute="M"><BehaviorTree ID="M"><PipelineSequence>'
        f"<Fallback><Inverter><GlobalUpdatedGoal/></Inverter>{planned}</Fallback><FollowPath path='{{path}}'/>"
        "</PipelineSequence></BehaviorTree></root>"
    )
    stage.tell_pose(START)
    client = ActionClient(stage.node, NavigateToPose, "navigate_to_pose")
    assert client.wait_for_server(timeout_sec=5.0)
    changes, handles = [], []
    stage.node.create_subscription(BehaviorTreeLog, "behavior_tree_log", lambda msg: changes.extend(msg.event_log), 10)
    for pose in (Pose2D(8.0, 0.5, 0.0), Pose2D(3.0, 1.0, 0.0)):
        goal = NavigateToPose.Goal(pose=stage.stamped(pose), behavior_tree=str(file))
        handles.append(stage.until(client.send_goal_async(goal)))
        stage.spin(3.0)
        assert stage.robot.velocity[0] > 0.2, "it drives on"
    assert [stage.until(handle.get_result_async()).status for handle in handles] == [6, 4]
    assert stage.distance_to(pose) < 0.4
    told = [(change.node_name, change.current_status) for change in changes]
    assert told.count(("PipelineSequence", "RUNNING")) == 1, "one tree, which begins once"
    assert told.count(("ComputePathToPose", "SUCCESS")) == 2, "once for each goal"
    assert "Received goal preemption request" in stage.launch.output


def test_a_cart_that_does_not_stop_is_let_by(stage):
    square = ((-0.25, -0.25), (0.25, -0.25), (0.25, 0.25), (-0.25, 0.25))
    ends = ((5.5, 0.0), (-1.0, 0.0))
    stage.simulation.add(Thing("cart", (Prism(square, 0.0, 0.6),), Pose2D(*ends[0], 0.0), mass=30.0))
    stage.movers.append(Mover("cart", ends, 0.4))
    stage.tell_pose(START)
    client = ActionClient(stage.node, NavigateToPose, "navigate_to_pose")
    assert client.wait_for_server(timeout_sec=5.0)
    there = Pose2D(4.5, 0.0, 0.0)
    assert stage.until(give(stage, client, there).get_result_async()).status == 4
    assert stage.touched == {} and stage.distance_to(there) < 0.4


def test_a_goal_that_something_stands_on_is_ended_beside_without_going_round_it(stage):
    crate = Pose2D(3.0, 0.3, 0.8)
    stage.simulation.put("crate_1", crate)
    stage.tell_pose(START)
    client = ActionClient(stage.node, NavigateToPose, "navigate_to_pose")
    assert client.wait_for_server(timeout_sec=5.0)
    began = stage.session.clock.steady()
    assert stage.until(give(stage, client, Pose2D(*crate)).get_result_async()).status == 4
    assert stage.touched == {} and 0.3 < stage.distance_to(Pose2D(*crate)) < 0.8
    assert (stage.session.clock.steady() - began) * 1e-9 < 20.0


def test_a_path_through_a_place_that_is_taken_goes_on_from_beside_it(stage):
    square = ((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1))
    stage.simulation.add(Thing("post", (Prism(square, 0.0, 0.6),), Pose2D(2.0, 0.3, 0.0), mass=30.0))
    stage.tell_pose(START)
    stage.spin(2.0)
    client = ActionClient(stage.node, ComputePathThroughPoses, "compute_path_through_poses")
    assert client.wait_for_server(timeout_sec=5.0)
    goals = [stage.stamped(Pose2D(1.9, 0.3, 0.0)), stage.stamped(Pose2D(3.5, 0.3, 0.0))]
    handle = stage.until(client.send_goal_async(ComputePathThroughPoses.Goal(goals=goals)))
    path = [pose.pose.position for pose in stage.until(handle.get_result_async()).result.path.poses]
    assert max(math.dist((a.x, a.y), (b.x, b.y)) for a, b in pairwise(path)) < 0.1
    assert min(math.dist((position.x, position.y), (1.9, 0.3)) for position in path) > 0.15


def test_parameters_set_while_it_runs_are_obeyed(stage, ros2):
    stage.tell_pose(START)
    client = ActionClient(stage.node, NavigateToPose, "navigate_to_pose")
    assert client.wait_for_server(timeout_sec=5.0)
    for name, value in (("FollowPath.max_vel_x", "0.1"), ("FollowPath.max_vel_theta", "0.5")):
        assert "successful" in ros2("param", "set", "/controller_server", name, value)
    give(stage, client, Pose2D(4.0, 0.0, 0.0))
    fastest = 0.0
    for _ in range(20):
        stage.spin(0.2)
        fastest = max(fastest, stage.robot.velocity[0])
    assert 0.05 < fastest < 0.11
    assert "is 0.0: give Hz" in ros2("param", "set", "/controller_server", "controller_frequency", "0.0")
    assert "successful" in ros2("param", "set", "/local_costmap/local_costmap", "obstacle_layer.enabled", "False")
    assert "successful" in ros2("param", "set", "/local_costmap/local_costmap", "robot_radius", "0.3")
    assert "robot_radius is -1.0" in ros2("param", "set", "/local_costmap/local_costmap", "robot_radius", "-1.0")


def test_a_program_with_a_basic_navigator_runs_unchanged(stage):
    program = stage.session.start(lambda: exec(compile(PROGRAM, "program.py", "exec"), {}), name="program")
    for _ in range(400):
        stage.spin(0.25)
        if program.exit_code is not None:
            break
    said = [line for line in program.output.splitlines() if not line.startswith("[")]
    assert said == [
        "path map True True", "go SUCCEEDED True", "spin SUCCEEDED", "backup SUCCEEDED", "cancel CANCELED", "costmap True",
    ]  # fmt: skip
    assert "Begin navigating from current location through 2 poses to (3.50, 0.00)" in stage.launch.output
    assert stage.touched == {} and abs(stage.robot.velocity[0]) < 0.01


def test_what_is_clicked_in_the_view_is_driven_to(stage):
    shown, there = viewer(fixed_frame="map", displays=["Map /map", "Path /plan"]), Pose2D(2.0, 0.3, 0.0)
    shown.tools.use({"tool": "estimate", "x": START.x, "y": START.y, "yaw": START.theta})
    stage.spin(1.5)
    shown.tools.use({"tool": "goal", "x": there.x, "y": there.y, "yaw": there.theta})
    for _ in range(30):
        stage.spin(0.5)
        if "Goal succeeded" in stage.launch.output:
            break
    assert stage.distance_to(there) < 0.4 and stage.touched == {}
    assert shown.status("Path").startswith("Ok")
    shown.close()
