"""Plugins of nav2 that a package brings as C++ classes: they are built by colcon, and nav2's servers use them."""

from __future__ import annotations

import re
import shutil
import textwrap

import pytest

from tests.needs import compiler_or_skip
from tests.packages.nav2_told import lines, told
from tests.packages.test_cpp_workspace import SOURCES, colcon

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    compiler_or_skip()
    folder = tmp_path_factory.mktemp("nav_ws")
    shutil.copytree(SOURCES.parent.parent / "nav_ws" / "src", folder / "src")
    built = colcon(folder, "build")
    assert built.returncode == 0 and "1 package finished" in built.stdout, built.stdout + built.stderr
    assert "stderr" not in built.stdout + built.stderr
    return folder


def planner(plugin="k_nav/CornerPlanner", **given):
    return {"planner_plugins": ["GridBased"], "GridBased": {"plugin": plugin, **given}}


def test_a_path_is_that_of_the_planner_in_cpp(workspace):
    body = """
    path = ask(ComputePathToPose, "compute_path_to_pose", goal=at(2.0, 1.0)).path
    places = [(round(one.pose.position.x, 1), round(one.pose.position.y, 1)) for one in path.poses]
    print(path.header.frame_id, (2.0, 0.0) in places, places[-1], max(x for x, y in places), len(places))
    path = ask(ComputePathThroughPoses, "compute_path_through_poses", goals=[at(1.0, 0.0), at(1.0, 1.0)]).path
    places = [(round(one.pose.position.x, 1), round(one.pose.position.y, 1)) for one in path.poses]
    print((1.0, 0.0) in places, places[-1])
    ask(ComputePathToPose, "compute_path_to_pose", goal=at(40.0, 0.0))
    ask(ComputePathToPose, "compute_path_to_pose", goal=at(1.5, 0.0))
    """
    said = told(workspace, body, planner_server=planner(step=0.2))
    assert "compute_path_to_pose succeeded\nmap True (2.0, 1.0) 2.0 1" in said
    assert "compute_path_through_poses succeeded\nTrue (1.0, 1.0)\ncompute_path_to_pose aborted" in said
    assert said.count("compute_path_to_pose succeeded") == 2
    spoken = lines(said, "planner_server")
    assert ("INFO", "Created global planner plugin GridBased of type k_nav/CornerPlanner") in spoken
    assert ("INFO", "GridBased: configured in map for base_link") in spoken and ("INFO", "GridBased: activated") in spoken
    assert ("INFO", "layers: static_layer obstacle_layer inflation_layer 89") in spoken
    fault = 'GridBased plugin failed to plan calculation to (40.00, 0.00): "the way leaves the map"'
    assert ("WARN", fault) in spoken
    assert "process has died" not in said


def test_a_goal_is_reached_on_the_path_of_the_planner_in_cpp(workspace):
    body = """
    ask(NavigateToPose, "navigate_to_pose", pose=at(1.5, 0.0))
    print(stage.distance_to(Pose2D(1.5, 0.0, 0.0)) < 0.4)
    """
    assert "navigate_to_pose succeeded\nTrue" in told(workspace, body, planner_server=planner())


def test_a_planner_that_is_not_there_or_throws_is_told_as_on_a_robot(workspace):
    def spoken(**changed):
        body = 'print(ask(ComputePathToPose, "compute_path_to_pose", goal=at(1.0, 0.0)))'
        return lines(told(workspace, body, **changed), "planner_server")

    unknown = next(text for level, text in spoken(planner_server=planner("k_nav/Cornr")) if level == "FATAL")
    assert unknown.startswith(
        "Failed to create global planner. Exception: According to the loaded plugin descriptions the class k_nav/Cornr with "
        "base class type nav2_core::GlobalPlanner does not exist. Declared types are  nav2_navfn_planner/NavfnPlanner"
    )
    assert unknown.endswith(" k_nav/CornerPlanner k_nav/LostPlanner")
    thrown = spoken(planner_server=planner(fault="configure"))
    assert ("ERROR", "Caught exception in callback for transition 10") in thrown
    assert ("ERROR", "Original error: the planner has no compass") in thrown
    lost = spoken(planner_server=planner("k_nav/LostPlanner"))
    assert any(level in ("FATAL", "ERROR") and "k_nav::LostPlanner" in text for level, text in lost)


CHECKERS = {
    "goal_checker_plugins": ["near"],
    "near": {"plugin": "k_nav::NearChecker", "near": 0.35},
    "progress_checker_plugin": "count",
    "count": {"plugin": "k_nav::CountingChecker", "tries": 1000},
}


