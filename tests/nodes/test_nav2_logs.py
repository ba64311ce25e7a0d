"""What nav2's servers log of their parts, in Humble's order."""

import pytest
from nav2_msgs.srv import ManageLifecycleNodes

from coursekit.geometry.plane import Pose2D
from tests.nodes.nav2_stage import Stage


@pytest.fixture
def stage(session, tmp_path):
    new_stage = Stage(session, tmp_path)
    yield new_stage
    new_stage.close()


def spoken(stage, *names):
    """What nodes have logged, without levels and times."""
    heads = [f"[{name}]: " for name in names]
    return [line[line.index(head) :] for line in stage.launch.output.splitlines() for head in heads if head in line]


def in_order(lines, *wanted):
    places = [lines.index(line) for line in wanted]
    return places == sorted(places)


def test_servers_log_their_plugins_and_what_they_do_before_their_costmap_does_it(stage):
    stage.tell_pose(Pose2D(0.0, 0.0, 0.0))
    client = stage.node.create_client(ManageLifecycleNodes, "/lifecycle_manager_navigation/manage_nodes")
    assert client.wait_for_service(timeout_sec=10.0)
    reset = ManageLifecycleNodes.Request(command=ManageLifecycleNodes.Request.RESET)
    assert stage.until(client.call_async(reset)).success
    controller = spoken(stage, "controller_server", "local_costmap.local_costmap")
    assert in_order(
        controller,
        "[controller_server]: Configuring controller interface",
        "[controller_server]: getting goal checker plugins..",
        "[controller_server]: Controller frequency set to 20.0000Hz",
        "[local_costmap.local_costmap]: Configuring",
        "[controller_server]: Created progress_checker : progress_checker of type nav2_controller::SimpleProgressChecker",
        "[controller_server]: Created goal checker : general_goal_checker of type nav2_controller::SimpleGoalChecker",
        "[controller_server]: Controller Server has general_goal_checker  goal checkers available.",
        "[controller_server]: Created controller : FollowPath of type dwb_core::DWBLocalPlanner",
        "[controller_server]: Controller Server has FollowPath  controllers available.",
    )
    planner = spoken(stage, "planner_server", "global_costmap.global_costmap")
    assert "[planner_server]: Planner Server has GridBased  planners available." in planner
    for word in ("Activating", "Deactivating", "Cleaning up"):
        assert in_order(planner, f"[planner_server]: {word}", f"[global_costmap.global_costmap]: {word}")
        assert in_order(controller, f"[controller_server]: {word}", f"[local_costmap.local_costmap]: {word}")
    smoother = spoken(stage, "smoother_server")
    assert "[smoother_server]: Created smoother : simple_smoother of type nav2_smoother::SimpleSmoother" in smoother
    assert "[smoother_server]: Smoother Server has simple_smoother  smoothers available." in smoother
