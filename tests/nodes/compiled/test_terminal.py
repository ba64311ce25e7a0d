"""Compiled programs that set their terminal so that each key comes at once."""

from __future__ import annotations

import pytest

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

PROGRAM = """
#include <signal.h>
#include <termios.h>
#include <unistd.h>
#include "rclcpp/rclcpp.hpp"
static bool g_running = true;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("keyed");
  signal(SIGINT, [](int) {g_running = false;});
  termios before, raw;
  std::cout << tcgetattr(0, &before) << bool(before.c_lflag & ICANON) << std::endl;
  raw = before;
  raw.c_lflag &= ~(ICANON | ECHO);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 1;
  std::cout << tcsetattr(0, TCSANOW, &raw) << tcgetattr(0, &raw) << bool(raw.c_lflag & ICANON) << std::endl;
  rclcpp::Clock steady(RCL_STEADY_TIME);
  auto start = steady.now();
  char c = 0;
  int none = 0;
  while (g_running) {
    ssize_t got = read(0, &c, 1);
    if (got < 0) {
      return 7;
    }
    if (got == 1) {
      std::cout << "key " << int(c) << " " << (none > 0) << std::endl;
    }
    none += got == 0;
  }
  std::cout << (none > 3) << ((steady.now() - start).seconds() > 0.3) << tcsetattr(0, TCSANOW, &before) << std::endl;
}
"""

LOOKING = """
#include <poll.h>
#include <sys/select.h>
#include <unistd.h>
#include "rclcpp/rclcpp.hpp"
static bool is_typed(long microseconds)
{
  fd_set reads;
  FD_ZERO(&reads);
  FD_SET(fileno(stdin), &reads);
  timeval patience{0, microseconds};
  return select(fileno(stdin) + 1, &reads, nullptr, nullptr, &patience) == 1 && FD_ISSET(0, &reads);
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("looking");
  std::cout << is_typed(0) << std::endl;
  int looks = 0;
  while (!is_typed(50000)) {
    ++looks;
  }
  pollfd input{0, POLLIN, 0};
  std::cout << (looks > 2) << poll(&input, 1, -1) << bool(input.revents & POLLIN) << char(getchar()) << std::endl;
  while (getchar() != '\\n') {
  }
  std::cout << is_typed(0) << poll(&input, 1, 20) << input.revents << std::endl;
}
"""


@pytest.mark.parametrize("virtual", [True, False])
def test_it_may_look_for_keys_before_it_reads_them(build, virtual):
    with (session := Session(virtual=virtual)).use():
        process = session.launch(make_process(session, build("looking", LOOKING), name="looking"))
        while not process.output:
            session.clock.sleep(0.1)
        session.clock.sleep(0.5)
        process.write_stdin("xyz\n")
        assert process.wait(10.0) == 0, process.output
    assert process.output.splitlines() == ["0", "111x", "000"]


@pytest.mark.parametrize("virtual", [True, False])
def test_each_key_comes_at_once_and_a_read_need_not_wait(build, virtual):
    with (session := Session(virtual=virtual)).use():
        wanted = []
        process = make_process(session, build("keyed", PROGRAM), name="keyed")
        process.on_wants_keys = lambda: wanted.append(True)
        session.launch(process)
        while "001" not in process.output and "000" not in process.output:
            session.clock.sleep(0.1)
        session.clock.sleep(0.5)
        process.write_stdin("\x1b[A")
        session.clock.sleep(0.3)
        process.interrupt()
        assert process.wait(10.0) == 0, process.output
    lines = [line for line in process.output.splitlines() if "signal_handler" not in line]
    assert lines == ["01", "000", "key 27 1", "key 91 1", "key 65 1", "110"]
    assert wanted == [True]
