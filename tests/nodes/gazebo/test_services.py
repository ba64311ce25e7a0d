"""Gazebo's services beyond spawning: states under their plugin's names, forces, launch arguments."""

import pytest
from gazebo_msgs.msg import EntityState, LinkStates, ModelStates
from gazebo_msgs.srv import (
    ApplyJointEffort,
    ApplyLinkWrench,
    GetEntityState,
    GetModelList,
    JointRequest,
    LinkRequest,
    SetEntityState,
    SetModelConfiguration,
)  # fmt: skip
from geometry_msgs.msg import Vector3
from rosgraph_msgs.msg import Clock

BOX = """<model name='{name}'><pose>{pose}</pose><link name='body'><inertial><mass>2</mass></inertial><collision name='c'>
<geometry><box><size>0.4 0.4 0.4</size></box></geometry></collision></link></model>"""
STATE = """<plugin name='gazebo_ros_state' filename='libgazebo_ros_state.so'><ros><namespace>/gazebo</namespace>
<argument>model_states:=all_models</argument></ros><update_rate>20</update_rate></plugin>"""


@pytest.fixture
def yard(tmp_path, run):
    def start(more="", *argv):
        file = tmp_path / "yard.world"
        boxes = BOX.format(name="a", pose="1 0 0.2 0 0 1.5707963267948966") + BOX.format(name="b", pose="3 0 0.2 0 0 0")
        file.write_text(f"<sdf version='1.6'><world name='yard'>{boxes}{more}</world></sdf>")
        return run("gazebo_ros", "gzserver", str(file), *argv)

    return start


def place(friend, name, service="get_entity_state", frame=""):
    answer = friend.ask(GetEntityState, service, name=name, reference_frame=frame)
    return (answer.state.pose.position.x, answer.state.pose.position.y) if answer.success else None


def test_the_state_plugin_has_the_names_that_the_world_gives_it(yard, friend):
    server = yard(STATE)
    models, links = friend.hear(ModelStates, "/gazebo/all_models"), friend.hear(LinkStates, "/gazebo/link_states")
    friend.spin(1.05)
    assert models[-1].name == ["a", "b"] and links[-1].name == ["a::body", "b::body"] and len(links) in (20, 21)
    assert place(friend, "b", "/gazebo/get_entity_state") == pytest.approx((3.0, 0.0))
    assert place(friend, "b::body", "/gazebo/get_entity_state", "a") == pytest.approx((0.0, -2.0), abs=1e-6)
    assert place(friend, "b::wheel", "/gazebo/get_entity_state") is None
    assert "GetEntityState: entity [b::wheel] does not exist" in server.output
    assert "gazebo_ros_state" not in server.output.split("World")[0], "it is understood"
    state = EntityState(name="a", reference_frame="b")
    state.pose.position.y, state.twist.linear.x = 1.0, 0.5
    assert friend.ask(SetEntityState, "/gazebo/set_entity_state", state=state).success
    assert place(friend, "a", "/gazebo/get_entity_state")[1] == pytest.approx(1.0, abs=1e-3)


def test_a_wrench_pushes_a_link_for_its_time(yard, friend):
    server = yard()
    friend.spin(0.5)
    request = {"link_name": "a::body", "reference_frame": "a::body"}
    wrench = ApplyLinkWrench.Request().wrench
    wrench.force = Vector3(x=20.0)
    duration = ApplyLinkWrench.Request().duration
    duration.sec = 1
    answer = friend.ask(ApplyLinkWrench, "apply_link_wrench", wrench=wrench, duration=duration, **request)
    assert answer.success
    friend.spin(4.0)
    x, y = place(friend, "a")
    assert x == pytest.approx(1.0, abs=1e-3) and 0.5 * (10 - 0.3 * 9.81) < y < 15, "along its own axes, against friction"
    assert place(friend, "a") == pytest.approx((x, y)), "it has come to rest"
    assert place(friend, "b") == pytest.approx((3.0, 0.0))
    duration.sec = -1
    friend.ask(ApplyLinkWrench, "apply_link_wrench", wrench=wrench, duration=duration, link_name="b::body")
    friend.spin(0.5)
    friend.ask(LinkRequest, "clear_link_wrenches", link_name="b::body")
    friend.spin(3.0)
    rest = place(friend, "b")
    friend.spin(1.0)
    assert place(friend, "b") == rest and rest[0] > 3.5
    for wrong, text in (("a", "link does not exist"), ("c::body", "link does not exist")):
        answer = friend.ask(ApplyLinkWrench, "apply_link_wrench", link_name=wrong)
        assert not answer.success and text in answer.status_message
    answer = friend.ask(ApplyLinkWrench, "apply_link_wrench", link_name="a::body", reference_frame="nowhere")
    assert (answer.success, answer.status_message) == (False, "Reference_frame not found")
    wrench.force.x = float("nan")
    assert not friend.ask(ApplyLinkWrench, "apply_link_wrench", link_name="a::body", wrench=wrench).success
    assert server.state == "running"


def test_efforts_are_for_wheels_and_joint_positions_for_robots(yard, spawn, friend):
    yard()
    spawn()
    answer = friend.ask(ApplyJointEffort, "apply_joint_effort", joint_name="left_front_joint", effort=0.1)
    assert (answer.success, answer.status_message) == (True, "Effort on joint [left_front_joint] set")
    assert friend.ask(ApplyJointEffort, "apply_joint_effort", joint_name="none").status_message == "Joint not found"
    friend.ask(JointRequest, "clear_joint_efforts", joint_name="none")
    ask = {"model_name": "rdk", "joint_names": ["a", "b"], "joint_positions": [1.0]}
    assert not friend.ask(SetModelConfiguration, "set_joint_positions", **ask).success
    assert "does not exist" in friend.ask(SetModelConfiguration, "set_joint_positions", model_name="x").status_message


def test_a_robot_of_the_world_s_file_that_has_no_room_is_told_and_the_rest_goes_on(yard, friend):
    robot = BOX.format(name="bot", pose="1 0 0.2 0 0 0").replace(
        "</model>", "<plugin name='p' filename='libgazebo_ros_planar_move.so'/></model>"
    )
    server = yard(robot)
    friend.spin(0.2)
    assert "'a' is in the way" in server.output
    assert friend.ask(GetModelList, "get_model_list").model_names == ["a", "b", "bot"]


def test_launch_arguments_reach_the_server(ros2, tmp_path, friend):
    params = tmp_path / "gazebo.yaml"
    params.write_text("gazebo:\n  ros__parameters:\n    publish_rate: 20.0\n")
    clocks = friend.hear(Clock, "/clock")
    output = ros2(
        "launch", "gazebo_ros", "gazebo.launch.py", "world:=office", f"params_file:={params}", "gui:=false", "verbose:=true",
        "extra_gazebo_args:=--lockstep -s libnone.so", seconds=1.0,
    )  # fmt: skip
    friend.spin(0.1)
    assert "World 'office'" in output and "option --lockstep of Gazebo" in output
    assert clocks[1].clock.nanosec - clocks[0].clock.nanosec == 50_000_000
