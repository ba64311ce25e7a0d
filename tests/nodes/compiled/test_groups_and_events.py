"""Compiled programs: QoS events, answers that come later, callback groups of their own executors, waiting for a message."""

from __future__ import annotations

import pytest
import rclpy
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

HEAD = """
#include <iostream>
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/wait_for_message.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"
using namespace std::chrono_literals;
using std_msgs::msg::String;
using std_srvs::srv::Trigger;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("probe");
"""
TAIL = """
  rclcpp::shutdown();
}
"""


@pytest.fixture(autouse=True)
def ros_ended():
    yield
    rclpy.try_shutdown()


def started(session, build, name, body):
    return session.launch(make_process(session, build(name, HEAD + body + TAIL), name=name))


def ended(session, build, name, body):
    process = started(session, build, name, body)
    assert process.wait(20.0) == 0, process.output
    return process.output


def test_incompatible_qos_is_told_to_the_callback_or_in_rclcpps_words(build):
    body = """
  rclcpp::PublisherOptions options;
  options.event_callbacks.incompatible_qos_callback = [](rclcpp::QOSOfferedIncompatibleQoSInfo & info) {
      std::cout << "refused " << info.total_count << (info.last_policy_kind == RMW_QOS_POLICY_RELIABILITY) << std::endl;
    };
  auto told = node->create_publisher<String>("told", rclcpp::QoS(1).best_effort(), options);
  auto silent = node->create_publisher<String>("silent", rclcpp::QoS(1).best_effort());
  auto timer = node->create_wall_timer(1s, [] {rclcpp::shutdown();});
  rclcpp::spin(node);
"""
    with (session := Session(virtual=True)).use():
        rclpy.init()
        listener = rclpy.create_node("listener")
        for topic in ("told", "silent"):
            wanted = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE)
            listener.create_subscription(String, topic, lambda _message: None, wanted)
        output = ended(session, build, "events", body)
    assert "refused 11\n" in output
    assert output.count("New subscription discovered on topic '/silent', requesting incompatible QoS") == 1
    assert "Last incompatible policy: RELIABILITY_QOS_POLICY\n" in output and "'/told'" not in output


def test_a_service_may_answer_later(build):
    body = """
  std::shared_ptr<rmw_request_id_t> waiting;
  auto service = node->create_service<Trigger>(
    "later", [&](std::shared_ptr<rmw_request_id_t> header, Trigger::Request::SharedPtr) {waiting = header;});
  auto timer = node->create_wall_timer(2s, [&] {
      Trigger::Response response;
      response.message = "at last";
      service->send_response(*waiting, response);
    });
  auto client = node->create_client<Trigger>("later");
  auto future = client->async_send_request(std::make_shared<Trigger::Request>());
  rclcpp::spin_until_future_complete(node, future);
  std::cout << future.get()->message << " after " << node->now().seconds() - 1700000000 << std::endl;
"""
    with (session := Session(virtual=True)).use():
        assert ended(session, build, "later", body) == "at last after 2\n"


def test_a_group_is_served_by_the_executor_that_it_is_given_to(build):
    body = """
  auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  auto ours = node->create_wall_timer(100ms, [] {std::cout << "node" << std::endl;});
  auto apart = node->create_wall_timer(100ms, [] {std::cout << "group" << std::endl;}, group);
  rclcpp::executors::SingleThreadedExecutor of_node, of_group;
  of_node.add_node(node);
  of_node.spin_once(150ms);
  of_node.spin_once(20ms);
  of_group.add_callback_group(group, node->get_node_base_interface());
  of_group.spin_once(150ms);
  of_group.spin_once(20ms);
"""
    with (session := Session(virtual=True)).use():
        assert ended(session, build, "groups", body) == "node\ngroup\n"


def test_a_program_waits_for_a_message_while_nothing_spins_its_node(build):
    body = """
  String heard;
  bool early = rclcpp::wait_for_message(heard, node, "/words", 500ms);
  bool late = rclcpp::wait_for_message(heard, node, "/words", 5s);
  std::cout << early << late << heard.data << std::endl;
"""
    with (session := Session(virtual=True)).use():
        rclpy.init()
        speaker = rclpy.create_node("speaker")
        publisher = speaker.create_publisher(String, "words", 1)
        process = started(session, build, "waits", body)
        session.clock.sleep(1.0)
        publisher.publish(String(data="hello"))
        assert process.wait(10.0) == 0
        assert process.output == "01hello\n"


def test_what_a_program_publishes_itself_can_be_ignored(build):
    body = """
  rclcpp::SubscriptionOptions options;
  options.ignore_local_publications = true;
  auto deaf = node->create_subscription<String>("talk", 10, [](const String &) {std::cout << "own" << std::endl;}, options);
  auto all = node->create_subscription<String>("talk", 10, [](const String &) {std::cout << "any" << std::endl;});
  auto publisher = node->create_publisher<String>("talk", 10);
  publisher->publish(String());
  rclcpp::spin_some(node);
"""
    with (session := Session(virtual=True)).use():
        assert ended(session, build, "ignores", body) == "any\n"


def test_ctrl_c_is_told_as_rclcpp_tells_it(build):
    with (session := Session(virtual=True)).use():
        process = started(session, build, "spins", "  rclcpp::spin(node);\n")
        session.clock.sleep(1.0)
        process.interrupt()
        assert process.wait(5.0) == 0
        assert process.output == "[INFO] [1700000001.000000000] [rclcpp]: signal_handler(signum=2)\n"
