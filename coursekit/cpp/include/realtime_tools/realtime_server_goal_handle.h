// Lets a thread that must not wait end an action's goal: runNonRealtime(), called by a timer, does what it asked for.
#pragma once
#include <memory>
#include <mutex>

#include "rclcpp_action/server_goal_handle.hpp"

namespace realtime_tools
{
template<class Action>
class RealtimeServerGoalHandle
{
  using Handle = rclcpp_action::ServerGoalHandle<Action>;
  using ResultPtr = std::shared_ptr<typename Action::Result>;
  using FeedbackPtr = std::shared_ptr<typename Action::Feedback>;
  enum class End {NONE, ABORT, CANCEL, SUCCEED};

public:
  explicit RealtimeServerGoalHandle(
    std::shared_ptr<Handle> & gh, const ResultPtr & preallocated_result = nullptr,
    const FeedbackPtr & preallocated_feedback = nullptr, rclcpp::Logger = rclcpp::get_logger("realtime_tools"))
  : gh_(gh), preallocated_result_(preallocated_result ? preallocated_result : std::make_shared<typename Action::Result>()),
    preallocated_feedback_(preallocated_feedback ? preallocated_feedback : std::make_shared<typename Action::Feedback>()) {}
  void setAborted(ResultPtr result = nullptr) {ask_for(End::ABORT, result);}
  void setCanceled(ResultPtr result = nullptr) {ask_for(End::CANCEL, result);}
  void setSucceeded(ResultPtr result = nullptr) {ask_for(End::SUCCEED, result);}
  void setFeedback(FeedbackPtr feedback = nullptr)
  {
    std::lock_guard<std::mutex> hold(lock_);
    feedback_ = feedback;
  }
  void execute()
  {
    if (!gh_->is_executing()) {
      gh_->execute();
    }
  }
  bool valid() {return gh_ != nullptr;}
  void runNonRealtime()
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (!valid() || !gh_->is_active()) {
      return;
    }
    if (wanted_ == End::CANCEL && gh_->is_canceling()) {
      gh_->canceled(result_);
    } else if (wanted_ == End::ABORT) {
      gh_->abort(result_);
    } else if (wanted_ == End::SUCCEED) {
      gh_->succeed(result_);
    } else if (feedback_) {
      gh_->publish_feedback(feedback_);
      feedback_.reset();
    }
  }

  std::shared_ptr<Handle> gh_;
  ResultPtr preallocated_result_;
  FeedbackPtr preallocated_feedback_;

private:
  void ask_for(End end, const ResultPtr & result)
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (wanted_ == End::NONE) {
      wanted_ = end;
      result_ = result ? result : preallocated_result_;
    }
  }
  std::mutex lock_;
  End wanted_ = End::NONE;
  ResultPtr result_;
  FeedbackPtr feedback_;
};
}  // namespace realtime_tools
