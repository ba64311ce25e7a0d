"""Nodes of behaviour trees that a package brings as C++ classes: bt_navigator loads their libraries and ticks them."""

from __future__ import annotations

import re
import shutil

import pytest

from tests.needs import compiler_or_skip
from tests.packages.bt_cases import node, trees, whole
from tests.packages.nav2_told import lines, told
from tests.packages.test_cpp_workspace import SOURCES, colcon

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]

GO = """
from std_srvs.srv import Trigger
photos = []
def take(request, response):
    photos.append(1)
    response.success, response.message = len(photos) < 3, f"number {len(photos)}"
    return response
stage.node.create_service(Trigger, "camera", take)
ask(NavigateToPose, "navigate_to_pose", pose=at(0.6, 0.0))
"""
SHARED = ("k_shift_goal_bt_node", "k_visits_bt_node")


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    compiler_or_skip()
    folder = tmp_path_factory.mktemp("nav_nodes_ws")
    shutil.copytree(SOURCES.parent.parent / "bt_ws" / "src" / "k_nav_nodes", folder / "src" / "k_nav_nodes")
    built = colcon(folder, "build")
    assert built.returncode == 0 and "stderr" not in built.stdout + built.stderr, built.stdout + built.stderr
    return folder


@pytest.fixture
def navigated(workspace):
    """What nav2 says when it drives by a tree, with these libraries besides its own."""

    def drive(tree, body=GO, libraries=SHARED):
        (workspace / "tree.xml").write_text(whole(tree))
        names = ["nav2_follow_path_action_bt_node", *libraries]
        given = {"plugin_lib_names": names, "default_nav_to_pose_bt_xml": str(workspace / "tree.xml")}
        return told(workspace, body, bt_navigator=given)

    return drive


def printed(said):
    """What the nodes have printed themselves."""
    return [line.partition("] ")[2] for line in said.splitlines() if re.match(r"\[bt_navigator-\d+\] (?!\[)", line)]


def test_poses_cross_over_the_blackboard_in_both_directions(navigated):
    tree = node(
        "Sequence", node("ShiftGoal", input_goal="{goal}", by="1.0", output_goal="{beside}", side="{side}"),
        node("Switch2", node("ComputePathToPose", goal="{beside}", path="{path}"), node("AlwaysFailure"),
             node("AlwaysFailure"), variable="{side}", case_1="left", case_2="right"),
        node("FollowPath", path="{path}"),
    )  # fmt: skip
    said = navigated(tree, GO + "print(stage.distance_to(Pose2D(0.6, 1.0, 0.0)) < 0.4)")
    assert "navigate_to_pose succeeded\nTrue" in said
    name = "bt_navigator_navigate_to_pose_rclcpp_node"
    assert ("INFO", "the robot is here, every 10 ms") in lines(said, name)


def test_a_node_keeps_what_it_needs_until_its_tree_ends(navigated):
    photo = node("TakePhoto", service_name="camera", photo="{photo}", taken="{taken}")
    tree = node("Sequence", node("Times", photo, number=2), node("ShowPhoto", photo="{photo}", taken="{taken}"), photo)
    said = navigated(tree)
    assert "navigate_to_pose aborted" in said
    assert printed(said) == ["photo: number 1", "photo: number 2", "shown: 2 of 2", "photo: number 3"]


def test_children_may_be_of_either_language(navigated):
    look = node("Look", ticks=3, angle="{angle}")
    race = node("Race", node("Delay", node("AlwaysSuccess"), delay_msec=45), node("Look", ticks=50, angle="{angle}"))
    tree = node(
        "Sequence", node("SetBlackboard", output_key="angle", value="1"), node("Inverter", node("Inverter", look)),
        node("Times", node("Sequence", look), number=2), node("Repeat", look, num_cycles=2), race,
    )  # fmt: skip
    said = navigated(tree)
    assert "navigate_to_pose succeeded" in said
    assert printed(said) == [*["look"] * 6, "looked away at 10.5"]


def test_nodes_of_a_subtree_have_the_keys_that_it_is_given(navigated):
    put = node("SetBlackboard", output_key="turned", value="1")
    look = node("SubTree", ID="Inner", angle="turned")
    race = node("Race", node("Delay", node("AlwaysSuccess"), delay_msec=45), node("Look", ticks=50, angle="{turned}"))
    said = navigated(trees(node("Sequence", put, look, race), Inner=node("Look", ticks=3, angle="{angle}")))
    assert "navigate_to_pose succeeded" in said
    assert printed(said) == ["look", "look", "looked away at 4.5"]


@pytest.mark.parametrize("inner", [node("TakePhoto", service_name="camera"), node("Wait", wait_duration="1")])
def test_a_subtree_with_a_blackboard_of_its_own_has_no_ros_node(navigated, inner):
    apart = trees(node("SubTree", ID="Inner"), Inner=inner)
    said = [text for level, text in lines(navigated(apart, "stage.spin(3.0)"), "bt_navigator") if level == "ERROR"]
    assert len(said) == 1 and "Blackboard::get() error. Missing key [node]" in said[0]
    together = trees(node("SubTree", ID="Inner", __shared_blackboard="true"), Inner=inner)
    assert "navigate_to_pose succeeded" in navigated(together)


def test_what_a_node_throws_ends_the_goal_and_not_the_navigator(navigated):
    said = navigated(node("Look", ticks=0, angle="1"), GO + 'ask(NavigateToPose, "navigate_to_pose", pose=at(0.6, 0.0))')
    assert said.count("navigate_to_pose aborted") == 2
    text = "Behavior tree threw exception: no time to look. Exiting with failure."
    assert lines(said, "BehaviorTreeEngine") == [("ERROR", text)] * 2
    assert "process has died" not in said


def test_a_wrong_tree_is_told_when_the_navigator_becomes_active(navigated):
    def errors(tree, **words):
        said = lines(navigated(tree, "stage.spin(3.0)", **words), "bt_navigator")
        return [text for level, text in said if level == "ERROR"]

    typo = errors(node("Look", tics=3))
    text = 'Exception when loading BT: Possible typo? In the XML, you tried to remap port "tics" in node [Look / Look]'
    assert len(typo) == 1 and text in typo[0]
    lonely = errors(node("TakePhoto", service_name="nobody"))
    assert len(lonely) == 1 and lonely[0].endswith("Exception when loading BT: Service server TakePhoto not available")
    unknown = errors(node("Look"), libraries=["k_shift_goal_bt_node"])
    assert len(unknown) == 1 and "has a node 'Look', which is not known here" in unknown[0] and "ShiftGoal" in unknown[0]


def test_a_library_that_is_not_there_is_told_as_on_a_robot(navigated):
    said = lines(navigated(node("AlwaysSuccess"), "", libraries=["k_vists_bt_node"]), "bt_navigator")
    text = "Could not load library: libk_vists_bt_node.so: cannot open shared object file: No such file or directory"
    assert ("ERROR", f"Original error: {text}") in said
