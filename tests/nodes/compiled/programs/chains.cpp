// message_filters: filters in a row, and messages that are put into the order of their stamps.
#include <iostream>

#include "message_filters/chain.h"
#include "message_filters/pass_through.h"
#include "message_filters/subscriber.h"
#include "message_filters/time_sequencer.h"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/range.hpp"
using message_filters::Chain;
using message_filters::PassThrough;
using sensor_msgs::msg::Range;

static Range::SharedPtr at(const rclcpp::Time & stamp, float range)
{
  auto made = std::make_shared<Range>();
  made->header.stamp = stamp;
  made->range = range;
  return made;
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("chains");
  int passed = 0;
  PassThrough<Range> own;
  Chain<Range> chain;
  std::cout << chain.addFilter(std::make_shared<PassThrough<Range>>()) << chain.addFilter(&own)
            << (chain.getFilter<PassThrough<Range>>(1).get() == &own) << (chain.getFilter<PassThrough<Range>>(2) == nullptr);
  chain.registerCallback(std::function<void (const Range::ConstSharedPtr &)>([&](const Range::ConstSharedPtr &) {++passed;}));
  PassThrough<Range> source;
  chain.connectInput(source);
  source.add(at(node->now(), 1));
  chain.add(at(node->now(), 2));
  std::cout << passed << std::endl;

  message_filters::Subscriber<Range> subscriber(node, "range");
  message_filters::TimeSequencer<Range> sequencer(
    subscriber, rclcpp::Duration::from_seconds(0.3), rclcpp::Duration::from_seconds(0.01), 10, node);
  rclcpp::Time begin = node->now();
  sequencer.registerCallback(
    [&](const Range::ConstSharedPtr & message) {
      double age = (node->now() - rclcpp::Time(message->header.stamp)).seconds();
      std::cout << message->range << (age >= 0.3 && age < 0.33 ? " in time" : " late") << std::endl;
    });
  auto publisher = node->create_publisher<Range>("range", 10);
  for (int i : {2, 0, 1}) {
    publisher->publish(*at(begin + rclcpp::Duration::from_seconds(0.1 * i), static_cast<float>(i)));
  }
  rclcpp::TimerBase::SharedPtr late = node->create_wall_timer(
    std::chrono::milliseconds(450), [&] {
      publisher->publish(*at(begin, 9));
      late->cancel();
    });
  auto end = node->create_wall_timer(std::chrono::seconds(1), [] {rclcpp::shutdown();});
  rclcpp::spin(node);
}