def controller(plugin="k_nav::Pursuit", **given):
    return {"controller_plugins": ["FollowPath"], "FollowPath": {"plugin": plugin, **given}}


@pytest.mark.parametrize("checkers", [{}, CHECKERS], ids=["checkers of nav2", "checkers in C++"])
def test_the_robot_arrives_with_a_controller_in_cpp(workspace, checkers):
    body = """
    from nav2_msgs.msg import SpeedLimit
    from rclpy.qos import QoSProfile
    limits = stage.node.create_publisher(SpeedLimit, "speed_limit", 10)
    stage.spin(0.5)
    limits.publish(SpeedLimit(speed_limit=50.0, percentage=True))
    stage.spin(0.5)
    begin = stage.session.clock.now()
    ask(NavigateToPose, "navigate_to_pose", pose=at(2.0, 0.5))
    print(stage.distance_to(Pose2D(2.0, 0.5, 0.0)) < 0.4, (stage.session.clock.now() - begin) * 1e-9 > 1.6 / 0.15)
    """
    said = told(workspace, body, planner_server=planner(), controller_server=controller(speed=0.3) | checkers)
    assert "navigate_to_pose succeeded\nTrue True" in said
    spoken = [text for level, text in lines(said, "controller_server")]
    assert "Created controller : FollowPath of type k_nav::Pursuit" in spoken and "pursuit: activated" in spoken
    assert "pursuit: 0.15 m/s" in spoken and "Reached the goal!" in spoken
    assert f"pursuit: near is {0.35 if checkers else 0.25:.2f} m" in spoken and "pursuit: arrived 0, size 60" in spoken
    assert any(re.match(r"pursuit: \d+ poses in map", text) for text in spoken)
    assert ("near: reset" in spoken) == ("near: for 16 corners" in spoken) == bool(checkers)


FOLLOW = """
path = ask(ComputePathToPose, "compute_path_to_pose", goal=at(2.0, 0.0)).path
begin = stage.session.clock.now()
ask(FollowPath, "follow_path", path=path)
print("took", round((stage.session.clock.now() - begin) * 1e-9))
"""


@pytest.mark.parametrize(
    ("given", "patience", "seconds", "expected"),
    [
        ({"fault": "unsure"}, 0.0, 0, [("ERROR", "the controller is not sure")]),
        ({"fault": "unsure"}, 1.0, 1, [("WARN", "the controller is not sure"), ("ERROR", "Controller patience exceeded")]),
        ({"fault": "broken"}, 1.0, 0, [("ERROR", "the controller is broken")]),
    ],
)
def test_a_controller_that_throws_ends_the_goal_not_the_server(workspace, given, patience, seconds, expected):
    wrong = controller(**given) | {"failure_tolerance": patience}
    said = told(workspace, FOLLOW + "ask(FollowPath, 'follow_path', path=path)", controller_server=wrong)
    assert f"follow_path aborted\ntook {seconds}\nfollow_path aborted" in said
    spoken = lines(said, "controller_server")
    assert all(line in spoken for line in expected) and "process has died" not in said


def test_a_progress_checker_in_cpp_ends_a_goal(workspace):
    count = CHECKERS | {"count": CHECKERS["count"] | {"tries": 20}}
    said = told(workspace, FOLLOW, controller_server=controller() | count)
    assert "follow_path aborted\ntook 1" in said
    assert ("ERROR", "Failed to make progress") in lines(said, "controller_server")


def test_a_controller_that_is_not_there_is_told_as_on_a_robot(workspace):
    said = told(workspace, "pass", controller_server=controller("k_nav::Pursued"))
    fatal = [text for level, text in lines(said, "controller_server") if level == "FATAL"]
    assert fatal
    assert fatal[0].startswith("Failed to create controller. Exception: According to the loaded plugin descriptions the")


def fenced(y=1.0, **given):
    fence = {"plugin": "k_nav::FenceLayer", "y": y, **given}
    return {"global_costmap": {"plugins": ["static_layer", "fence", "inflation_layer"], "fence": fence}}


