"""Compiled programs whose objects outlive main(), and those that only ask: they end as on a robot, and time goes on."""

from __future__ import annotations

import pytest

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

GLOBAL = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
rclcpp::Node::SharedPtr g_node;
rclcpp::TimerBase::SharedPtr g_timer;
rclcpp::Subscription<std_msgs::msg::String>::SharedPtr g_subscription;
struct Last
{
  ~Last() {std::cout << "last " << g_node->get_name() << std::endl;}
} g_last;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  g_node = rclcpp::Node::make_shared("kept");
  g_subscription = g_node->create_subscription<std_msgs::msg::String>("words", 10, [](std_msgs::msg::String::UniquePtr) {});
  g_timer = g_node->create_wall_timer(std::chrono::milliseconds(20), [] {rclcpp::shutdown();});
  rclcpp::spin(g_node);
  return 3;
}
"""
ASKING = """
#include "rclcpp/rclcpp.hpp"
using namespace std::chrono_literals;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("impatient");
  bool done = false;
  int spins = 0;
  auto timer = node->create_wall_timer(2s, [&] {done = true;});
  while (!done) {
    rclcpp::spin_some(node);
    ++spins;
  }
  RCLCPP_INFO(node->get_logger(), "done: %d", spins < 100000);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  timer->reset();
  for (done = false; !done; ) {
    executor.spin_once(0s);
  }
  RCLCPP_INFO(node->get_logger(), "done again");
}
"""
CPU_CLOCK = """
#include <pthread.h>
#include <time.h>
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  clockid_t id;
  pthread_getcpuclockid(pthread_self(), &id);
  timespec before, after;
  clock_gettime(id, &before);
  rclcpp::sleep_for(std::chrono::seconds(20));
  clock_gettime(id, &after);
  std::cout << (after.tv_sec - before.tv_sec < 10) << std::endl;
}
"""
JOINING = """
#include <future>
#include <thread>
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(rclcpp::Node::make_shared("idle"));
  std::promise<void> never;
  std::thread spinner([&] {executor.spin_until_future_complete(never.get_future());});
  spinner.join();
  std::cout << "joined" << std::endl;
}
"""
LAST_WORDS = """
#include <thread>
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  std::thread([] {
      rclcpp::sleep_for(std::chrono::seconds(1));
      std::cout << "last words" << std::endl;
    }).detach();
  rclcpp::sleep_for(std::chrono::seconds(20));
}
"""

FAILING = """
#include "example_interfaces/action/fibonacci.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
using Add = example_interfaces::srv::AddTwoInts;
using Fibonacci = example_interfaces::action::Fibonacci;
static void fail(const std::string & how)
{
  if (how == "throw") {
    throw std::runtime_error("nothing to add");
  }
  std::abort();
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  std::string how = argv[1], where = argv[2], threads = argv[3];
  auto node = rclcpp::Node::make_shared("failing");
  auto server = node->create_service<Add>("add", [](Add::Request::SharedPtr, Add::Response::SharedPtr) {});
  auto client = node->create_client<Add>("add");
  auto actions = rclcpp_action::create_server<Fibonacci>(
    node, "count", [](auto, auto) {return rclcpp_action::GoalResponse::REJECT;},
    [](auto) {return rclcpp_action::CancelResponse::REJECT;}, [](auto) {});
  auto action_client = rclcpp_action::create_client<Fibonacci>(node, "count");
  if (where == "goal") {
    rclcpp_action::Client<Fibonacci>::SendGoalOptions options;
    options.goal_response_callback = [&](auto) {fail(how);};
    action_client->async_send_goal(Fibonacci::Goal(), options);
  } else {
    client->async_send_request(std::make_shared<Add::Request>(), [&](rclcpp::Client<Add>::SharedFuture) {fail(how);});
  }
  try {
    if (threads == "one") {
      rclcpp::spin(node);
    } else {
      rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);
      executor.add_node(node);
      executor.spin();
    }
  } catch (const std::runtime_error & error) {
    std::cout << error.what() << std::endl;
    rclcpp::sleep_for(std::chrono::seconds(1));
    std::cout << "and goes on" << std::endl;
  }
}
"""

def run(build, name, text, virtual=True):
    with (session := Session(virtual=virtual)).use():
        process = session.launch(make_process(session, build(name, text), name=name))
        return process.wait(30.0), process.output.splitlines()


@pytest.mark.parametrize("virtual", [True, False])
def test_a_node_may_be_global(build, virtual):
    assert run(build, "kept", GLOBAL, virtual) == (3, ["last kept"])


def test_a_loop_that_only_spins_some_lets_time_pass(build):
    code, lines = run(build, "impatient", ASKING)
    assert code == 0
    first, second = lines
    assert first.endswith("[impatient]: done: 1") and "[17000000020" in first.replace(".", "")
    assert second.endswith("[impatient]: done again") and "[17000000040" in second.replace(".", "")


def test_the_cpu_s_clock_of_a_thread_is_no_virtual_one(build):
    assert run(build, "burner", CPU_CLOCK) == (0, ["1"])


@pytest.mark.parametrize("virtual", [True, False])
def test_ctrl_c_ends_a_spin_in_a_thread_that_the_first_thread_waits_for(build, virtual):
    with (session := Session(virtual=virtual)).use():
        process = session.launch(make_process(session, build("joining", JOINING), name="joining"))
        session.clock.sleep(1.0)
        process.interrupt()
        assert process.wait(10.0) == 0
        assert process.output.splitlines()[-1] == "joined"


def test_what_a_thread_writes_before_its_end_is_heard_while_the_others_wait(build):
    with (session := Session(virtual=True)).use():
        process = session.launch(make_process(session, build("last_words", LAST_WORDS), name="last_words"))
        session.clock.sleep(5.0)
        assert process.output == "last words\n"
        process.kill()


@pytest.mark.parametrize("where", ["service", "goal"])
@pytest.mark.parametrize(
    ("how", "threads", "end"),
    [
        ("abort", "one", (-6, [])),
        ("abort", "two", (-6, [])),
        ("throw", "one", (0, ["nothing to add", "and goes on"])),
    ],
)
def test_a_callback_of_a_response_ends_what_called_it_like_any_other(build, capfd, where, how, threads, end):
    with (session := Session(virtual=True)).use():
        words = (how, where, threads)
        process = session.launch(make_process(session, build("failing", FAILING), words, name="failing"))
        assert (process.wait(30.0), process.output.splitlines()) == end
    assert capfd.readouterr().err == ""
