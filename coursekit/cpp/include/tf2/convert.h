// From messages to what tf2 counts with, and back: tf2_geometry_msgs says how, for each pair.
#pragma once
#include <array>
#include <type_traits>

#include "rosidl_runtime_cpp/message.hpp"
#include "tf2/exceptions.h"
#include "tf2/time.h"
#include "tf2/transform_datatypes.h"

namespace geometry_msgs::msg
{
struct TransformStamped;
}

namespace tf2
{
/// What a type is through a transform, its time and its frame: packages and programs specialise these for their own types.
template<class T>
void doTransform(const T & in, T & out, const geometry_msgs::msg::TransformStamped & transform);
template<class T>
TimePoint getTimestamp(const T & data);
template<class T>
std::string getFrameId(const T & data);
template<class T>
TimePoint getTimestamp(const Stamped<T> & data) {return data.stamp_;}
template<class T>
std::string getFrameId(const Stamped<T> & data) {return data.frame_id_;}

template<class A, class B>
void convert(const A & a, B & b)
{
  if constexpr (std::is_same_v<A, B>) {
    b = a;
  } else if constexpr (coursekit::is_message<B>::value) {
    b = toMsg(a);
  } else if constexpr (coursekit::is_message<A>::value) {
    fromMsg(a, b);
  } else {
    fromMsg(toMsg(a), b);  // types of two libraries know only the message between them
  }
}
/// A covariance's rows.
inline std::array<std::array<double, 6>, 6> covarianceRowMajorToNested(const std::array<double, 36> & flat)
{
  std::array<std::array<double, 6>, 6> rows{};
  for (size_t at = 0; at < flat.size(); ++at) {
    rows[at / 6][at % 6] = flat[at];
  }
  return rows;
}
/// Its rows, one after the other.
inline std::array<double, 36> covarianceNestedToRowMajor(const std::array<std::array<double, 6>, 6> & rows)
{
  std::array<double, 36> flat{};
  for (size_t at = 0; at < flat.size(); ++at) {
    flat[at] = rows[at / 6][at % 6];
  }
  return flat;
}
}  // namespace tf2
