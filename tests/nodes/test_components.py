"""Containers and `ros2 component`, as the composition tutorial uses them."""

import pytest

from coursekit.processes.components import registered


def test_components_are_loaded_listed_and_unloaded(session, run, ros2):
    container = run("rclcpp_components", "component_container")
    session.clock.sleep(0.2)
    assert ros2("component", "list") == "/ComponentManager\n"
    loaded = ros2("component", "load", "/ComponentManager", "composition", "composition::Talker")
    assert loaded == "Loaded component 1 into '/ComponentManager' container node as '/talker'\n"
    loaded = ros2("component", "load", "/ComponentManager", "composition", "composition::Listener")
    assert loaded == "Loaded component 2 into '/ComponentManager' container node as '/listener'\n"
    assert ros2("component", "list") == "/ComponentManager\n  1  /talker\n  2  /listener\n"
    session.clock.sleep(2.5)
    assert "[talker]: Publishing: 'Hello World: 1'" in container.output
    assert "[listener]: I heard: [Hello World: 2]" in container.output
    gone = ros2("component", "unload", "/ComponentManager", "1", "2")
    assert gone == "".join(f"Unloaded component {n} from '/ComponentManager' container node\n" for n in (1, 2))
    assert ros2("node", "list") == "/ComponentManager\n"


def test_a_component_takes_name_namespace_rules_and_parameters(session, run, ros2):
    run("rclcpp_components", "component_container_mt", "--ros-args", "-r", "__node:=box")
    session.clock.sleep(0.2)
    words = ["-n", "tom", "--node-namespace", "/ns", "-r", "chatter:=chat", "-p", "use_sim_time:=true"]
    loaded = ros2("component", "load", "/box", "composition", "composition::Talker", *words, "-q")
    assert loaded == "1  /ns/tom\n"
    assert "/ns/chat\n" in ros2("topic", "list")
    assert ros2("param", "get", "/ns/tom", "use_sim_time") == "Boolean value is: True\n"


def test_what_cannot_be_loaded_or_unloaded_is_said(session, run, ros2):
    run("rclcpp_components", "component_container")
    session.clock.sleep(0.2)
    assert ros2("component", "list", "/nobody") == "Unable to find container node '/nobody'\n"
    refused = ros2("component", "load", "/ComponentManager", "composition", "composition::Painter")
    assert refused.startswith("Failed to load component: Failed to find class with the requested plugin name. ")
    assert "it has: composition::Talker, composition::Listener" in refused
    refused = ros2("component", "unload", "/ComponentManager", "7")
    assert refused.endswith("from '/ComponentManager' container node\n    No node found with unique_id: 7\n")


def test_a_container_that_ends_takes_its_components_along(session, run, ros2):
    container = run("rclcpp_components", "component_container")
    session.clock.sleep(0.2)
    ros2("component", "load", "/ComponentManager", "composition", "composition::Server")
    container.interrupt()
    assert container.wait(10) == 0
    assert ros2("node", "list") == ""


def test_a_container_that_is_killed_takes_its_components_along(session, run, ros2):
    container = run("rclcpp_components", "component_container")
    session.clock.sleep(0.2)
    ros2("component", "load", "/ComponentManager", "composition", "composition::Server")
    container.kill()
    session.clock.sleep(0.2)
    assert (container.exit_code, ros2("node", "list")) == (-9, "")


def test_the_arguments_of_the_container_are_not_those_of_a_component(session, run, ros2):
    words = ["-r", "__node:=box", "-r", "chatter:=news", "-r", "__ns:=/a"]
    run("rclcpp_components", "component_container", "--ros-args", *words)
    session.clock.sleep(0.2)
    assert ros2("component", "load", "/a/box", "composition", "composition::Talker", "-q") == "1  /talker\n"
    topics = ros2("topic", "list").split()
    assert "/chatter" in topics and "/news" not in topics


def test_components_are_listed_by_package(ros2):
    assert ros2("component", "types", "composition").splitlines()[:2] == ["composition::Talker", "composition::Listener"]
    assert "composition\n  composition::Talker\n" in ros2("component", "types")
    assert ros2("component", "types", "nothing") == "Unable to find package 'nothing'\n"


def test_a_component_runs_alone_until_the_interrupt(session, ros2):
    output = ros2("component", "standalone", "composition", "composition::Talker", seconds=3.5)
    assert "[talker]: Publishing: 'Hello World: 2'" in output
    assert ros2("node", "list") == ""


def test_all_four_run_in_one_process(session, run):
    all_four = run("composition", "manual_composition")
    session.clock.sleep(3.5)
    for said in ("I heard: [Hello World: 1]", "Incoming request: [a: 2, b: 3]", "Got result: [5]"):
        assert said in all_four.output
    all_four.interrupt()
    assert all_four.wait(5) == 0


