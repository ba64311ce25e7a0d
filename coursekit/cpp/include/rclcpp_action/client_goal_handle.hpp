// A goal as its client sees it.
#pragma once
#include "rclcpp_action/types.hpp"

namespace rclcpp_action
{
enum class ResultCode : int8_t
{
  UNKNOWN = GoalStatus::STATUS_UNKNOWN,
  SUCCEEDED = GoalStatus::STATUS_SUCCEEDED,
  CANCELED = GoalStatus::STATUS_CANCELED,
  ABORTED = GoalStatus::STATUS_ABORTED,
};

template<class A>
class Client;

template<class A>
class ClientGoalHandle
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientGoalHandle)
  using Result = typename A::Result;
  using Feedback = typename A::Feedback;
  struct WrappedResult
  {
    GoalUUID goal_id{};
    ResultCode code = ResultCode::UNKNOWN;
    typename Result::SharedPtr result;
  };
  using FeedbackCallback = std::function<void (typename ClientGoalHandle::SharedPtr, const std::shared_ptr<const Feedback>)>;
  using ResultCallback = std::function<void (const WrappedResult &)>;

  ClientGoalHandle(int64_t client, const GoalUUID & goal_id, const rclcpp::Time & stamp, FeedbackCallback heard, ResultCallback done)
  : client_(client), goal_id_(goal_id), stamp_(stamp), heard_(std::move(heard)), done_(std::move(done)) {}
  const GoalUUID & get_goal_id() const {return goal_id_;}
  rclcpp::Time get_goal_stamp() const {return stamp_;}
  int8_t get_status()
  {
    if (invalid_) {
      return GoalStatus::STATUS_UNKNOWN;
    }
    int8_t ended = ended_;  // a result's code is its status, and the session forgets a goal that has one
    return ended ? ended : static_cast<int8_t>(rclcpp::ask("client_goal_status", with()).i());
  }
  bool is_feedback_aware() const {return static_cast<bool>(heard_);}
  bool is_result_aware() const {return aware_;}

private:
  friend class Client<A>;
  /// The client has ended: nobody will tell of the goal any more.
  void invalidate()
  {
    aware_ = false;
    invalid_ = true;
    promise_.set_exception(std::make_exception_ptr(exceptions::UnawareGoalHandleError()));
  }
  rclcpp::Packer with() const {return rclcpp::Packer{}.i(client_).s(bytes_of(goal_id_));}
  int64_t client_;
  GoalUUID goal_id_;
  rclcpp::Time stamp_;
  FeedbackCallback heard_;
  ResultCallback done_;
  bool aware_ = false;
  std::atomic<int8_t> ended_{0};
  std::atomic<bool> invalid_{false};
  std::promise<WrappedResult> promise_;
  std::shared_future<WrappedResult> future_{promise_.get_future().share()};
};
}  // namespace rclcpp_action
