"""Managed nodes of compiled programs: their own calls, `ros2 lifecycle`, a launch file."""

from __future__ import annotations

import pytest
import rclpy
from std_msgs.msg import String

from coursekit.processes.executables import find, make_process
from tests.nodes.compiled.conftest import program


@pytest.fixture
def valve(build):
    return build("valve", program("valve.cpp"))


@pytest.fixture
def start(session, valve):
    def started(*words):
        return session.launch(make_process(session, valve, words, name="valve"))

    yield started
    rclpy.try_shutdown()


def lines(process):
    """What a process logged, without the stamps."""
    return [line.split("] ", 2)[-1] for line in process.output.splitlines() if line.startswith("[")]


def test_a_node_goes_through_its_states_by_its_own_calls(session, start):
    process = start()
    session.clock.sleep(0.1)
    said = process.output.splitlines()
    assert said[0] == "unconfigured1 11 configure1unconfigured>configuring shutdown5unconfigured>shuttingdown 25"
    assert said[-1] == "inactive unconfigured inactive 1 unconfigured 1 unconfigured finalized finalized"
    assert lines(process) == [
        "[far.alone]: Error occurred while doing error handling.",
        "[rcl_lifecycle]: No transition matching 4 found for current state unconfigured",
        "[far.alone]: Unable to start transition 4 from current state unconfigured: Transition is not registered., "
        "at ./src/rcl_lifecycle.c:355",
        "[rcl_lifecycle]: No transition matching shutdown found for current state finalized",
    ]


BASE = """
#include "realtime_tools/realtime_publisher.h"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/string.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp_lifecycle::LifecycleNode>("asleep");
  int heard = 0;
  auto listener = node->create_subscription<std_msgs::msg::String>(
    "state", 10, [&heard](std_msgs::msg::String::ConstSharedPtr) {++heard;});
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr base = node->create_publisher<std_msgs::msg::String>("state", 10);
  base->publish(std_msgs::msg::String());
  realtime_tools::RealtimePublisher<std_msgs::msg::String> in_real_time(base);
  in_real_time.lock();
  in_real_time.unlockAndPublish();
  for (int k = 0; k < 50 && heard < 2; ++k) {
    rclcpp::spin_some(node->get_node_base_interface());
    rclcpp::sleep_for(std::chrono::milliseconds(20));
  }
  std::cout << heard << std::endl;
  try {
    rclcpp::init(argc, argv);
  } catch (const rclcpp::ContextAlreadyInitialized & error) {
    std::cout << error.what() << std::endl;
  }
}
"""


def test_a_publisher_of_the_base_class_speaks_in_every_state(session, build):
    process = session.launch(make_process(session, build("base", BASE), [], name="base"))
    assert process.wait(20.0) == 0 and process.output == "2\ncontext is already initialized\n"


def test_ros2_lifecycle_takes_it_through_its_states(session, start, ros2):
    process = start()
    rclpy.init()
    heard = []
    listener = rclpy.create_node("listener")
    listener.create_subscription(String, "opening", heard.append, 10)
    session.clock.sleep(0.2)
    assert ros2("lifecycle", "nodes") == "/valve\n"
    assert ros2("param", "list", "/valve") == "  fault\n  use_sim_time\n"  # not the QoS of its events, as other nodes
    assert ros2("lifecycle", "get", "/valve") == "unconfigured [1]\n"
    assert "- configure [1]\n\tStart: unconfigured\n\tGoal: configuring\n" in ros2("lifecycle", "list", "/valve")
    assert ros2("lifecycle", "set", "/valve", "configure") == "Transitioning successful\n"
    session.clock.sleep(2.5)
    assert (
        lines(process).count(
            "[LifecyclePublisher]: Trying to publish message on the topic '/opening', but the publisher is not activated"
        )
        == 1
    )
    rclpy.spin_once(listener, timeout_sec=0)
    assert not heard
    assert ros2("lifecycle", "set", "/valve", "activate") == "Transitioning successful\n"
    for _ in range(2):
        rclpy.spin_once(listener)
    assert len(heard) == 2
    assert ros2("lifecycle", "set", "/valve", "shutdown") == "Transitioning successful\n"
    assert ros2("lifecycle", "get", "/valve") == "finalized [4]\n"
    told = [line for line in lines(process) if " from " in line and line.startswith("[valve]")]
    assert told == [
        "[valve]: configure from unconfigured [1]",
        "[valve]: activate from inactive [2]",
        "[valve]: shutdown from active [3]",
    ]
    process.interrupt()
    assert process.wait(5.0) == 0


