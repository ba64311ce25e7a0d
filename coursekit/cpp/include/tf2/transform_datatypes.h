// Data with a time and a frame.
#pragma once
#include <array>
#include <string>

#include "tf2/time.h"

namespace tf2
{
template<class T>
class Stamped : public T
{
public:
  Stamped()
  : frame_id_("NO_ID_STAMPED_DEFAULT_CONSTRUCTION") {}
  Stamped(const T & data, const TimePoint & stamp, const std::string & frame_id)
  : T(data), stamp_(stamp), frame_id_(frame_id) {}
  void setData(const T & data) {static_cast<T &>(*this) = data;}

  TimePoint stamp_;
  std::string frame_id_;
};
template<class T>
bool operator==(const Stamped<T> & a, const Stamped<T> & b)
{
  return a.frame_id_ == b.frame_id_ && a.stamp_ == b.stamp_ && static_cast<const T &>(a) == static_cast<const T &>(b);
}
/// A covariance's six rows, one after the other in a message, as rows.
template<class T>
class WithCovarianceStamped : public T
{
public:
  WithCovarianceStamped()
  : frame_id_("NO_ID_STAMPED_DEFAULT_CONSTRUCTION") {}

  TimePoint stamp_;
  std::string frame_id_;
  std::array<std::array<double, 6>, 6> cov_mat_{};
};
}  // namespace tf2
