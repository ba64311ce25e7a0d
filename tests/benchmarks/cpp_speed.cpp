// One end of a measurement: `send N RATE BYTES` publishes N messages of so many bytes, `hear N` says how many came, and how late.
#include <algorithm>
#include <iostream>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/image.hpp"

using sensor_msgs::msg::Image;

static void send(const rclcpp::Node::SharedPtr & node, int count, double rate, size_t size)
{
  auto publisher = node->create_publisher<Image>("measured", 100);
  while (publisher->get_subscription_count() == 0) {
    rclcpp::sleep_for(std::chrono::milliseconds(10));
  }
  Image message;
  message.data.resize(size);
  rclcpp::WallRate loop(rate);
  auto begun = std::chrono::steady_clock::now();
  for (int i = 0; i < count && rclcpp::ok(); ++i) {
    message.header.stamp = node->now();
    publisher->publish(message);
    loop.sleep();
  }
  std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  std::cout << took.count() * rate / count << std::endl;  // above 1: it fell behind
}
static void hear(const rclcpp::Node::SharedPtr & node, size_t count)
{
  std::vector<double> late;
  auto subscription = node->create_subscription<Image>(
    "measured", 100, [&](Image::UniquePtr message) {
      late.push_back((node->now() - message->header.stamp).seconds() * 1e6);
      if (late.size() == count) {
        rclcpp::shutdown();
      }
    });
  rclcpp::spin(node);
  std::sort(late.begin(), late.end());
  std::cout << late.size() << ' ' << late[late.size() / 2] << ' ' << late[late.size() * 99 / 100] << std::endl;
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared(argv[1]);
  if (std::string(argv[1]) == "send") {
    send(node, std::atoi(argv[2]), std::atof(argv[3]), static_cast<size_t>(std::atoi(argv[4])));
  } else {
    hear(node, static_cast<size_t>(std::atoi(argv[2])));
  }
}