LOOK = """
from nav2_msgs.srv import ClearEntireCostmap, GetCostmap

def call(kind, name):
    client = stage.node.create_client(kind, name)
    client.wait_for_service(timeout_sec=5.0)
    return stage.until(client.call_async(kind.Request()))

costs = call(GetCostmap, "/global_costmap/get_costmap").map
size, x, y = costs.metadata.resolution, costs.metadata.origin.position.x, costs.metadata.origin.position.y
print("costs", *(costs.data[int((to_y - y) / size) * costs.metadata.size_x + int((0.0 - x) / size)]
                 for to_y in (0.0, 0.85, 1.1)))
call(ClearEntireCostmap, "/global_costmap/clear_entirely_global_costmap")
ask(ComputePathToPose, "compute_path_to_pose", goal=at(0.0, 0.5))
ask(ComputePathToPose, "compute_path_to_pose", goal=at(0.0, 2.0))
"""


def test_a_layer_in_cpp_is_a_part_of_the_costmap_and_is_inflated(workspace):
    said = told(workspace, LOOK, planner_server=planner(), **fenced())
    assert re.search(r"costs \d+ 253 254\ncompute_path_to_pose succeeded\ncompute_path_to_pose aborted", said)
    spoken = [text for level, text in lines(said, "global_costmap.global_costmap")]
    assert ('Using plugin "fence"' in spoken, 'Initialized plugin "fence"' in spoken) == (True, True)
    assert {"fence in map", "fence activated", "fence reset", "fence for a radius of 0.21 m"} <= set(spoken)
    assert any(re.fullmatch(r"fence has \d+ x \d+ cells", text) for text in spoken)
    assert any(text.endswith('"there is a wall in the way"') for level, text in lines(said, "planner_server"))


def test_a_fence_is_where_its_parameter_says(workspace):
    said = told(workspace, LOOK, planner_server=planner(), **fenced(y=30.0))
    costs = [int(cost) for cost in re.search(r"costs (\d+) (\d+) (\d+)\n", said).groups()]
    assert max(costs) < 253, costs


def test_a_layer_that_throws_ends_its_server_as_on_a_robot(workspace):
    said = told(workspace, "stage.spin(2.0)", **fenced(fault=True))
    assert "what():  the fence has fallen" in said
    assert re.search(r"\[planner_server-\d+\]: process has died", said)


def behavior(plugin="k_nav/Nod", **given):
    return {"behavior_server": {"behavior_plugins": ["wait", "nod"], "nod": {"plugin": plugin, **given}}}


NOD = """
from geometry_msgs.msg import Twist
from nav2_msgs.action import DummyBehavior, Wait
from std_msgs.msg import String

speeds = []
stage.node.create_subscription(Twist, "cmd_vel", lambda said: speeds.append(said.linear.x), 10)

def nod(word):
    result = ask(DummyBehavior, "nod", command=String(data=word))
    print(word, round(result.total_elapsed_time.sec + result.total_elapsed_time.nanosec * 1e-9, 1))

"""


def test_a_behavior_in_cpp_has_its_own_action(workspace):
    body = """
    stage.spin(1.0)
    nod("yes")
    print(max(speeds) > 0.05, min(speeds) < -0.05, speeds[-1])
    nod("no")
    nod("throw")
    client = ActionClient(stage.node, DummyBehavior, "nod")
    handle = stage.until(client.send_goal_async(DummyBehavior.Goal(command=String(data="ever"))))
    stage.spin(0.5)
    stage.until(handle.cancel_goal_async())
    print("ever", STATUS[stage.until(handle.get_result_async()).status])
    handle = stage.until(client.send_goal_async(DummyBehavior.Goal(command=String(data="ever"))))
    stage.spin(0.5)
    nod("again")
    print("ever", STATUS[stage.until(handle.get_result_async()).status])
    ask(Wait, "wait")
    """
    said = told(workspace, NOD + textwrap.dedent(body), **behavior(seconds=2.0))
    spoken = lines(said, "behavior_server")
    assert "nod succeeded\nyes 2.0\nTrue True 0.0\nnod aborted\nno 0.0\nnod aborted\nthrow 0.0\n" in said, said
    assert "ever canceled\nnod succeeded\nagain 2.0\never aborted\nwait succeeded" in said
    preempted = "Received a preemption request for nod, however feature is currently not implemented. Aborting and stopping."
    assert ("ERROR", preempted) in spoken
    assert ("INFO", "Creating behavior plugin nod of type k_nav/Nod") in spoken and ("INFO", "nod: over") in spoken
    fault = '[nod] [ActionServer] Action server failed while executing action callback: "the neck is stiff"'
    assert ("ERROR", fault) in spoken and ("INFO", "Initial checks failed for nod") in spoken


