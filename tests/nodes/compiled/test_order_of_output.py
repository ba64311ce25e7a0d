"""What a program prints and what it logs come out in the order in which it does so, as in a robot's terminal."""

from __future__ import annotations

import pytest

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("scribe");
  int turn = 0;
  auto timer = node->create_wall_timer(std::chrono::milliseconds(1), [&] {
        RCLCPP_INFO(node->get_logger(), "logged %d", turn);
        std::cout << "shown " << turn << std::endl;
        RCLCPP_INFO(node->get_logger(), "logged again %d", turn);
        std::cerr << "warned " << turn << std::endl;
        RCLCPP_INFO(node->get_logger(), "logged last %d", turn);
        printf("printed %d\\n", turn);
        if (++turn == 50) {
          rclcpp::shutdown();
        }
      });
  rclcpp::spin(node);
}
"""


@pytest.mark.parametrize("virtual", [True, False], ids=["virtual", "wall"])
def test_lines_of_the_program_stand_between_those_of_its_logger(virtual, build):
    path = build("scribe", PROGRAM)
    with (session := Session(virtual=virtual)).use():
        process = session.launch(make_process(session, path, name="scribe"))
        assert process.wait(30.0) == 0, process.output
    words = ("logged", "shown", "logged again", "warned", "logged last", "printed")
    said = [line.rpartition("]: ")[2] for line in process.output.splitlines()]
    assert said == [f"{word} {turn}" for turn in range(50) for word in words]
