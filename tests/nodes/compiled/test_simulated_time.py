"""Compiled programs follow /clock where their nodes are told to."""

from __future__ import annotations

import rclpy
from builtin_interfaces.msg import Time
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import SetParameters
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Header

from coursekit.processes.executables import make_process

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/header.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("diver");
  auto said = [&](const char * what) {std::cout << what << " " << node->now().seconds() << std::endl;};
  auto timer = rclcpp::create_timer(node, node->get_clock(), rclcpp::Duration(10, 0), [&] {said("timer");});
  auto begun = node->get_clock()->started();
  auto heard = node->create_subscription<std_msgs::msg::Header>(
    "ask", 10, [&](const std_msgs::msg::Header &) {said("asked");});
  std::cout << begun << node->get_clock()->ros_time_is_active() << std::endl;
  rclcpp::spin(node);
}
"""


def seconds_of(session, build, words, settle=lambda node: None):
    """What the program says while /clock goes from 100 s to 130 s, and somebody asks at 105 s."""
    process = session.launch(make_process(session, build("diver", PROGRAM), words, name="diver"))
    session.clock.sleep(0.1)
    rclpy.init()
    node = rclpy.create_node("world")
    clock, ask = node.create_publisher(Clock, "/clock", 10), node.create_publisher(Header, "ask", 10)
    settle(node)
    for second in range(100, 131, 5):
        clock.publish(Clock(clock=Time(sec=second)))
        session.clock.sleep(0.1)
        if second == 105:
            ask.publish(Header())
            session.clock.sleep(0.1)
    process.interrupt()
    assert process.wait(5.0) == 0, process.output
    return [line for line in process.output.splitlines() if "signal" not in line]


def test_a_node_that_is_told_to_has_the_time_of_clock(session, build):
    said = seconds_of(session, build, ["--ros-args", "-p", "use_sim_time:=true"])
    assert said == ["01", "timer 100", "timer 100", "asked 105", "timer 110", "timer 120", "timer 130"]


def test_a_node_may_be_told_later(session, build):

    def tell(node):
        client = node.create_client(SetParameters, "/diver/set_parameters")
        value = ParameterValue(type=ParameterType.PARAMETER_BOOL, bool_value=True)
        request = SetParameters.Request(parameters=[Parameter(name="use_sim_time", value=value)])
        future = client.call_async(request)
        rclpy.spin_until_future_complete(node, future)
        assert future.result().results[0].successful

    said = seconds_of(session, build, [], tell)
    assert said[0] == "10" and "asked 105" in said


SLEEPER = """
#include "rclcpp/rclcpp.hpp"
using namespace std::chrono_literals;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("diver");
  auto clock = node->get_clock();
  auto said = [&](const char * what, bool well) {
      std::cout << what << " " << well << " " << clock->now().seconds() << std::endl;
    };
  std::thread sleeper([&] {
      said("started", clock->wait_until_started());
      said("slept", clock->sleep_for(12s));
      said("until", clock->sleep_until(rclcpp::Time(124, 0, RCL_ROS_TIME)));
      said("in vain", clock->sleep_for(60s));
    });
  rclcpp::spin(node);
  sleeper.join();
}
"""


def test_a_clock_sleeps_by_the_time_of_clock(session, build):
    process = session.launch(
        make_process(session, build("sleeper", SLEEPER), ["--ros-args", "-p", "use_sim_time:=true"], name="sleeper")
    )
    session.clock.sleep(0.1)
    rclpy.init()
    publisher = rclpy.create_node("world").create_publisher(Clock, "/clock", 10)
    for second in range(100, 131):
        publisher.publish(Clock(clock=Time(sec=second)))
        session.clock.sleep(0.1)
    process.interrupt()
    assert process.wait(5.0) == 0, process.output
    said = [line for line in process.output.splitlines() if "signal" not in line]
    assert said == ["started 1 100", "slept 1 112", "until 1 124", "in vain 0 130"]
