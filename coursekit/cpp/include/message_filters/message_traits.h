// What filters ask of a message: whether it has a header, its frame and when it was measured.
#pragma once
#include <string>
#include <type_traits>

#include "rclcpp/time.hpp"
#include "std_msgs/msg/header.hpp"

namespace message_filters
{
namespace message_traits
{
template<class M, class Enable = void>
struct HasHeader : std::false_type {};
template<class M>
struct HasHeader<M, std::enable_if_t<std::is_same<std_msgs::msg::Header, std::decay_t<decltype(M::header)>>::value>>
  : std::true_type {};

/// The frame of a message that has a header.
template<class M, class Enable = void>
struct FrameId
{
  static std::string * pointer(M & message) {return &message.header.frame_id;}
  static std::string value(const M & message) {return message.header.frame_id;}
};

/// The time of a message that has a header: its stamp.
template<class M, class Enable = void>
struct TimeStamp
{
  static rclcpp::Time value(const M & message) {return rclcpp::Time(message.header.stamp, RCL_ROS_TIME);}
};
}  // namespace message_traits
}  // namespace message_filters
