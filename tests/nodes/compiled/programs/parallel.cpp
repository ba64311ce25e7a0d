// A node whose callback computes on several cores with OpenMP, beside a thread of its own that sleeps.
#include <chrono>
#include <memory>
#include <thread>

#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("parallel");
  std::thread beside([&node] {
      std::this_thread::sleep_for(1500ms);
      RCLCPP_INFO(node->get_logger(), "slept until %.1f", node->now().seconds() - 1.7e9);
    });
  int ticks = 0;
  auto timer = node->create_wall_timer(1s, [&] {
        long sum = 0;
        int threads = 0;
#pragma omp parallel num_threads(4) reduction(+:sum, threads)
        {
          threads += 1;
#pragma omp for
          for (int i = 0; i < 1000; ++i) {
            sum += i;
          }
        }
        RCLCPP_INFO(node->get_logger(), "%ld by %d at %.1f", sum, threads, node->now().seconds() - 1.7e9);
        if (++ticks == 3) {
          rclcpp::shutdown();
        }
      });
  rclcpp::spin(node);
  beside.join();
}
