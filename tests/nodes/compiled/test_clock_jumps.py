"""Compiled programs are told of jumps of their nodes' time."""

from __future__ import annotations

import rclpy
from builtin_interfaces.msg import Time
from rosgraph_msgs.msg import Clock

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>(
    "watcher", rclcpp::NodeOptions().append_parameter_override("use_sim_time", true));
  rcl_jump_threshold_t threshold{true, {2000000000}, {-1}};
  int told = 0;
  auto handler = node->get_clock()->create_jump_callback(
    [&] {std::cout << "before" << std::endl;},
    [&](const rcl_time_jump_t & jump) {
      std::cout << jump.clock_change << " " << (jump.clock_change == RCL_ROS_TIME_NO_CHANGE ? jump.delta.nanoseconds : 0)
                << std::endl;
      ++told;
    }, threshold);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (rclcpp::ok() && told < 3) {
    executor.spin_once(std::chrono::milliseconds(100));
  }
  handler.reset();
  std::cout << "no more" << std::endl;
  executor.spin();
  rclcpp::Clock steady(RCL_STEADY_TIME);
  std::cout << (steady.create_jump_callback(nullptr, nullptr, threshold) != nullptr) << std::endl;
}
"""


def test_jumps_that_reach_the_threshold_are_told(build):
    with (session := Session(virtual=True)).use():
        process = session.launch(make_process(session, build("watcher", PROGRAM), name="watcher"))
        session.clock.sleep(0.1)
        rclpy.init()
        publisher = rclpy.create_node("clock").create_publisher(Clock, "/clock", 10)
        for seconds in (10, 11, 15, 14, 30):  # a second is no jump here
            publisher.publish(Clock(clock=Time(sec=seconds)))
            session.clock.sleep(0.1)
        process.interrupt()
        assert process.wait(5.0) == 0, process.output
    told = [line for line in process.output.splitlines() if "signal" not in line]
    assert told == ["before", "1 10000000000", "before", "1 4000000000", "before", "1 -1000000000", "no more", "1"]
