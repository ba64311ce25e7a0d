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


BUFFERS = """
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>(
    "mapper", rclcpp::NodeOptions().append_parameter_override("use_sim_time", true));
  tf2_ros::Buffer usual(node->get_clock());
  tf2_ros::Buffer served(node->get_clock(), tf2::BUFFER_CORE_DEFAULT_CACHE_TIME, node);
  geometry_msgs::msg::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.child_frame_id = "base";
  transform.transform.rotation.w = 1;
  usual.setTransform(transform, "test");
  served.setTransform(transform, "test");
  auto timer = rclcpp::create_timer(node, std::make_shared<rclcpp::Clock>(), rclcpp::Duration(0, 100000000), [&] {
      auto known = [](auto & buffer) {return buffer.canTransform("map", "base", tf2::TimePointZero);};
      std::cout << node->now().seconds() << " " << known(usual) << known(served) << std::endl;
    });
  rclcpp::spin(node);
}
"""


def test_a_jump_back_clears_buffers(build):
    with (session := Session(virtual=True)).use():
        process = session.launch(make_process(session, build("mapper", BUFFERS), name="mapper"))
        session.clock.sleep(0.15)
        rclpy.init()
        publisher = rclpy.create_node("clock").create_publisher(Clock, "/clock", 10)
        for seconds in (10, 30, 29):  # a bag that begins again, or a simulator that is reset
            publisher.publish(Clock(clock=Time(sec=seconds)))
            session.clock.sleep(0.1)
        process.interrupt()
        assert process.wait(5.0) == 0, process.output
    lines = process.output.splitlines()
    assert [line for line in lines if line[0].isdigit()] == ["0 11", "10 11", "30 11", "29 00"]
    warned = "Detected jump back in time. Clearing TF buffer."
    said = sorted(line.partition("] [")[2].partition("] ")[2] for line in lines if "Detected" in line)
    assert said == [f"[mapper]: {warned}", f"[tf2_buffer]: {warned}"]