def test_what_is_linked_is_loaded_under_no_name(session, run):
    process = run("composition", "linktime_composition")
    session.clock.sleep(2.5)
    assert [line.split("]: ")[1] for line in process.output.splitlines()[:5]] == [
        "Load library ",
        *(
            f"Instantiate class rclcpp_components::NodeFactoryTemplate<composition::{name}>"
            for name in ("Client", "Listener", "Server", "Talker")
        ),
    ]
    assert "[listener]: I heard: [Hello World: 1]" in process.output


def test_the_launch_file_of_the_demo_starts_a_talker_and_a_listener(ros2):
    output = ros2("launch", "composition", "composition_demo.launch.py", seconds=3.5)
    assert "[talker]: Publishing: 'Hello World: 1'" in output and "[listener]: I heard: [Hello World: 1]" in output


def test_a_static_transform_is_a_component_with_parameters(session, run, ros2):
    run("rclcpp_components", "component_container")
    session.clock.sleep(0.1)
    words = ["-p", "frame_id:=map", "-p", "child_frame_id:=odom", "-p", "translation.x:=1.5"]
    ros2("component", "load", "/ComponentManager", "tf2_ros", "tf2_ros::StaticTransformBroadcasterNode", *words)
    assert "Translation: [1.500, 0.000, 0.000]" in ros2("run", "tf2_ros", "tf2_echo", "map", "odom", seconds=1.5)


NEEDED = {
    "robot_state_publisher": ["robot_description:=<robot name='r'><link name='a'/></robot>"],
    "topic_tools": ["input_topic:=a", "input_topics:=[a, b]", "msgs_per_sec:=1.0", "X:=1", "Y:=2"],
}
SHORT = ("demo_nodes_cpp::ListParameters", "demo_nodes_cpp::SetAndGetParameters")
UNDERLAY_COMPONENTS = [
    (package, plugin) for package, plugins in registered().items() for plugin in plugins if plugin not in SHORT
]


@pytest.mark.parametrize("plugin", SHORT)
def test_a_component_that_is_done_at_once_does_its_work_and_is_not_listed(session, run, ros2, plugin):
    container = run("rclcpp_components", "component_container")
    session.clock.sleep(0.1)
    refused = ros2("component", "load", "/ComponentManager", "demo_nodes_cpp", plugin)
    assert refused == "Failed to load component: Component shut down as soon as it was made\n"
    assert "\nParameter name" in container.output
    assert ros2("component", "list") == "/ComponentManager\n"


@pytest.mark.parametrize(("package", "plugin"), UNDERLAY_COMPONENTS, ids=lambda one: one)
def test_a_component_that_is_listed_loads_under_the_name_it_is_given(session, run, ros2, package, plugin):
    run("rclcpp_components", "component_container")
    session.clock.sleep(0.1)
    words = ["-n", "tom", "--node-namespace", "/ns"]
    words += [word for needed in NEEDED.get(package, ()) for word in ("-p", needed)]
    loaded = ros2("component", "load", "/ComponentManager", package, plugin, *words, "-q")
    assert loaded == "1  /ns/tom\n"
    assert ros2("component", "unload", "/ComponentManager", "1", "-q") == "1\n"


def test_libraries_named_on_the_command_line_give_one_process_their_nodes(session, run, ros2):
    prefix = ros2("pkg", "prefix", "composition").strip()
    libraries = [f"{prefix}/lib/lib{name}_component.so" for name in ("talker", "listener")]
    process = run("composition", "dlopen_composition", *libraries)
    session.clock.sleep(2.5)
    assert [line.split("]: ")[1] for line in process.output.splitlines()[:4]] == [
        f"Load library {libraries[0]}",
        "Instantiate class rclcpp_components::NodeFactoryTemplate<composition::Talker>",
        f"Load library {libraries[1]}",
        "Instantiate class rclcpp_components::NodeFactoryTemplate<composition::Listener>",
    ]
    assert "[listener]: I heard: [Hello World: 2]" in process.output
    assert ros2("node", "list") == "/listener\n/talker\n"
    process.interrupt()
    assert process.wait(10) == 0


def test_a_library_that_cannot_be_loaded_ends_it_as_in_cpp(run):
    process = run("composition", "dlopen_composition")
    assert process.wait(10) == 1
    assert process.output == "Requires at least one argument to be passed with the library to load\n"
    process = run("composition", "dlopen_composition", "/opt/libpainter.so")
    assert process.wait(10) == -6
    told = "instance of 'class_loader::LibraryLoadException'\n  what():  Could not load library /opt/libpainter.so"
    assert told in process.output
