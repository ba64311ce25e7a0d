"""Compiled programs in a session, among Python's: messages, services, parameters, threads, crashes, Ctrl-C."""

from __future__ import annotations

import gc
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import psutil

import coursekit.nodes.compiled.host as host
from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

Build = Callable[[str, str], Path]
HOST = Path(host.__file__)

PUBLISHER = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
using namespace std::chrono_literals;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("counter");
  auto publisher = node->create_publisher<std_msgs::msg::String>("count", 10);
  int number = 0;
  auto timer = node->create_wall_timer(
    500ms, [&] {
      std_msgs::msg::String message;
      message.data = std::to_string(++number);
      publisher->publish(message);
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  std::cout << "counted to " << number << std::endl;
}
"""
SUBSCRIBER = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Hearer : public rclcpp::Node
{
public:
  Hearer()
  : Node("hearer")
  {
    subscription_ = create_subscription<std_msgs::msg::String>(
      "count", 10, std::bind(&Hearer::hear, this, std::placeholders::_1));
  }

private:
  void hear(const std_msgs::msg::String::SharedPtr message) {RCLCPP_INFO(get_logger(), "heard %s", message->data.c_str());}
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr subscription_;
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Hearer>());
  rclcpp::shutdown();
}
"""
CLIENT = """
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/rclcpp.hpp"
using Add = example_interfaces::srv::AddTwoInts;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("adder");
  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);
  auto service = node->create_service<Add>(
    "add", [](Add::Request::SharedPtr request, Add::Response::SharedPtr response) {
      response->sum = request->a + request->b;
    });
  auto client = node->create_client<Add>("add");
  auto request = std::make_shared<Add::Request>();
  request->a = 40;
  request->b = 2;
  if (!client->wait_for_service(std::chrono::seconds(1))) {return 1;}
  auto future = client->async_send_request(request);
  executor.add_node(node);
  auto code = executor.spin_until_future_complete(future, std::chrono::seconds(5));
  std::cout << code << " " << future.get()->sum << std::endl;
  rclcpp::shutdown();
}
"""
CRASH = """
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("faulty");
  throw std::runtime_error("nobody catches this");
}
"""
BRIEF = """
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("brief");
  auto service = node->create_wall_timer(std::chrono::milliseconds(1), [] {rclcpp::shutdown();});
  rclcpp::spin(node);
}
"""


def start(session: Session, program: Path) -> Any:
    return session.launch(make_process(session, HOST, [str(program)], name=program.name))


def test_a_publisher_is_heard_by_a_subscriber_at_exact_times(build: Build) -> None:
    publisher, subscriber = build("publisher", PUBLISHER), build("subscriber", SUBSCRIBER)
    with (session := Session(virtual=True)).use():
        counter, hearer = start(session, publisher), start(session, subscriber)
        session.clock.sleep(1.6)
        counter.interrupt()
        hearer.interrupt()
        assert (counter.wait(5.0), hearer.wait(5.0)) == (0, 0)
        signalled = "[INFO] [1700000001.600000000] [rclcpp]: signal_handler(signum=2)\n"
        assert counter.output == f"{signalled}counted to 3\n"
        assert hearer.output == (
            "[INFO] [1700000000.500000000] [hearer]: heard 1\n"
            "[INFO] [1700000001.000000000] [hearer]: heard 2\n"
            "[INFO] [1700000001.500000000] [hearer]: heard 3\n"
            f"{signalled}"
        )


def test_a_service_answers_a_client_of_the_same_program_in_another_thread(build: Build) -> None:
    program = build("adder", CLIENT)
    for virtual in (True, False):
        with (session := Session(virtual=virtual)).use():
            process = start(session, program)
            assert process.wait(20.0) == 0, process.output
            assert process.output == "SUCCESS (0) 42\n"


def test_a_program_that_aborts_leaves_the_graph_and_the_session_goes_on(build: Build) -> None:
    program = build("faulty", CRASH)
    with (session := Session(virtual=True)).use():
        process = start(session, program)
        assert process.wait(5.0) == -6
        assert "nobody catches this" in process.output
        assert not any(node.name == "faulty" for node in session.graph(0).nodes)


def test_starts_and_ends_leave_no_thread_no_file_and_no_process(build: Build) -> None:
    program = build("brief", BRIEF)

    def held() -> tuple[int, int, int]:
        return threading.active_count(), psutil.Process().num_fds(), len(psutil.Process().children(recursive=True))

    for virtual in (True, False):
        with (session := Session(virtual=virtual)).use():
            assert start(session, program).wait(20.0) == 0
            gc.collect()
            before = held()
            for _ in range(20):
                assert start(session, program).wait(20.0) == 0
            gc.collect()
            grown = [later - earlier for later, earlier in zip(held(), before, strict=True)]
            assert max(grown) <= 2, grown  # the last one's own connection may still be closing
