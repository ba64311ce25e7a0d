// Ends, or does not, in the way that its argument names, one virtual second after it has begun.
#include <signal.h>
#include <sys/wait.h>

#include <iostream>
#include <thread>

#include "rclcpp/rclcpp.hpp"
using namespace std::chrono_literals;

static void fail(const std::string & how)
{
  if (how == "segfault") {
    *reinterpret_cast<volatile int *>(8) = 1;
  } else if (how == "abort") {
    abort();
  } else if (how == "throw") {
    throw std::runtime_error("nobody catches this");
  } else if (how == "exit") {
    exit(3);
  } else if (how == "kill") {
    raise(SIGKILL);
  } else if (how == "compute") {
    for (volatile int i = 0; ; ++i) {
    }
  } else if (how == "detached") {
    std::thread(
      [] {
        for (;;) {
          std::this_thread::sleep_for(100ms);
        }
      }).detach();
    rclcpp::shutdown();
  }
}
int main(int argc, char ** argv)
{
  std::string how = argc > 1 ? argv[1] : "";
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("faulty");
  auto timer = node->create_wall_timer(1s, [&] {fail(how);});
  std::cout << "begins" << std::endl;
  rclcpp::spin(node);
  std::cout << "ends" << std::endl;
}
