// A goal as its server sees it.
#pragma once
#include "rclcpp_action/types.hpp"

namespace rclcpp_action
{
class ServerGoalHandleBase
{
public:
  ServerGoalHandleBase(int64_t server, const GoalUUID & goal_id)
  : server_(server), goal_id_(goal_id) {}
  ServerGoalHandleBase(const ServerGoalHandleBase &) = delete;
  virtual ~ServerGoalHandleBase() {coursekit::note("goal_dropped", with());}
  bool is_canceling() const {return status() == GoalStatus::STATUS_CANCELING;}
  bool is_executing() const {return status() == GoalStatus::STATUS_EXECUTING;}
  bool is_active() const
  {
    int64_t now = status();
    return now == GoalStatus::STATUS_ACCEPTED || now == GoalStatus::STATUS_EXECUTING || now == GoalStatus::STATUS_CANCELING;
  }
  const GoalUUID & get_goal_id() const {return goal_id_;}
  /// Begin a goal that was accepted and deferred.
  void execute() {rclcpp::ask("goal_execute", with());}

protected:
  rclcpp::Packer with() const {return rclcpp::Packer{}.i(server_).s(bytes_of(goal_id_));}
  int64_t status() const {return rclcpp::ask("goal_status", with()).i();}

private:
  int64_t server_;
  GoalUUID goal_id_;
};

template<class A>
class ServerGoalHandle : public ServerGoalHandleBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServerGoalHandle)
  using Goal = typename A::Goal;
  using Result = typename A::Result;
  using Feedback = typename A::Feedback;
  ServerGoalHandle(int64_t server, const GoalUUID & goal_id, std::shared_ptr<const Goal> goal)
  : ServerGoalHandleBase(server, goal_id), goal_(std::move(goal)) {}

  const std::shared_ptr<const Goal> get_goal() const {return goal_;}
  void publish_feedback(std::shared_ptr<Feedback> feedback) {rclcpp::ask("feedback", with().m(*feedback));}
  void succeed(std::shared_ptr<Result> result) {end("succeed", *result);}
  void abort(std::shared_ptr<Result> result) {end("abort", *result);}
  void canceled(std::shared_ptr<Result> result) {end("canceled", *result);}

private:
  void end(const char * how, const Result & result) {rclcpp::ask("goal_end", with().s(how).m(result));}
  std::shared_ptr<const Goal> goal_;
};
}  // namespace rclcpp_action
