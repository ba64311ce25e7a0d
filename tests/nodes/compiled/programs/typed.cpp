// Futures of other threads, and what is typed, by all the ways in which a program may read it.
#include <unistd.h>

#include <future>
#include <iostream>
#include <thread>

#include "rclcpp/rclcpp.hpp"
using namespace std::chrono_literals;
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto future = std::async(std::launch::async, [] {
      std::this_thread::sleep_for(2s);
      return 42;
    });
  std::cout << (future.wait_for(500ms) == std::future_status::timeout) << future.get() << std::endl;
  std::promise<int> promise;
  std::thread other([&] {
      std::this_thread::sleep_for(100ms);
      promise.set_value(7);
    });
  std::cout << promise.get_future().get() << std::endl;
  other.join();
  int number;
  std::string word, line;
  char text[20];
  std::cin >> number >> word;
  std::getline(std::cin, line);
  std::getline(std::cin, line);
  std::cout << number << word << line << std::endl;
  std::cout << scanf("%19s", text) << text << std::endl;
  getchar();
  ssize_t got = read(0, text, 1);
  std::cout << got << text[0] << std::endl;
  while (std::cin >> word) {std::cout << word << ",";}
  std::cout << "end" << std::endl;
}