def test_what_fails_and_what_throws_leads_where_it_does_in_rclcpp(session, start, ros2):
    process = start("--ros-args", "-p", "fault:='configure fails'")
    session.clock.sleep(0.2)
    assert ros2("lifecycle", "set", "/valve", "configure") == "Transitioning failed\n"
    assert ros2("lifecycle", "get", "/valve") == "unconfigured [1]\n"
    ros2("param", "set", "/valve", "fault", "activate throws")
    ros2("lifecycle", "set", "/valve", "configure")
    assert ros2("lifecycle", "set", "/valve", "activate") == "Transitioning failed\n"
    assert ros2("lifecycle", "get", "/valve") == "finalized [4]\n"  # on_error is not overridden: FAILURE
    assert "[valve]: Caught exception in callback for transition 13" in lines(process)
    assert "[valve]: Original error: the valve is stuck" in lines(process)


LAUNCH = """
from launch import LaunchDescription
from launch.actions import EmitEvent, RegisterEventHandler
from launch.events import matches_action
from launch_ros.actions import LifecycleNode
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from lifecycle_msgs.msg import Transition


def generate_launch_description():
    valve = LifecycleNode(executable={program!r}, name="intake", namespace="yard", output="screen")
    def change(number):
        return EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(valve), transition_id=number))
    then = [change(Transition.TRANSITION_ACTIVATE)]
    on_inactive = RegisterEventHandler(
        OnStateTransition(target_lifecycle_node=valve, goal_state="inactive", entities=then)
    )
    return LaunchDescription([valve, on_inactive, change(Transition.TRANSITION_CONFIGURE)])
"""


def test_a_launch_file_brings_it_to_work(valve, tmp_path, ros2):
    file = tmp_path / "valve.launch.py"
    file.write_text(LAUNCH.format(program=str(valve)))
    said = ros2("launch", str(file), seconds=4.0)
    assert "[yard.intake]: configure from unconfigured [1]" in said
    assert "[yard.intake]: activate from inactive [2]" in said


MANAGER = """
#include "nav2_lifecycle_manager/lifecycle_manager_client.hpp"
#include "nav2_util/execution_timer.hpp"
#include "nav2_util/lifecycle_utils.hpp"
#include "realtime_tools/thread_priority.hpp"
using namespace std::chrono_literals;
using lifecycle_msgs::msg::Transition;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  nav2_util::ExecutionTimer timer;
  timer.start();
  rclcpp::sleep_for(100ms);
  timer.end();
  std::cout << (timer.elapsed_time() >= 100ms) << (timer.elapsed_time_in_seconds() < 60) << std::endl;
  nav2_util::startup_lifecycle_nodes("/valve");
  nav2_util::LifecycleServiceClient valve("valve");
  std::cout << int(valve.get_state()) << " ";
  nav2_util::reset_lifecycle_nodes(std::vector<std::string>{"valve"}, 5s);
  std::cout << int(valve.get_state(5s)) << valve.change_state(Transition::TRANSITION_ACTIVATE)
            << valve.change_state(Transition::TRANSITION_ACTIVATE, 5s) << std::endl;
  auto node = rclcpp::Node::make_shared("boss");
  using nav2_lifecycle_manager::SystemStatus;
  nav2_lifecycle_manager::LifecycleManagerClient manager("lifecycle_manager", node), nobody("nobody", node);
  std::cout << (manager.is_active() == SystemStatus::INACTIVE) << manager.startup()
            << (manager.is_active(5s) == SystemStatus::ACTIVE) << manager.pause(5s)
            << manager.resume() << manager.reset() << int(valve.get_state()) << manager.startup()
            << manager.shutdown() << int(valve.get_state()) << std::endl;
  std::cout << nobody.startup(1s) << (nobody.is_active(1s) == SystemStatus::TIMEOUT) << std::endl;
  realtime_tools::has_realtime_kernel();
  try {
    nav2_util::startup_lifecycle_nodes("nowhere", 1s, 1);
  } catch (const std::runtime_error & error) {
    std::cout << error.what() << std::endl;
  }
}
"""


def test_nodes_are_brought_up_and_managed_by_nav2_s_clients(session, start, build):
    start()
    manager = ["--ros-args", "-p", "node_names:=[valve]", "-p", "bond_timeout:=0.0"]
    session.start_executable(find("nav2_lifecycle_manager", "lifecycle_manager"), manager, name="lifecycle_manager")
    process = session.launch(make_process(session, build("manager", MANAGER), [], name="manager"))
    assert process.wait(60.0) == 0, process.output
    said = [line for line in process.output.splitlines() if not line.startswith("[")]
    assert said == ["11", "3 101", "1111111114", "01", "change_state service is not available!"]
