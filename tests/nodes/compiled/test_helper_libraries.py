"""Compiled programs: angles, Eigen's classes as messages, diagnostics."""

from __future__ import annotations

import math
import os
import random
import subprocess

import angles
import pytest
import rclpy
from diagnostic_msgs.msg import DiagnosticArray

from coursekit.processes.executables import make_process

ANGLES = """
#include <cstdio>
#include "angles/angles.h"
int main()
{
  double a, b, low, high, turn;
  std::printf("%.6f %.6f\\n", angles::from_degrees(180), angles::to_degrees(1));
  while (std::scanf("%lf %lf %lf %lf", &a, &b, &low, &high) == 4) {
    std::printf(
      "%.6f %.6f %.6f %.6f ", angles::normalize_angle(a), angles::normalize_angle_positive(a),
      angles::shortest_angular_distance(a, b), angles::two_pi_complement(a));
    bool inside = angles::shortest_angular_distance_with_limits(a, b, low, high, turn);
    std::printf("%d %.6f ", inside, turn);
    inside = angles::shortest_angular_distance_with_large_limits(a, b, low, high, turn);
    std::printf("%d %.6f\\n", inside, turn);
  }
}
"""


def as_python_says(a, b, low, high):
    """The line of the program, by the Python module."""
    numbers = [angles.normalize_angle(a), angles.normalize_angle_positive(a)]
    numbers += [angles.shortest_angular_distance(a, b), angles.two_pi_complement(a)]
    words = [f"{number:.6f}" for number in numbers]
    for turn in (angles.shortest_angular_distance_with_limits, angles.shortest_angular_distance_with_large_limits):
        inside, way = turn(a, b, low, high)
        words += [str(int(inside)), f"{way:.6f}"]
    return " ".join(words)


def test_angles_are_those_of_python(build):
    dice = random.Random(5)
    cases = [[dice.uniform(-math.pi, math.pi) for _ in range(4)] for _ in range(200)]
    typed = "".join(" ".join(map(repr, case)) + "\n" for case in cases)
    done = subprocess.run([build("turns", ANGLES)], input=typed, capture_output=True, encoding="utf-8", check=True)
    assert done.stdout.splitlines() == ["3.141593 57.295780", *(as_python_says(*case) for case in cases)]


EIGEN = """
#include <iostream>
#include "rclcpp/rclcpp.hpp"
#include "tf2_eigen/tf2_eigen.hpp"
#include "tf2_ros/buffer.h"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  geometry_msgs::msg::TransformStamped transform;
  transform.header.frame_id = "base";
  transform.child_frame_id = "arm";
  transform.transform.translation.x = 1;
  transform.transform.rotation.z = transform.transform.rotation.w = std::sqrt(0.5);
  Eigen::Isometry3d motion = tf2::transformToEigen(transform);
  std::cout << (motion * Eigen::Vector3d(2, 0, 0)).transpose() << std::endl;
  auto back = tf2::eigenToTransform(motion);
  std::cout << back.transform.translation.x << " " << back.transform.rotation.z << std::endl;
  tf2_ros::Buffer buffer(std::make_shared<rclcpp::Clock>());
  buffer.setTransform(transform, "test", true);
  tf2::Stamped<Eigen::Vector3d> place(Eigen::Vector3d(0, 3, 0), tf2::TimePointZero, "arm");
  auto there = buffer.transform(place, "base");
  std::cout << tf2_ros::timeToSec(rclcpp::Time(3, 500000000)) << " ";
  std::cout << there.array().round().transpose() << " " << there.frame_id_ << std::endl;
  geometry_msgs::msg::Pose pose = tf2::toMsg(motion);
  Eigen::Affine3d read;
  tf2::fromMsg(pose, read);
  geometry_msgs::msg::Point point;
  tf2::convert(Eigen::Vector3d(4, 5, 6), point);
  Eigen::Quaterniond turn;
  tf2::convert(pose.orientation, turn);
  std::cout << read.isApprox(Eigen::Affine3d(motion)) << point.z << " " << turn.z() << std::endl;
  Eigen::VectorXd push(6), moved;
  push << 3, 0, 0, 0, 0, 1;  // a force and a torque
  tf2::doTransform(push, moved, transform);
  geometry_msgs::msg::Accel accel;
  accel.linear.x = 1;
  accel.angular.z = 2;
  Eigen::Matrix<double, 6, 1> six;
  tf2::fromMsg(accel, six);
  std::cout << moved.array().round().abs().transpose() << std::endl;
  std::cout << six.transpose() << " " << tf2::toMsg2(push.head<3>()).x << std::endl;
}
"""


