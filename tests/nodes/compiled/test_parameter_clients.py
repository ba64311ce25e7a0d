"""Compiled programs: parameters of other nodes, asked, set and watched."""

from __future__ import annotations

import rclpy

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

PROGRAM = """
#include <iostream>
#include "rclcpp/rclcpp.hpp"
using namespace std::chrono_literals;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("manager");
  node->declare_parameter("own", 1);
  rclcpp::SyncParametersClient client(node, "/pump");
  std::cout << client.wait_for_service(5s) << std::endl;
  for (auto & parameter : client.get_parameters({"speed", "label"})) {
    std::cout << parameter.get_name() << " " << parameter.get_type_name() << " " << parameter.value_to_string() << std::endl;
  }
  auto handler = std::make_shared<rclcpp::ParameterEventHandler>(node);
  auto speed = handler->add_parameter_callback(
    "speed", [](const rclcpp::Parameter & p) {std::cout << "heard " << p.as_double() << std::endl;}, "/pump");
  auto own = handler->add_parameter_callback(
    "own", [](const rclcpp::Parameter & p) {std::cout << "own " << p.as_int() << std::endl;});
  auto results = client.set_parameters({rclcpp::Parameter("speed", 2.5), rclcpp::Parameter("speed", "fast")});
  std::cout << results[0].successful << results[1].successful << std::endl;
  std::cout << client.get_parameter<double>("speed") << " " << client.get_parameter<int>("missing", 7) << " "
            << client.has_parameter("label") << client.has_parameter("colour") << std::endl;
  auto tell = [](const char * who) {
      return [who](rcl_interfaces::msg::ParameterEvent::UniquePtr event) {std::cout << who << event->node << std::endl;};
    };
  auto of_sync = client.on_parameter_event(tell("sync "));
  auto of_node = rclcpp::SyncParametersClient::on_parameter_event(node, tell("node "));
  auto of_async = rclcpp::AsyncParametersClient(node).on_parameter_event(tell("async "), rclcpp::QoS(5));
  node->set_parameter(rclcpp::Parameter("own", 2));
  rclcpp::AsyncParametersClient later(node, "/pump");
  auto listed = later.list_parameters({}, 10);
  rclcpp::spin_until_future_complete(node, listed);
  auto & names = listed.get().names;
  std::cout << (std::find(names.begin(), names.end(), "label") != names.end()) << std::endl;
  rclcpp::shutdown();
}
"""


def test_parameters_of_another_node_are_read_set_and_watched(build):
    program = build("manager", PROGRAM)
    with (session := Session(virtual=True)).use():

        def pump() -> None:
            rclpy.init()
            node = rclpy.create_node("pump")
            node.declare_parameter("speed", 1.5)
            node.declare_parameter("label", "north")
            rclpy.spin(node)

        served = session.start(pump, name="pump")
        process = session.launch(make_process(session, program, name="manager"))
        assert process.wait(20.0) == 0, process.output
        served.interrupt()
    assert process.output == (
        "1\nspeed double 1.500000\nlabel string north\nheard 2.5\n10\n2.5 7 10\nown 2\n"
        "sync /manager\nnode /manager\nasync /manager\n1\n"
    )
