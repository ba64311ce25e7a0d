// From messages to what tf2 counts with, and back: tf2_geometry_msgs says how, for each pair.
#pragma once
#include <type_traits>

#include "rosidl_runtime_cpp/message.hpp"
#include "tf2/exceptions.h"
#include "tf2/time.h"

namespace tf2
{
template<class A, class B>
void convert(const A & a, B & b)
{
  if constexpr (std::is_same_v<A, B>) {
    b = a;
  } else if constexpr (coursekit::is_message<B>::value) {
    b = toMsg(a);
  } else {
    fromMsg(a, b);
  }
}
}  // namespace tf2