def test_a_behavior_that_is_not_there_is_told_as_on_a_robot(workspace):
    fatal = [text for level, text in lines(told(workspace, "pass", **behavior("k_nav/Nodd")), "behavior_server")]
    assert any(text.startswith("Failed to create behavior nod of type k_nav/Nodd. Exception: ") for text in fatal)


@pytest.mark.parametrize("word", ["hello", "throw"])
def test_a_task_in_cpp_is_done_at_waypoints(workspace, word):
    body = """
    from nav2_msgs.action import FollowWaypoints
    ask(FollowWaypoints, "follow_waypoints", poses=[at(0.6, 0.0), at(1.2, 0.0)])
    """
    given = {"waypoint_task_executor_plugin": "greet", "greet": {"plugin": "k_nav/Greet", "word": word}}
    said = told(workspace, body, waypoint_follower={**given, "stop_on_failure": True})
    spoken = [text for level, text in lines(said, "waypoint_follower")]
    assert "follow_waypoints aborted" in said and "Created waypoint_task_executor : greet of type k_nav/Greet" in spoken
    if word == "hello":
        assert "hello 0 at 0.6" in spoken and "hello 1 at 1.2" in spoken and "Task execution at waypoint 1 failed!" in spoken
    else:
        assert any(text.endswith('failed while executing action callback: "nobody is there"') for text in spoken)


SMOOTH = """
from builtin_interfaces.msg import Duration
from nav2_msgs.action import SmoothPath
path = ask(ComputePathToPose, "compute_path_to_pose", goal=at(2.0, 0.0)).path
for _ in range(2):
    smooth = ask(SmoothPath, "smooth_path", path=path, max_smoothing_duration=Duration(sec=2))
    print(smooth.was_completed, len(smooth.path.poses) == (len(path.poses) + 1) // 2, smooth.path.header.frame_id)
"""


def smoother(plugin="k_nav/EveryOther", **given):
    return {"smoother_server": {"smoother_plugins": ["thin"], "thin": {"plugin": plugin, **given}}}


def test_a_path_is_smoothed_in_cpp(workspace):
    said = told(workspace, SMOOTH, **smoother())
    assert said.count("smooth_path succeeded\nTrue True map") == 2, said
    spoken = lines(said, "smoother_server")
    assert ("INFO", "Created smoother : thin of type k_nav/EveryOther") in spoken and ("INFO", "thin: activated") in spoken
    assert any(re.fullmatch(r"thin: \d+ poses, 2.0 s, costs yes, outline yes, robot yes", text) for _, text in spoken)


@pytest.mark.parametrize(
    ("given", "status", "level", "expected"),
    [
        ({"fault": "throw"}, "aborted", "ERROR", "the path is too rough"),
        ({"fault": "late"}, "succeeded\nFalse True", "INFO", "Smoother thin did not complete smoothing in specified time"),
        ({"plugin": "k_nav/EveryThird"}, "None", "FATAL", "Failed to create smoother. Exception: According to"),
    ],
)
def test_what_a_smoother_in_cpp_does_wrong_is_told_as_on_a_robot(workspace, given, status, level, expected):
    said = told(workspace, SMOOTH if "fault" in given else "print('smooth_path None')", **smoother(**given))
    assert f"smooth_path {status}" in said and "process has died" not in said
    assert any(at == level and text.startswith(expected) for at, text in lines(said, "smoother_server"))


def test_plugins_in_cpp_go_and_come_again_with_their_servers(workspace):
    body = """
    from nav2_msgs.srv import ManageLifecycleNodes
    client = stage.node.create_client(ManageLifecycleNodes, "/lifecycle_manager_navigation/manage_nodes")
    for command in (ManageLifecycleNodes.Request.RESET, ManageLifecycleNodes.Request.STARTUP):
        print("managed", stage.until(client.call_async(ManageLifecycleNodes.Request(command=command))).success)
    stage.spin(2.0)
    ask(NavigateToPose, "navigate_to_pose", pose=at(0.8, 0.0))
    """
    wanted = {"planner_server": planner(), "controller_server": controller() | CHECKERS, **fenced(), **behavior()}
    said = told(workspace, body, **wanted)
    assert "managed True\nmanaged True\nnavigate_to_pose succeeded" in said
    spoken = [text for level, text in lines(said, "planner_server") if text.startswith("GridBased: ")]
    begun = ["GridBased: configured in map for base_link", "GridBased: activated"]
    assert spoken == [*begun, "GridBased: deactivated", "GridBased: cleaned up", *begun]
    assert "process has died" not in said
