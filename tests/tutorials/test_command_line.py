"""The beginners' pages of the command line: turtlesim, nodes, topics, services, parameters, actions, consoles, bags."""

import pytest

from tests.needs import slashed

SPIN = "'{linear: {x: 2.0, y: 0.0, z: 0.0}, angular: {x: 0.0, y: 0.0, z: 1.8}}'"


@pytest.fixture
def sim(terminal):
    """turtlesim and its keyboard, as the first page starts them."""
    return terminal("ros2 run turtlesim turtlesim_node"), terminal("ros2 run turtlesim turtle_teleop_key", 0.5)


def test_turtlesim_says_where_its_first_turtle_is(sim, said):
    assert "[turtlesim]: Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]" in sim[0].output
    executables = said("ros2 pkg executables turtlesim")
    names = ("draw_square", "mimic", "turtle_teleop_key", "turtlesim_node")
    assert executables == "".join(f"turtlesim {name}\n" for name in names)


def test_nodes_are_listed_renamed_and_described(sim, terminal, said):
    terminal("ros2 run turtlesim turtlesim_node --ros-args --remap __node:=my_turtle", 0.5)
    assert said("ros2 node list") == "/my_turtle\n/teleop_turtle\n/turtlesim\n"
    info = said("ros2 node info /my_turtle")
    assert info.startswith("/my_turtle\n  Subscribers:\n    /parameter_events: rcl_interfaces/msg/ParameterEvent\n")
    assert "  Action Servers:\n    /turtle1/rotate_absolute: turtlesim/action/RotateAbsolute\n  Action Clients:" in info


def test_topics_are_listed_with_types_and_watched(sim, terminal, said):
    topics = ["/parameter_events", "/rosout", "/turtle1/cmd_vel", "/turtle1/color_sensor", "/turtle1/pose"]
    assert said("ros2 topic list").split() == topics
    assert "/turtle1/cmd_vel [geometry_msgs/msg/Twist]\n" in said("ros2 topic list -t")
    told = "Type: geometry_msgs/msg/Twist\nPublisher count: 1\nSubscription count: 1\n"
    assert said("ros2 topic info /turtle1/cmd_vel") == told
    echo = terminal("ros2 topic echo /turtle1/cmd_vel")
    once = said(f"ros2 topic pub --once -w 2 /turtle1/cmd_vel geometry_msgs/msg/Twist {SPIN}")
    assert once.endswith(
        "publisher: beginning loop\npublishing #1: geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3("
        "x=2.0, y=0.0, z=0.0), angular=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=1.8))\n\n"
    )
    assert echo.output == "linear:\n  x: 2.0\n  y: 0.0\n  z: 0.0\nangular:\n  x: 0.0\n  y: 0.0\n  z: 1.8\n---\n"
    terminal(f"ros2 topic pub --rate 1 /turtle1/cmd_vel geometry_msgs/msg/Twist {SPIN}")
    assert "average rate: 62.5" in said("ros2 topic hz /turtle1/pose", 3.0)
    size = "\tMessage size mean: 0.02 KB min: 0.02 KB max: 0.02 KB\n"
    assert said("ros2 topic bw /turtle1/pose", 1.5) == f"Subscribed to [/turtle1/pose]\n1.51 KB/s from 63 messages\n{size}"


def test_services_are_listed_found_and_called(sim, said):
    assert "/spawn\n" in said("ros2 service list") and "/spawn [turtlesim/srv/Spawn]\n" in said("ros2 service list -t")
    assert said("ros2 service type /clear") == "std_srvs/srv/Empty\n"
    assert said("ros2 service find std_srvs/srv/Empty") == "/clear\n/reset\n"
    called = said("ros2 service call /spawn turtlesim/srv/Spawn '{x: 2, y: 2, theta: 0.2, name: \"\"}'")
    assert called == (
        "requester: making request: turtlesim.srv.Spawn_Request(x=2.0, y=2.0, theta=0.2, name='')\n\n"
        "response:\nturtlesim.srv.Spawn_Response(name='turtle2')\n\n"
    )


