// Transforms of the last seconds, waited for.
#pragma once
#include <list>

#include "tf2/buffer_core.h"
#include "tf2_ros/async_buffer_interface.h"
#include "tf2_ros/buffer_interface.h"
#include "tf2_ros/create_timer_interface.h"

namespace tf2_ros
{
static const char threading_error[] =
  "Do not call canTransform or lookupTransform with a timeout unless you are using another thread for populating data. "
  "Without a dedicated thread it will always timeout.  If you have a separate thread servicing tf messages, call "
  "setUsingDedicatedThread(true) on your Buffer instance.";

class Buffer : public BufferInterface, public AsyncBufferInterface, public tf2::BufferCore
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Buffer)
  explicit Buffer(
    rclcpp::Clock::SharedPtr clock, tf2::Duration cache_time = tf2::BUFFER_CORE_DEFAULT_CACHE_TIME,
    rclcpp::Node::SharedPtr node = nullptr);
  Buffer(Shared buffer, rclcpp::Clock::SharedPtr clock)
  : BufferCore(buffer), clock_(std::move(clock))
  {
    setUsingDedicatedThread(true);  // the server fills it
  }
  ~Buffer() override;

  using tf2::BufferCore::canTransform;
  using tf2::BufferCore::lookupTransform;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time,
    const tf2::Duration timeout) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const std::string & source, const rclcpp::Time & time,
    const rclcpp::Duration timeout = rclcpp::Duration(0, 0)) const
  {
    return lookupTransform(target, source, fromRclcpp(time), fromRclcpp(timeout));
  }
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const tf2::TimePoint & target_time, const std::string & source,
    const tf2::TimePoint & source_time, const std::string & fixed, const tf2::Duration timeout) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const rclcpp::Time & target_time, const std::string & source, const rclcpp::Time & source_time,
    const std::string & fixed, const rclcpp::Duration timeout = rclcpp::Duration(0, 0)) const
  {
    return lookupTransform(target, fromRclcpp(target_time), source, fromRclcpp(source_time), fixed, fromRclcpp(timeout));
  }

  bool canTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration timeout,
    std::string * why_not = nullptr) const override;
  bool canTransform(
    const std::string & target, const std::string & source, const rclcpp::Time & time,
    const rclcpp::Duration timeout = rclcpp::Duration(0, 0), std::string * why_not = nullptr) const
  {
    return canTransform(target, source, fromRclcpp(time), fromRclcpp(timeout), why_not);
  }
  bool canTransform(
    const std::string & target, const tf2::TimePoint & target_time, const std::string & source,
    const tf2::TimePoint & source_time, const std::string & fixed, const tf2::Duration timeout,
    std::string * why_not = nullptr) const override;
  bool canTransform(
    const std::string & target, const rclcpp::Time & target_time, const std::string & source, const rclcpp::Time & source_time,
    const std::string & fixed, const rclcpp::Duration timeout = rclcpp::Duration(0, 0), std::string * why_not = nullptr) const
  {
    return canTransform(
      target, fromRclcpp(target_time), source, fromRclcpp(source_time), fixed, fromRclcpp(timeout), why_not);
  }

  void setCreateTimerInterface(CreateTimerInterface::SharedPtr timers) {timers_ = timers;}
  /// Have a function called when there is a transform; its future throws tf2::TimeoutException where none came in time.
  TransformStampedFuture waitForTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration & timeout,
    TransformReadyCallback callback) override;
  TransformStampedFuture waitForTransform(
    const std::string & target, const std::string & source, const rclcpp::Time & time, const rclcpp::Duration & timeout,
    TransformReadyCallback callback)
  {
    return waitForTransform(target, source, fromRclcpp(time), fromRclcpp(timeout), std::move(callback));
  }

  /// Wait for it no more.
  void cancel(const TransformStampedFuture & future) override;

protected:
  void transform_was_set() override;

private:
  /// A request that waits, and the timer that looks for its transform or ends it.
  struct Wait
  {
    TransformRequestHandle handle;
    std::function<bool(bool over)> settle;
    CreateTimerInterface::SharedPtr timers;
    TimerHandle timer;
  };
  /// Whether a time to wait for a transform may pass: only where something else than the waiting thread fills the buffer.
  bool may_wait(tf2::Duration timeout, std::string * why_not = nullptr) const;
  /// What is asked, with how long it took behind why not.
  bool timed(tf2::Duration timeout, std::string * why_not, const std::function<bool()> & can) const;
  void forget(TransformRequestHandle handle);
  /// Transforms of a time that has not been yet would hide the new ones.
  void clear_after(const rcl_time_jump_t & jump);
  rclcpp::Logger logger() const;
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Node::SharedPtr node_;
  rclcpp::JumpHandler::SharedPtr jumps_;
  CreateTimerInterface::SharedPtr timers_;
  std::list<Wait> waiting_;
  std::atomic<TransformRequestHandle> waits_{0};
  std::mutex lock_;
};
}  // namespace tf2_ros
