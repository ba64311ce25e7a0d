"""Compiled programs that are started by their path, as those in a workspace's `bin`: `ros2 run` takes over."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="elsewhere a program is not told its own words")
NODE = """
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("alone");
  rclcpp::sleep_for(std::chrono::seconds(3));
  std::cout << node->get_name() << " " << argc << " " << argv[1] << " " << argv[2] << std::endl;
  return 5;
}
"""
PLAIN = """
#include <cstdio>
int main() {std::puts("plain");}
"""
EARLY = """
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  std::cout << "before" << std::endl;
  rclcpp::init(argc, argv);
  std::cout << rclcpp::Node("early").get_name() << std::endl;
}
"""
ENV = {**os.environ, "COURSEKIT_TIME": "virtual", "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}


def started(program, *words, **changed):
    command = [str(program), *words]
    return subprocess.run(command, env={**ENV, **changed}, capture_output=True, encoding="utf-8", check=False)


def test_a_node_runs_in_a_session_with_its_own_words_and_code(build):
    done = started(build("alone", NODE), "--turns", "a b", "--ros-args", "-r", "__node:=renamed")
    assert (done.stdout, done.returncode) == ("renamed 6 --turns a b\n", 5), done.stderr


def test_what_it_does_before_init_it_does_once(build):
    assert started(build("early", EARLY)).stdout == "before\nearly\n"


def test_what_asks_for_nothing_needs_no_session(build):
    assert started(build("plain", PLAIN), PATH="/nowhere").stdout == "plain\n"


def test_where_nobody_can_take_over_it_is_told_what_to_type(build):
    done = started(build("alone", NODE), "a", "b", PATH="/nowhere")
    assert done.returncode == 127 and "start it with `ros2 run`" in done.stderr