def test_parameters_are_read_set_dumped_and_loaded(sim, terminal, said, tmp_path):
    assert said("ros2 param list").startswith("/teleop_turtle:\n")
    assert "  background_b\n" in said("ros2 param list /turtlesim")
    assert said("ros2 param get /turtlesim background_g") == "Integer value is: 86\n"
    assert said("ros2 param set /turtlesim background_r 150") == "Set parameter successful\n"
    (tmp_path / "turtlesim.yaml").write_text(said("ros2 param dump /turtlesim"))
    said("ros2 param set /turtlesim background_r 5")
    assert "Set parameter background_r successful\n" in said("ros2 param load /turtlesim turtlesim.yaml")
    sim[0].interrupt()
    sim[0].wait(5)
    terminal("ros2 run turtlesim turtlesim_node --ros-args --params-file turtlesim.yaml", 0.5)
    assert said("ros2 param get /turtlesim background_r") == "Integer value is: 150\n"


def test_actions_are_listed_described_and_sent(sim, said):
    assert said("ros2 action list -t") == "/turtle1/rotate_absolute [turtlesim/action/RotateAbsolute]\n"
    assert said("ros2 action info /turtle1/rotate_absolute") == (
        "Action: /turtle1/rotate_absolute\nAction clients: 1\n    /teleop_turtle\nAction servers: 1\n    /turtlesim\n"
    )
    sent = said("ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute '{theta: 1.57}'")
    waiting = "Waiting for an action server to become available...\n"
    assert sent.startswith(f"{waiting}Sending goal:\n     theta: 1.57\n\nGoal accepted")
    assert "Result:\n    delta: -1.5" in sent and sent.endswith("Goal finished with status: SUCCEEDED\n")


def test_loggers_have_levels_on_the_command_line(terminal):
    process = terminal("ros2 run turtlesim turtlesim_node --ros-args --log-level WARN", 1.0)
    assert "Spawning" not in process.output


def test_bags_are_recorded_described_and_played(sim, terminal, said):
    terminal(f"ros2 topic pub --rate 1 /turtle1/cmd_vel geometry_msgs/msg/Twist {SPIN}")
    recorder = terminal("ros2 bag record -o subset /turtle1/cmd_vel /turtle1/pose", 3.0)
    recorder.interrupt()
    recorder.wait(5)
    info = said("ros2 bag info subset")
    assert "Files:             subset_0.db3\n" in info and "Topic: /turtle1/cmd_vel | Type: geometry_msgs/msg/Twist" in info
    assert "Opened database 'subset/subset_0.db3' for READ_ONLY." in slashed(said("ros2 bag play subset", 10.0))


def test_the_doctor_looks_at_the_set_up(terminal, said):
    terminal("ros2 run turtlesim turtlesim_node", 0.5)
    assert "checks passed" in said("ros2 doctor")
    assert "NETWORK CONFIGURATION" in said("ros2 doctor --report")


def test_many_are_launched_at_once(terminal, said):
    terminal("ros2 launch turtlesim multisim.launch.py", 1.0)
    assert said("ros2 node list") == "/turtlesim1/turtlesim\n/turtlesim2/turtlesim\n"


def test_domains_are_apart(terminal, said, monkeypatch):
    terminal("ros2 run turtlesim turtlesim_node", 0.5)
    monkeypatch.setenv("ROS_DOMAIN_ID", "5")
    assert said("ros2 node list") == ""


def test_node_arguments_rename_remap_and_set(terminal, said):
    names = "--remap __ns:=/demo --remap __node:=my_talker --remap chatter:=my_topic"
    terminal(f"ros2 run demo_nodes_cpp talker --ros-args {names}", 0.5)
    terminal("ros2 run demo_nodes_cpp parameter_blackboard --ros-args -p some_int:=42 -p 'a_string:=Hello world'", 0.5)
    assert said("ros2 node list") == "/demo/my_talker\n/parameter_blackboard\n"
    assert "/demo/my_topic\n" in said("ros2 topic list")
    assert said("ros2 param get /parameter_blackboard some_int") == "Integer value is: 42\n"
    assert said("ros2 param get /parameter_blackboard a_string") == "String value is: Hello world\n"
