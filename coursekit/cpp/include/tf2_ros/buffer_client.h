// Asks the BufferServer of another program for transforms.
#pragma once
#include "rclcpp_action/rclcpp_action.hpp"
#include "tf2_msgs/action/lookup_transform.hpp"
#include "tf2_ros/buffer_interface.h"

namespace tf2_ros
{
#define COURSEKIT_GOAL_EXCEPTION(Name, Base) \
  class Name : public Base \
  { \
public: \
    explicit Name(const std::string & text) \
    : Base(text) {} \
  };
COURSEKIT_GOAL_EXCEPTION(LookupTransformGoalException, std::runtime_error)
COURSEKIT_GOAL_EXCEPTION(GoalRejectedException, LookupTransformGoalException)
COURSEKIT_GOAL_EXCEPTION(GoalAbortedException, LookupTransformGoalException)
COURSEKIT_GOAL_EXCEPTION(GoalCanceledException, LookupTransformGoalException)
COURSEKIT_GOAL_EXCEPTION(UnexpectedResultCodeException, LookupTransformGoalException)
#undef COURSEKIT_GOAL_EXCEPTION

/// Its node must be spun by another thread while it waits.
class BufferClient : public BufferInterface
{
public:
  using LookupTransformAction = tf2_msgs::action::LookupTransform;
  template<class N>
  BufferClient(
    N node, const std::string ns, const double & check_frequency = 10.0,
    const tf2::Duration & timeout_padding = tf2::durationFromSec(2.0))
  : client_(rclcpp_action::create_client<LookupTransformAction>(node, ns)), check_frequency_(check_frequency),
    timeout_padding_(timeout_padding) {}

  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time,
    const tf2::Duration timeout = tf2::durationFromSec(0.0)) const override
  {
    LookupTransformAction::Goal goal = goal_of(target, source, time, timeout);
    return processGoal(goal, timeout);
  }
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const tf2::TimePoint & target_time, const std::string & source, const tf2::TimePoint & source_time,
    const std::string & fixed, const tf2::Duration timeout = tf2::durationFromSec(0.0)) const override
  {
    LookupTransformAction::Goal goal = goal_of(target, source, source_time, timeout);
    goal.target_time = toMsg(target_time);
    goal.fixed_frame = fixed;
    goal.advanced = true;
    return processGoal(goal, timeout);
  }
  bool canTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time,
    const tf2::Duration timeout = tf2::durationFromSec(0.0), std::string * why_not = nullptr) const override
  {
    return can([&] {lookupTransform(target, source, time, timeout);}, why_not);
  }
  bool canTransform(
    const std::string & target, const tf2::TimePoint & target_time, const std::string & source, const tf2::TimePoint & source_time,
    const std::string & fixed, const tf2::Duration timeout = tf2::durationFromSec(0.0),
    std::string * why_not = nullptr) const override
  {
    return can([&] {lookupTransform(target, target_time, source, source_time, fixed, timeout);}, why_not);
  }
  bool waitForServer(const tf2::Duration & timeout = tf2::durationFromSec(0)) {return client_->wait_for_action_server(timeout);}

private:
  static LookupTransformAction::Goal goal_of(
    const std::string & target, const std::string & source, const tf2::TimePoint & time, tf2::Duration timeout)
  {
    LookupTransformAction::Goal goal;
    goal.target_frame = target;
    goal.source_frame = source;
    goal.source_time = toMsg(time);
    goal.timeout = toMsg(timeout);
    goal.advanced = false;
    return goal;
  }
  template<class F>
  static bool can(F look, std::string * why_not)
  {
    try {
      look();
      return true;
    } catch (const tf2::TransformException & error) {
      if (why_not) {
        *why_not = error.what();
      }
      return false;
    }
  }
  /// Wait for what the server says; `what` is the word for it where it comes too late.
  template<class F>
  void wait(const F & future, tf2::TimePoint end, const char * what) const
  {
    const auto period = std::chrono::milliseconds(static_cast<int>(1000 / check_frequency_));
    while (rclcpp::ok() && future.wait_for(period) != std::future_status::ready) {
      if (tf2::get_now() > end) {
        throw tf2::TimeoutException(
                std::string("Did not receive the ") + what +
                " for the goal sent to the action server. Something is likely wrong with the server.");
      }
    }
  }
  geometry_msgs::msg::TransformStamped processGoal(const LookupTransformAction::Goal & goal, tf2::Duration timeout) const
  {
    if (!client_->wait_for_action_server(timeout)) {
      throw tf2::ConnectivityException("Failed find available action server");
    }
    const tf2::TimePoint end = tf2::get_now() + timeout + timeout_padding_;
    auto sent = client_->async_send_goal(goal);
    wait(sent, end, "goal response");
    auto handle = sent.get();
    if (!handle) {
      throw GoalRejectedException("Goal rejected by action server");
    }
    auto result = client_->async_get_result(handle);
    wait(result, end, "result");
    return processResult(result.get());
  }
  static geometry_msgs::msg::TransformStamped processResult(
    const rclcpp_action::ClientGoalHandle<LookupTransformAction>::WrappedResult & wrapped)
  {
    switch (wrapped.code) {
      case rclcpp_action::ResultCode::SUCCEEDED:
        break;
      case rclcpp_action::ResultCode::ABORTED:
        throw GoalAbortedException("LookupTransform action was aborted");
      case rclcpp_action::ResultCode::CANCELED:
        throw GoalCanceledException("LookupTransform action was canceled");
      default:
        throw UnexpectedResultCodeException("Unexpected result code returned from server");
    }
    using Error = tf2_msgs::msg::TF2Error;
    const Error & error = wrapped.result->error;
    switch (error.error) {
      case Error::NO_ERROR:
        return wrapped.result->transform;
      case Error::LOOKUP_ERROR:
        throw tf2::LookupException(error.error_string);
      case Error::CONNECTIVITY_ERROR:
        throw tf2::ConnectivityException(error.error_string);
      case Error::EXTRAPOLATION_ERROR:
        throw tf2::ExtrapolationException(error.error_string);
      case Error::INVALID_ARGUMENT_ERROR:
        throw tf2::InvalidArgumentException(error.error_string);
      case Error::TIMEOUT_ERROR:
        throw tf2::TimeoutException(error.error_string);
      default:
        throw tf2::TransformException(error.error_string);
    }
  }

  rclcpp_action::Client<LookupTransformAction>::SharedPtr client_;
  double check_frequency_;
  tf2::Duration timeout_padding_;
};
}  // namespace tf2_ros
