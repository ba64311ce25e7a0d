// What all buffers have that do not wait.
#pragma once
#include <string>
#include <vector>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "tf2/time.h"

namespace tf2
{
class BufferCoreInterface
{
public:
  virtual ~BufferCoreInterface() = default;
  virtual void clear() = 0;
  virtual geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const std::string & source, const TimePoint & time) const = 0;
  virtual geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
    const std::string & fixed) const = 0;
  virtual bool canTransform(
    const std::string & target, const std::string & source, const TimePoint & time, std::string * why_not) const = 0;
  virtual bool canTransform(
    const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
    const std::string & fixed, std::string * why_not) const = 0;
  virtual std::vector<std::string> getAllFrameNames() const = 0;
};
}  // namespace tf2
