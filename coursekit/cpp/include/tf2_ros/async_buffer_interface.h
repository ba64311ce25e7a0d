// Transforms that are not waited for: a function is called when there is one.
#pragma once
#include <functional>
#include <future>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "tf2/time.h"

namespace tf2_ros
{
using TransformRequestHandle = uint64_t;
/// What will be found, and the number of the request by which it is cancelled.
class TransformStampedFuture : public std::shared_future<geometry_msgs::msg::TransformStamped>
{
  using Base = std::shared_future<geometry_msgs::msg::TransformStamped>;

public:
  TransformStampedFuture() = default;
  explicit TransformStampedFuture(Base future)
  : Base(std::move(future)) {}
  void setHandle(TransformRequestHandle handle) {handle_ = handle;}
  TransformRequestHandle getHandle() const {return handle_;}

private:
  TransformRequestHandle handle_ = 0;
};
using TransformReadyCallback = std::function<void (const TransformStampedFuture &)>;

class AsyncBufferInterface
{
public:
  virtual ~AsyncBufferInterface() = default;
  virtual TransformStampedFuture waitForTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration & timeout,
    TransformReadyCallback callback) = 0;
  virtual void cancel(const TransformStampedFuture & future) = 0;
};
}  // namespace tf2_ros