@pytest.mark.skipif(not os.path.isdir("/usr/include/eigen3"), reason="needs libeigen3-dev")
def test_eigen_s_classes_become_messages_and_are_transformed(session, build):
    process = session.launch(make_process(session, build("eigen", EIGEN), name="eigen"))
    assert process.wait(20.0) == 0, process.output
    lines = process.output.splitlines()
    assert lines[:4] == ["1 2 0", "1 0.707107", "3.5 -2 -0  0 base", "16 0.707107"]
    assert lines[4:] == ["0 3 0 0 0 4", "1 0 0 0 0 2 3"]


DIAGNOSTICS = """
#include "diagnostic_updater/diagnostic_updater.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rcutils/logging_macros.h"
class Pump : public rclcpp::Node
{
public:
  Pump()
  : Node("pump"),
    updater_(
      get_node_base_interface(), get_node_clock_interface(), get_node_logging_interface(), get_node_parameters_interface(),
      get_node_timers_interface(), get_node_topics_interface())
  {
    updater_.setHardwareIDf("pump %d", 3);
    updater_.add("pressure", this, &Pump::pressure);
    updater_.add("level", [](diagnostic_updater::DiagnosticStatusWrapper & status) {
        status.summaryf(diagnostic_msgs::msg::DiagnosticStatus::OK, "%d %%", 80);
        status.mergeSummary(diagnostic_msgs::msg::DiagnosticStatus::WARN, "falls");
      });
  }
private:
  void pressure(diagnostic_updater::DiagnosticStatusWrapper & status)
  {
    status.summary(diagnostic_msgs::msg::DiagnosticStatus::OK, "steady");
    status.mergeSummary(diagnostic_msgs::msg::DiagnosticStatus::OK, "of two good ones the first stays");
    status.add("bar", 2.5);
    status.addf("raw", "%04d", 12);
    status.add("open", true);
    RCUTILS_LOG_INFO_THROTTLE(RCUTILS_STEADY_TIME, 60000, "pressure is told");
  }
  diagnostic_updater::Updater updater_;
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Pump>());
  rclcpp::shutdown();
}
"""


def test_diagnostics_are_told_each_period(session, build):
    rclpy.init()
    node = rclpy.create_node("watch")
    heard = []
    node.create_subscription(DiagnosticArray, "/diagnostics", heard.append, 10)
    process = session.launch(make_process(session, build("pump", DIAGNOSTICS), name="pump"))
    executor = rclpy.executors.SingleThreadedExecutor()
    executor.add_node(node)
    end = session.clock.now() + 3_500_000_000
    while session.clock.now() < end:
        executor.spin_once(0.1)
    process.interrupt()
    assert process.wait(5.0) == 0, process.output
    starting = [status for message in heard for status in message.status if status.message == "Node starting up"]
    assert {status.name for status in starting} <= {"pump: pressure", "pump: level"}
    assert process.output.count("pressure is told") == 1
    reports = [message for message in heard if len(message.status) == 2]
    assert len(reports) == 3
    pressure, level = reports[-1].status
    assert (pressure.name, pressure.hardware_id, pressure.message) == ("pump: pressure", "pump 3", "steady")
    assert [(value.key, value.value) for value in pressure.values] == [("bar", "2.5"), ("raw", "0012"), ("open", "True")]
    assert (level.message, level.level) == ("falls", b"\x01")
