"""Nodes in C++ for Windows: compiled and linked here by zig, run in Wine in a session of Windows' Python; `make windows`."""

from __future__ import annotations

import io
import json
import os
from pathlib import Path

import pytest

from tests.windows import cpp_course, wine

pytestmark = [pytest.mark.slow, pytest.mark.timeout(1800)]
TALKER = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("talker");
  auto publisher = node->create_publisher<std_msgs::msg::String>("words", 10);
  int number = 0;
  auto timer = node->create_wall_timer(
    std::chrono::milliseconds(500), [&] {
      std_msgs::msg::String message;
      message.data = "¡hola " + std::to_string(++number) + "!";
      publisher->publish(message);
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  std::cout << "said " << number << std::endl;
}
"""
LISTENER = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("listener");
  auto heard = node->create_subscription<std_msgs::msg::String>(
    "words", 10, [&](const std_msgs::msg::String & message) {
      RCLCPP_INFO(node->get_logger(), "heard %s", message.data.c_str());
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
}
"""
THREADS = """
#include <windows.h>
#include <conio.h>
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>
#include "rclcpp/rclcpp.hpp"
using namespace std::chrono_literals;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto begin = std::chrono::steady_clock::now();
  auto told = [&](const char * what) {
      auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin).count();
      printf("%s %lld\\n", what, static_cast<long long>((ms + 50) / 100));
    };
  std::mutex lock;
  std::condition_variable came;
  bool is_there = false;
  std::thread other([&] {
      std::this_thread::sleep_for(500ms);
      std::lock_guard<std::mutex> hold(lock);
      is_there = true;
      came.notify_all();
    });
  {
    std::unique_lock<std::mutex> hold(lock);
    told(came.wait_for(hold, 200ms, [&] {return is_there;}) ? "came" : "not yet");
    came.wait(hold, [&] {return is_there;});
    told("came");
  }
  other.join();
  auto answer = std::async(std::launch::async, [] {std::this_thread::sleep_for(1s); return 7;});
  told(answer.wait_for(300ms) == std::future_status::timeout ? "no answer yet" : "an answer");
  std::cout << "answer " << answer.get() << std::endl;
  told("answered");
  time_t before = time(nullptr);
  Sleep(2000);
  told("slept");
  std::cout << "seconds " << time(nullptr) - before << std::endl;
  std::cout << "key " << _kbhit() << std::endl;
  rclcpp::shutdown();
}
"""
PLAIN = """
#include <chrono>
#include <cstdio>
#include <thread>
int main()
{
  printf("begun\\n");
  std::this_thread::sleep_for(std::chrono::seconds(20));
}
"""
BUSY = """
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  printf("begun\\n");
  while (rclcpp::ok()) {
  }
  printf("over\\n");
}
"""
PROGRAMS = {"talker": TALKER, "listener": LISTENER, "threads": THREADS, "plain": PLAIN, "busy": BUSY}
THREADS_SAY = (
    "not yet 2\ncame 5\nno answer yet 8\nanswer 7\nanswered 15\nslept 35\nseconds 2\nkey 0\n"
)
"""In tenths of seconds."""


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    if why := cpp_course.why_no_wine():
        pytest.skip(why)
    tools = cpp_course.tools_for("x86_64-windows-gnu")
    return cpp_course.install(tmp_path_factory.mktemp("far"), tools, PROGRAMS)


def story(prefix: Path, clock: str, name: str) -> list[tuple[int, str]]:
    """How the programs of a story ended, and what they printed."""
    script = Path(__file__).parent / "cpp_session.py"
    paths = [wine.ROOT, wine.ROOT / "coursekit" / "ros"]
    extra = {"PYTHONPATH": ";".join(map(wine.windows_path, paths)), "PYTHONUTF8": "1"}
    words = [wine.windows_path(script), wine.windows_path(prefix), clock, name]
    said = io.BytesIO()
    code = wine.run(wine.PYTHON, *words, extra=extra, seconds=120, to=said)
    assert code == 0, said.getvalue().decode()
    return [(code, text) for code, text in json.loads(said.getvalue().splitlines()[-1])]


def test_a_package_installs_programs_of_windows(prefix: Path) -> None:
    names = sorted(path.name for path in (prefix / "lib" / "far").iterdir())
    assert names == sorted(f"{name}.exe" for name in PROGRAMS)


def test_a_talker_is_heard_at_exact_times_on_the_virtual_clock(prefix: Path) -> None:
    signalled = "[INFO] [1700000001.600000000] [rclcpp]: signal_handler(signum=2)\n"
    heard = "".join(
        f"[INFO] [170000000{at}00000000] [listener]: heard ¡hola {number}!\n"
        for number, at in enumerate(("0.5", "1.0", "1.5"), 1)
    )
    assert story(prefix, "virtual", "pair") == [(0, f"{signalled}said 3\n"), (0, heard + signalled)]


def test_a_talker_is_heard_on_the_wall_clock(prefix: Path) -> None:
    (code, said), (other, heard) = story(prefix, "wall", "pair")
    assert (code, other) == (0, 0)
    assert "said " in said and "heard ¡hola " in heard and heard.count("signal_handler(signum=2)") == 1


@pytest.mark.parametrize("clock", ["virtual", "wall"])
def test_threads_locks_and_sleeps_are_of_the_sessions_time(prefix: Path, clock: str) -> None:
    [(code, said)] = story(prefix, clock, "threads")
    assert code == 0
    if clock == "virtual":
        assert said == THREADS_SAY
    else:  # a busy computer may be late
        assert [line.rpartition(" ")[0] for line in said.splitlines()] == [
            line.rpartition(" ")[0] for line in THREADS_SAY.splitlines()
        ]


@pytest.mark.parametrize("clock", ["virtual", "wall"])
def test_ctrl_c_ends_a_program_that_does_not_catch_it_and_is_seen_by_one_that_computes(prefix: Path, clock: str) -> None:
    plain, (code, said) = story(prefix, clock, "interrupted")
    assert plain == (-2, "begun\n")
    assert code == 0 and said.startswith("begun\n") and said.endswith("over\n")


@pytest.mark.parametrize("target", ["aarch64-macos", "x86_64-macos"])
def test_a_program_links_for_a_mac(target: str, tmp_path: Path) -> None:
    from coursekit.processes.executables import is_compiled_here

    tools = cpp_course.tools_for(target)
    prefix = cpp_course.install(tmp_path, tools, {"talker": TALKER})
    program = prefix / "lib" / "far" / "talker"
    kinds = {"aarch64-macos": 0x0100000C, "x86_64-macos": 0x01000007}  # Mach-O's numbers of processors
    data = program.read_bytes()
    assert data[:4] == b"\xcf\xfa\xed\xfe" and int.from_bytes(data[4:8], "little") == kinds[target]
    assert is_compiled_here(program) and os.access(program, os.X_OK)
