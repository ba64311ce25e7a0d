// Clocks: the system's, a steady one, and ROS time, which follows /clock where a node does.
#pragma once
#include <atomic>
#include <mutex>

#include "coursekit/entity.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp
{
/// What is called around jumps of a clock, for as long as somebody holds it.
class JumpHandler : public coursekit::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(JumpHandler)
  using pre_callback_t = std::function<void ()>;
  using post_callback_t = std::function<void (const rcl_time_jump_t &)>;
  JumpHandler(pre_callback_t pre, post_callback_t post, const rcl_jump_threshold_t & threshold)
  : pre_callback(std::move(pre)), post_callback(std::move(post)), notice_threshold(threshold) {}
  pre_callback_t pre_callback;
  post_callback_t post_callback;
  rcl_jump_threshold_t notice_threshold;
};

/// A clock; its copies are the same clock, as upstream's, where each holds what it shares with the others.
class Clock
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)
  explicit Clock(rcl_clock_type_t type = RCL_SYSTEM_TIME, int64_t node = 0)
  {
    shared_->handle.type = type;
    shared_->node = node;
  }
  Time now() const;
  bool sleep_until(Time until, Context::SharedPtr context = contexts::get_global_default_context());
  bool sleep_for(Duration duration, Context::SharedPtr context = contexts::get_global_default_context());
  bool ros_time_is_active() const;
  /// Whether time has begun: ROS time follows /clock where a node does, and is zero until somebody publishes it.
  bool started() const {return now().nanoseconds() != 0;}
  /// Wait until it has; false where the context ended first, or the time ran out.
  bool wait_until_started(Context::SharedPtr context = contexts::get_global_default_context());
  bool wait_until_started(
    const Duration & timeout, Context::SharedPtr context = contexts::get_global_default_context(),
    const Duration & wait_tick_ns = Duration(0, 10000000));
  /// Have functions called before and after jumps that reach a threshold: of a node's clock, since no other jumps.
  JumpHandler::SharedPtr create_jump_callback(
    JumpHandler::pre_callback_t pre_callback, JumpHandler::post_callback_t post_callback,
    const rcl_jump_threshold_t & threshold);
  rcl_clock_type_t get_clock_type() const noexcept {return shared_->handle.type;}
  /// The node whose time this is, by its number at the session; 0 for none.
  int64_t node() const {return shared_->node;}
  void follow(int64_t node) {shared_->node = node;}
  /// To be held while a jump callback is made or ends, so that none runs meanwhile.
  std::mutex & get_clock_mutex() noexcept {return shared_->lock;}

  rcl_clock_t * get_clock_handle() noexcept {return &shared_->handle;}

private:
  bool simulated() const;
  /// Sleep by the time that the program gives.
  bool sleep_by_override(const Time & until, const Context::SharedPtr & context) const;
  struct Shared
  {
    rcl_clock_t handle;
    std::atomic<int64_t> node{0};
    std::mutex lock;
  };
  rcl_clock_t & handle() const {return shared_->handle;}
  std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
};
}  // namespace rclcpp
