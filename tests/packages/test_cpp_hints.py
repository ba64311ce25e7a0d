"""The compiler's and CMake's own words for beginners' mistakes, and what they are told."""

import pytest

from coursekit.packages.cpp_hints import hints

SAID = {
    "src/a.cpp:9:30: error: expected ‘;’ before ‘return’": "a.cpp:9: a statement ends with ;",
    "src/a.cpp:9:30: error: expected ‘,’ or ‘;’ before ‘int’": "a.cpp:9: a statement ends with ;",
    "src/a.cpp:9:30: error: expected ';' after expression": "a.cpp:9: a statement ends with ;",
    "a.cpp:2:10: fatal error: std_msgs/msg/String.hpp: No such file or directory": '"std_msgs/msg/string.hpp"',
    "a.cpp:2:10: fatal error: 'sensor_msgs/msg/LaserScan.hpp' file not found": '"sensor_msgs/msg/laser_scan.hpp"',
    "a.cpp:1:10: fatal error: rclcp/rclcpp.hpp: No such file or directory": "find_package()",
    "a.cpp:1:10: fatal error: robot.hpp: No such file or directory": "target_include_directories()",
    'CMake Error at CMakeLists.txt:19 (x):\n  Unknown CMake command "rosidl_generate_interfaces".': (
        "CMakeLists.txt:19: rosidl_generate_interfaces() comes with rosidl_default_generators"
    ),
    'CMake Error at CMakeLists.txt:9 (x):\n  Unknown CMake command "ament_target_dependencies".': "comes with ament_cmake",
    "CMake Error at CMakeLists.txt:12 (message):\n  ament_target_dependencies() the passed package name 'std_msgs' was not\n"
    "  found before": "write find_package(std_msgs REQUIRED)",
    'CMake Error at CMakeLists.txt:6 (x):\n  By not providing "Findrclcp.cmake" in CMAKE_MODULE_PATH': "no package rclcp",
    "CMake Error at CMakeLists.txt:9 (x):\n  Cannot find source file:\n\n    src/talkr.cpp": "no file src/talkr.cpp",
    'CMake Error at CMakeLists.txt:9 (install):\n  install TARGETS given target "talkr" which does not exist.': "makes it",
    "CMake Error at x/rosidl_cmake.cmake:35 (message):\n  the passed dependency 'nav_msgs' has\n"
    "  not been found before using find_package()": "write find_package(nav_msgs REQUIRED)",
    "CMake Error at x/rosidl_cmake.cmake:14 (message):\n  '/ws/src/a/msg/B.msg' must be represented as an absolute\n"
    "  base path separated by a colon": "RELATIVE",
    "CMake Error at x/ament_cmake.cmake:16 (message):\n  ament_export_libraries() must be called before ament_package()": (
        "move ament_export_libraries() above it"
    ),
    "a.cpp:7:3: error: ‘cout’ was not declared in this scope; did you mean ‘std::cout’?": "write std::cout",
    "a.cpp:7:3: error: use of undeclared identifier 'make_shared'": "write std::make_shared",
    "a.cpp:7:8: error: ‘vector’ is not a member of ‘std’": "add #include <vector>",
    "a.cpp:7:30: error: ‘_1’ was not declared in this scope": "std::placeholders::_1",
    "a.cpp:7:3: error: ‘spin’ was not declared in this scope": "rclcpp::",
    "a.cpp:7:3: error: ‘std_msgs’ was not declared in this scope": "include the message's header",
    'a.cpp:7:9: error: unable to find numeric literal operator ‘operator""ms’': "std::chrono_literals",
    "a.cpp:7:9: error: ‘class std_msgs::msg::String’ has no member named ‘dta’": "ros2 interface show",
    "a.cpp:7:9: error: ‘using SharedPtr = class std::shared_ptr<a::B>’ {aka ‘class std::shared_ptr<a::B>’} has no "
    "member named ‘sum’": "->sum",
    "a.cpp:7:9: error: no member named 'sum' in 'std::shared_ptr<a::B>'; did you mean to use '->' instead of '.'?": "->sum",
    "a.cpp:7:9: error: request for member ‘sum’ in ‘msg’, which is of pointer type ‘a::B*’": "->sum",
    "a.cpp:7:9: error: invalid use of non-static member function ‘void A::f()’": "&Class::function",
    "(.text+0x1b): undefined reference to `main'": "int main",
    "a.cpp:8: undefined reference to `Robot::turn()'": "Robot::turn is declared and not defined",
    "a.cpp:8: undefined reference to `std::list<a::B, std::less<a::B> > Robot::path<a::B, 3>(int)'": "Robot::path is d",
    "ld.lld: error: undefined symbol: Robot::turn()": "Robot::turn is declared and not defined",
    "a.cpp:30:1: error: expected ‘}’ at end of input": "count the braces",
    "a.cpp:11:49: error: ‘this’ was not captured for this lambda function\n"
    "a.cpp:11:49: error: cannot call member function ‘void A::speak()’ without object": "begin the lambda with [this]",
    "a.cpp:11:49: error: 'this' cannot be implicitly captured in this context": "begin the lambda with [this]",
    "a.cpp:11:31: error: no matching function for call to ‘A::create_wall_timer(double, A::<lambda()>)’": "such as 500ms",
    "a.cpp:11:31: error: no matching member function for call to 'create_wall_timer'": "such as 500ms",
}


@pytest.mark.parametrize("said", SAID)
def test_a_common_mistake_is_explained(said):
    hint_lines = hints(said + "\n")
    assert len(hint_lines) == 1 and SAID[said] in hint_lines[0], hint_lines


def test_no_more_than_three_and_nothing_twice():
    text = "".join(f"a.cpp:{line}:1: error: expected ‘;’ before ‘x’\n" for line in range(1, 9))
    assert len(hints(text)) == 3 and hints(text + text) == hints(text)


def test_braces_are_missed_behind_another_error():
    other = "a.cpp:9:5: error: ‘Nodes’ in namespace ‘rclcpp’ does not name a type\n"
    braces = "a.cpp:7:3: error: expected ‘{’ before ‘const’\n"
    assert len(hints(braces + braces.replace("7", "8"))) == 1
    assert hints(other + braces) == []


def test_warnings_and_other_words_are_left_alone():
    assert hints("a.cpp:3:5: warning: unused variable ‘x’ [-Wunused-variable]\n-- Configuring done\n") == []
