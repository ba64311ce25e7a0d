// What stands for an input that a synchronizer does not have.
#pragma once
#include "message_filters/connection.h"
#include "message_filters/message_traits.h"

namespace message_filters
{
struct NullType {};
using NullTypeConstPtr = std::shared_ptr<NullType const>;
template<class M>
struct NullFilter
{
  template<class C>
  Connection registerCallback(const C &) {return Connection();}
  template<typename P>
  Connection registerCallback(const std::function<void (P)> &) {return Connection();}
};
namespace message_traits
{
template<>
struct TimeStamp<NullType>
{
  static rclcpp::Time value(const NullType &) {return rclcpp::Time();}
};
}  // namespace message_traits
}  // namespace message_filters
