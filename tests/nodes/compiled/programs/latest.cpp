// message_filters: with each message of the fastest topic the last ones of the others.
#include <iostream>

#include "message_filters/pass_through.h"
#include "message_filters/sync_policies/latest_time.h"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/range.hpp"
using sensor_msgs::msg::Range;
using Latest = message_filters::sync_policies::LatestTime<Range, Range>;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("latest");
  message_filters::PassThrough<Range> slow, fast;
  message_filters::Synchronizer<Latest> both(Latest(node->get_clock()), slow, fast);
  both.registerCallback(
    [](const Range::ConstSharedPtr & rare, const Range::ConstSharedPtr & often) {
      std::cout << rare->range << ":" << often->range << std::endl;
    });
  int tick = 0;
  auto timer = node->create_wall_timer(
    std::chrono::milliseconds(10), [&] {
      auto message = std::make_shared<Range>();
      message->range = static_cast<float>(++tick);
      (tick % 4 ? fast : slow).add(message);
      if (tick == 16) {
        rclcpp::shutdown();
      }
    });
  rclcpp::spin(node);
}
