// The QoS of what is broadcast.
#pragma once
#include "rclcpp/qos.hpp"

namespace tf2_ros
{
#define COURSEKIT_TF2_QOS(Name, usual_depth, how) \
  class Name : public rclcpp::QoS \
  { \
  public: \
    explicit Name(size_t depth = usual_depth) \
    : rclcpp::QoS(depth) {how;} \
  };
COURSEKIT_TF2_QOS(DynamicListenerQoS, 100, durability_volatile())
COURSEKIT_TF2_QOS(DynamicBroadcasterQoS, 100, durability_volatile())
COURSEKIT_TF2_QOS(StaticListenerQoS, 100, transient_local())
COURSEKIT_TF2_QOS(StaticBroadcasterQoS, 1, transient_local())
}  // namespace tf2_ros
