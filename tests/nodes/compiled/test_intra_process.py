"""Compiled programs whose nodes ask for it hand messages over within the program, and still speak to all others."""

from __future__ import annotations

import pytest
import rclpy
from std_msgs.msg import String

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
using std_msgs::msg::String;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto options = rclcpp::NodeOptions().use_intra_process_comms(true);
  auto source = rclcpp::Node::make_shared("source", options), sink = rclcpp::Node::make_shared("sink", options);
  auto apart = rclcpp::Node::make_shared("apart");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(source);
  executor.add_node(sink);
  executor.add_node(apart);
  const String * sent = nullptr;
  std::vector<std::shared_ptr<const String>> kept;  // so that no address is used again
  auto owned = sink->create_subscription<String>(
    "owned", 10, [&](String::UniquePtr message, const rclcpp::MessageInfo & info) {
      std::cout << "owned " << (message.get() == sent) << info.get_rmw_message_info().from_intra_process << std::endl;
      kept.push_back(std::move(message));
    });
  auto copied = apart->create_subscription<String>(
    "owned", 10, [&](String::UniquePtr message, const rclcpp::MessageInfo & info) {
      std::cout << "copied " << (message.get() == sent) << info.get_rmw_message_info().from_intra_process << std::endl;
    });
  auto shared = sink->create_subscription<String>(
    "shared", 10, [&](String::ConstSharedPtr message) {std::cout << "shared " << (message.get() == sent) << std::endl;});
  auto seen = sink->create_subscription<String>(
    "shared", 10, [&](const String & message) {std::cout << "seen " << (&message == sent) << std::endl;});
  auto first = sink->create_subscription<String>(
    "both", 2, [&](String::SharedPtr message) {
      std::cout << "first " << message->data << (message.get() == sent) << std::endl;
      kept.push_back(message);
    });
  auto last = sink->create_subscription<String>(
    "both", 2, [&](String::UniquePtr message) {
      std::cout << "last " << message->data << (message.get() == sent) << std::endl;
      kept.push_back(std::move(message));
    });
  auto publish = [&](auto & publisher, const std::string & text) {
      auto message = std::make_unique<String>();
      message->data = text;
      sent = message.get();
      publisher->publish(std::move(message));
    };
  auto to_owned = source->create_publisher<String>("owned", 10), to_shared = source->create_publisher<String>("shared", 10);
  auto to_both = source->create_publisher<String>("both", 10);
  std::cout << to_shared->get_intra_process_subscription_count() << std::endl;
  publish(to_owned, "a");
  executor.spin_all(std::chrono::seconds(0));
  publish(to_shared, "b");
  executor.spin_all(std::chrono::seconds(0));
  for (auto text : {"1", "2", "3"}) {  // the first leaves the queues, which are full
    publish(to_both, text);
  }
  executor.spin_all(std::chrono::seconds(0));
  to_owned->publish(String());
  executor.spin_all(std::chrono::seconds(0));
  tf2_ros::StaticTransformBroadcaster latched(source);  // speaks to all others in spite of the node's wish
  try {
    source->create_publisher<String>("kept", rclcpp::QoS(1).transient_local());
  } catch (const std::invalid_argument & error) {
    std::cout << error.what() << std::endl;
  }
}
"""


@pytest.mark.parametrize("virtual", [True, False])
def test_who_owns_a_message_gets_the_object_itself(build, virtual):
    heard = []
    with (session := Session(virtual=virtual)).use():

        def listen() -> None:
            rclpy.init()
            node = rclpy.create_node("listener")
            node.create_subscription(String, "owned", heard.append, 10)
            rclpy.spin(node)

        listener = session.start(listen, name="listener")
        session.clock.sleep(0.1)
        process = session.launch(make_process(session, build("handing", PROGRAM), name="handing"))
        assert process.wait(20.0) == 0, process.output
        session.clock.sleep(0.1)
        listener.interrupt()
    lines = process.output.splitlines()
    assert lines[0] == "2"
    assert sorted(lines[1:3]) == ["copied 00", "owned 11"]
    assert sorted(lines[3:5]) == ["seen 1", "shared 1"]
    assert sorted(lines[5:9]) == ["first 20", "first 30", "last 20", "last 31"]
    assert sorted(lines[9:11]) == ["copied 00", "owned 00"]
    assert lines[11:] == ["intraprocess communication allowed only with volatile durability"]
    assert [message.data for message in heard] == ["a", ""]
