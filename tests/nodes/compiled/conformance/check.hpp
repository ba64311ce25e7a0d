// A line for each thing that Humble's rclcpp does: `ok NAME`, or `not ok NAME: WHY`.
#pragma once
#include <iostream>
#include <sstream>
#include <string>

#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

inline void check(const std::string & name, bool holds, const std::string & why = "does not hold")
{
  std::cout << (holds ? "ok " + name : "not ok " + name + ": " + why) << std::endl;
}
template<class A, class B>
void equal(const std::string & name, const A & got, const B & wanted)
{
  std::ostringstream why;
  why << std::boolalpha << "got " << got << ", wanted " << wanted;
  check(name, got == wanted, why.str());
}
template<class E, class F>
void throws(const std::string & name, F what)
{
  try {
    what();
  } catch (const E &) {
    return check(name, true);
  } catch (const std::exception & other) {
    return check(name, false, std::string("threw another exception: ") + other.what());
  }
  check(name, false, "threw nothing");
}
/// Spin until something holds, at most so long.
template<class N, class F>
bool spin_until(N node, F holds, std::chrono::nanoseconds limit = 5s)
{
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  rclcpp::Clock clock(RCL_STEADY_TIME);
  for (auto end = clock.now() + rclcpp::Duration(limit); rclcpp::ok() && !holds() && clock.now() < end; ) {
    executor.spin_once(10ms);
  }
  return holds();
}
