"""Compiled programs: messages as YAML."""

from __future__ import annotations

import subprocess

PROGRAM = """
#include <iostream>
#include "example_interfaces/srv/add_two_ints.hpp"
#include "geometry_msgs/msg/polygon.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "std_msgs/msg/empty.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"
#include "test_msgs/msg/w_strings.hpp"
int main()
{
  sensor_msgs::msg::JointState state;
  state.header.stamp.sec = 3;
  state.header.frame_id = "a \\"b\\" \\\\";
  state.name = {"left", "right"};
  state.position = {1, 0.25};
  std::cout << sensor_msgs::msg::to_yaml(state) << to_yaml(state, true) << std::endl;
  geometry_msgs::msg::Polygon square;
  square.points.resize(1);
  std::cout << geometry_msgs::msg::to_yaml(square) << geometry_msgs::msg::to_yaml(square, true) << std::endl;
  std_msgs::msg::Empty nothing;
  std::cout << std_msgs::msg::to_yaml(nothing) << std_msgs::msg::to_yaml(nothing, true) << std::endl;
  example_interfaces::srv::AddTwoInts::Request request;
  request.a = -7;
  example_interfaces::srv::to_flow_style_yaml(request, std::cout);
  std_msgs::msg::UInt8MultiArray bytes;
  bytes.data = {65, 0};
  to_block_style_yaml(bytes, std::cout, 2);
}
"""
STATE = """header:
  stamp:
    sec: 3
    nanosec: 0
  frame_id: "a \\"b\\" \\\\"
name:
- "left"
- "right"
position:
- 1.00000
- 0.250000
velocity: []
effort: []
"""
FLOW = (
    '{header: {stamp: {sec: 3, nanosec: 0}, frame_id: "a \\"b\\" \\\\"}, name: ["left", "right"], '
    "position: [1.00000, 0.250000], velocity: [], effort: []}\n"
)
POLYGON = """points:
-
  x: 0.00000
  y: 0.00000
  z: 0.00000
{points: [{x: 0.00000, y: 0.00000, z: 0.00000}]}
"""
REST = """null
null
{a: -7, b: 0}  layout:
    dim: []
    data_offset: 0
  data:
  - 65
  - 0
"""


def test_messages_are_written_as_humble_s_traits_do(build):
    done = subprocess.run([build("yaml", PROGRAM)], capture_output=True, encoding="utf-8", check=True)
    assert done.stdout == STATE + FLOW + POLYGON + REST
