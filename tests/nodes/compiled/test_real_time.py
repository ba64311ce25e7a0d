"""Compiled programs that measure how well their loops keep time: rttest, its times, and the allocator that goes with it."""

from __future__ import annotations

import subprocess
import sys

import pytest

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="rttest is Linux's")
LOOP = """
#include <pthread.h>
#include "pendulum_msgs/msg/joint_state.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/strategies/allocator_memory_strategy.hpp"
#include "rclcpp/strategies/message_pool_memory_strategy.hpp"
#include "rttest/rttest.h"
#include "rttest/utils.hpp"
#include "tlsf_cpp/tlsf.hpp"
using pendulum_msgs::msg::JointState;
struct Loop : rclcpp::Executor
{
  explicit Loop(const rclcpp::ExecutorOptions & options)
  : rclcpp::Executor(options) {}
  void spin() override {rttest_spin(turn, this);}
  static void * turn(void * given)
  {
    auto self = static_cast<Loop *>(given);
    self->spin_some();
    ++self->turns;
    self->told += rttest_get_statistics(&self->results) == 0;
    return nullptr;
  }
  int turns = 0, told = 0;
  rttest_results results {};
};
void * tick(void * count)
{
  timespec period;
  uint64_to_timespec(2000000, &period);
  for (int i = 0; i < 10; ++i) {
    clock_nanosleep(CLOCK_MONOTONIC, 0, &period, nullptr);
    ++*static_cast<int *>(count);
  }
  return nullptr;
}
int main(int argc, char ** argv)
{
  int ticks = 0;
  pthread_t thread;
  pthread_create(&thread, nullptr, tick, &ticks);
  std::cout << "began " << rttest_read_args(argc, argv) << rttest_running() << std::endl;
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("joint");
  int heard = 0;
  auto pool = std::make_shared<rclcpp::strategies::message_pool_memory_strategy::MessagePoolMemoryStrategy<JointState, 1>>();
  auto subscription = node->create_subscription<JointState>(
    "state", rclcpp::QoS(1).best_effort(), [&](JointState::ConstSharedPtr) {++heard;}, rclcpp::SubscriptionOptions(), pool);
  auto publisher = node->create_publisher<JointState>("state", rclcpp::QoS(1).best_effort());
  auto timer = node->create_wall_timer(std::chrono::milliseconds(5), [&] {publisher->publish(JointState());});
  rclcpp::ExecutorOptions options;
  using Heap = tlsf_heap_allocator<void>;
  options.memory_strategy =
    std::make_shared<rclcpp::memory_strategies::allocator_memory_strategy::AllocatorMemoryStrategy<Heap>>();
  Loop loop(options);
  loop.add_node(node);
  loop.spin();
  int64_t sample = -1;
  std::cout << loop.turns << " " << loop.told << " " << (heard >= 7) << " " << (ticks == 10) << " "
            << rttest_get_sample_at(3, &sample) << (sample >= 0) << rttest_get_sample_at(40, &sample)
            << rttest_write_results() << std::endl;
  const int ended = rttest_finish();
  std::cout << "ended " << ended << rttest_running() << rttest_finish() << std::endl;
  rclcpp::shutdown();
  pthread_join(thread, nullptr);
}
"""


@pytest.mark.parametrize("virtual", [True, False], ids=["virtual", "wall"])
def test_a_loop_is_measured_turn_by_turn(build, virtual, tmp_path):
    turn_ms = 1 if virtual else 10  # a busy computer's timer comes late
    argv = ["-i", "40", "-u", f"{turn_ms}ms", "-f", "times.txt"]
    with (session := Session(virtual=virtual)).use():
        loop = session.launch(make_process(session, build("loop", LOOP), argv, name="loop", cwd=str(tmp_path)))
        assert loop.wait(20.0) == 0, loop.output
    lines = loop.output.splitlines()
    lines.remove("Writing results to file: times.txt")  # to standard error, whose place among the others is not fixed
    assert lines[0] == "began 01"
    assert [line.partition(":")[0] for line in lines[1:3]] == ["Initial major pagefaults", "Initial minor pagefaults"]
    assert lines[3] == "40 39 1 1 01-10"
    assert lines[4] == "rttest statistics for times.txt:" and lines[7].startswith("  Latency")
    assert lines[-1] == "ended 00-1"
    if virtual:
        assert lines[8:10] == ["    - Min: 0 ns", "    - Max: 0 ns"]
        assert lines[10:12] == ["    - Mean: 0.000000 ns", "    - Standard deviation: 0.000000"]
    rows = (tmp_path / "times.txt").read_text().splitlines()
    assert rows[0] == "iteration timestamp latency minor_pagefaults major_pagefaults"
    assert len(rows) == 41 and rows[40].startswith(f"39 {39 * turn_ms}000000 ")


GIVEN_UP = """
#include "rclcpp/rclcpp.hpp"
#include "rttest/rttest.h"
static int g_turns = 0;
static void * turn(void *)
{
  if (++g_turns == 3) {
    rttest_finish();
  }
  return nullptr;
}
int main(int argc, char ** argv)
{
  rttest_read_args(argc, argv);
  rttest_spin(turn, nullptr);
  std::cout << "turns " << g_turns << " " << rttest_running() << std::endl;
}
"""


@pytest.mark.parametrize("turns", ["40", "0"])
def test_a_loop_that_is_given_up_meanwhile_ends_without_an_error(build, turns):
    with (session := Session(virtual=True)).use():
        path = build("given_up", GIVEN_UP)
        loop = session.launch(make_process(session, path, ["-i", turns, "-u", "1ms"], name="loop"))
        assert loop.wait(20.0) == 0, loop.output
    assert loop.output.splitlines()[-1].startswith("turns 3 ")


TIMES = """
#include <iostream>
#include "rttest/utils.hpp"
#include "tlsf_cpp/tlsf.hpp"
#include <vector>
int main()
{
  timespec a{1, 900000000}, b{0, 200000000}, c;
  add_timespecs(&a, &b, &c);
  std::cout << c.tv_sec << " " << c.tv_nsec << std::endl;
  subtract_timespecs(&b, &a, &c);
  std::cout << c.tv_sec << " " << c.tv_nsec << " " << timespec_gt(&a, &b) << timespec_gt(&b, &a) << std::endl;
  multiply_timespec(&b, 7, &c);
  std::cout << c.tv_sec << " " << c.tv_nsec << " " << timespec_to_uint64(&c) << std::endl;
  std::vector<int, tlsf_heap_allocator<int>> numbers(3, 5, tlsf_heap_allocator<int>(1 << 16));
  numbers.push_back(6);
  tlsf_heap_allocator<void> same;
  std::cout << numbers[3] << (numbers.get_allocator() == same) << (numbers.get_allocator().pool_size >> 16) << std::endl;
}
"""


def test_times_are_added_and_a_vector_uses_the_allocator(build):
    done = subprocess.run([build("times", TIMES)], capture_output=True, encoding="utf-8", check=True)
    assert done.stdout.splitlines() == ["2 100000000", "1 700000000 10", "1 400000000 1400000000", "611"]
