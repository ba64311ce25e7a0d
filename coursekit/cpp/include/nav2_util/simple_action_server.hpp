// An action server with one goal at a time, and the next that waits.
#pragma once
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "nav2_util/node_thread.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

namespace nav2_util
{
template<typename ActionT>
class SimpleActionServer
{
public:
  typedef std::function<void ()> ExecuteCallback;
  typedef std::function<void ()> CompletionCallback;
  using Goal = typename ActionT::Goal;
  using Result = typename ActionT::Result;
  using Feedback = typename ActionT::Feedback;
  using Handle = std::shared_ptr<rclcpp_action::ServerGoalHandle<ActionT>>;

  /// `execute_callback` runs in a thread of its own, and ends each goal that it takes.
  template<typename NodeT>
  explicit SimpleActionServer(
    NodeT node, const std::string & action_name, ExecuteCallback execute_callback,
    CompletionCallback completion_callback = nullptr,
    std::chrono::milliseconds server_timeout = std::chrono::milliseconds(500), bool spin_thread = false,
    const rcl_action_server_options_t & options = rcl_action_server_get_default_options())
  : base_(node->get_node_base_interface()), logger_(node->get_logger()), name_(action_name),
    execute_(std::move(execute_callback)), completed_(std::move(completion_callback)), timeout_(server_timeout)
  {
    if (spin_thread) {
      group_ = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
    }
    using std::placeholders::_1;
    using std::placeholders::_2;
    server_ = rclcpp_action::create_server<ActionT>(
      node, name_, std::bind(&SimpleActionServer::handle_goal, this, _1, _2),
      std::bind(&SimpleActionServer::handle_cancel, this, _1), std::bind(&SimpleActionServer::handle_accepted, this, _1),
      options, group_);
    if (spin_thread) {
      auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
      executor->add_callback_group(group_, base_);
      thread_ = std::make_unique<NodeThread>(executor);
    }
  }

  rclcpp_action::GoalResponse handle_goal(const rclcpp_action::GoalUUID &, std::shared_ptr<const Goal>)
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (!active_) {
      RCLCPP_INFO(logger_, "[%s] [ActionServer] Action server is inactive. Rejecting the goal.", name_.c_str());
      return rclcpp_action::GoalResponse::REJECT;
    }
    return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
  }
  rclcpp_action::CancelResponse handle_cancel(const Handle handle)
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (!handle->is_active()) {
      RCLCPP_WARN(
        logger_, "[%s] [ActionServer] Received request for goal cancellation,but the handle is inactive, so reject the request",
        name_.c_str());
      return rclcpp_action::CancelResponse::REJECT;
    }
    return rclcpp_action::CancelResponse::ACCEPT;
  }
  void handle_accepted(const Handle handle)
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (is_active(current_) || is_running()) {
      if (is_active(pending_)) {
        terminate(pending_);  // nobody has begun it
      }
      pending_ = handle;
      preempted_ = true;
      return;
    }
    current_ = handle;
    running_ = std::async(std::launch::async, [this] {work();});
  }

  void work()
  {
    while (rclcpp::ok() && !stops_ && is_active(current_)) {
      try {
        execute_();
      } catch (const std::exception & error) {
        RCLCPP_ERROR(
          logger_, "[%s] [ActionServer] Action server failed while executing action callback: \"%s\"", name_.c_str(), error.what());
        end_all();
        return;
      }
      std::lock_guard<std::recursive_mutex> hold(lock_);
      if (stops_) {
        break;
      }
      if (is_active(current_)) {
        RCLCPP_WARN(logger_, "[%s] [ActionServer] Current goal was not completed successfully.", name_.c_str());
        terminate(current_);
        tell_completed();
      }
      if (is_active(pending_)) {
        accept_pending_goal();
      }
    }
    end_all();
  }

  void activate()
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    active_ = true;
    stops_ = false;
  }
  /// Reject goals, and wait until the current one has ended.
  void deactivate()
  {
    {
      std::lock_guard<std::recursive_mutex> hold(lock_);
      active_ = false;
      stops_ = true;
    }
    if (!running_.valid()) {
      return;
    }
    if (is_running()) {
      RCLCPP_WARN(
        logger_, "[%s] [ActionServer] Requested to deactivate server but goal is still executing. "
        "Should check if action server is running before deactivating.", name_.c_str());
    }
    const auto begin = std::chrono::steady_clock::now();
    while (running_.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
      if (std::chrono::steady_clock::now() - begin >= timeout_) {
        end_all();
        if (completed_) {
          completed_();
        }
        throw std::runtime_error("Action callback is still running and missed deadline to stop");
      }
    }
  }

  bool is_running() {return running_.valid() && running_.wait_for(std::chrono::milliseconds(0)) == std::future_status::timeout;}
  bool is_server_active()
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    return active_;
  }
  bool is_preempt_requested() const
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    return preempted_;
  }
  /// Go on with the goal that waits; the current one is aborted. Nothing where none waits.
  const std::shared_ptr<const Goal> accept_pending_goal()
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (!is_active(pending_)) {
      RCLCPP_ERROR(logger_, "[%s] [ActionServer] Attempting to get pending goal when not available", name_.c_str());
      return nullptr;
    }
    if (is_active(current_) && current_ != pending_) {
      terminate(current_);
    }
    current_ = std::move(pending_);
    pending_.reset();
    preempted_ = false;
    return current_->get_goal();
  }
  void terminate_pending_goal()
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (!is_active(pending_)) {
      RCLCPP_ERROR(logger_, "[%s] [ActionServer] Attempting to terminate pending goal when not available", name_.c_str());
      return;
    }
    terminate(pending_);
    preempted_ = false;
  }
  const std::shared_ptr<const Goal> get_current_goal() const {return goal_of(current_, "current");}
  const std::shared_ptr<const Goal> get_pending_goal() const {return goal_of(pending_, "pending");}
  bool is_cancel_requested() const
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (!current_) {
      RCLCPP_ERROR(logger_, "[%s] [ActionServer] Checking for cancel but current goal is not available", name_.c_str());
      return false;
    }
    return (pending_ ? pending_ : current_)->is_canceling();
  }
  void terminate_all(std::shared_ptr<Result> result = std::make_shared<Result>())
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    terminate(current_, result);
    terminate(pending_, result);
    preempted_ = false;
  }
  void terminate_current(std::shared_ptr<Result> result = std::make_shared<Result>())
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    terminate(current_, result);
  }
  void succeeded_current(std::shared_ptr<Result> result = std::make_shared<Result>())
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (is_active(current_)) {
      current_->succeed(result);
      current_.reset();
    }
  }
  void publish_feedback(std::shared_ptr<Feedback> feedback)
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (!is_active(current_)) {
      RCLCPP_ERROR(logger_, "[%s] [ActionServer] Trying to publish feedback when the current goal handle is not active", name_.c_str());
      return;
    }
    current_->publish_feedback(feedback);
  }

protected:
  static bool is_active(const Handle & handle) {return handle && handle->is_active();}
  /// End a goal: canceled where that was asked for, else aborted.
  void terminate(Handle & handle, std::shared_ptr<Result> result = std::make_shared<Result>())
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (!is_active(handle)) {
      return;
    }
    if (handle->is_canceling()) {
      handle->canceled(result);
    } else {
      RCLCPP_WARN(logger_, "[%s] [ActionServer] Aborting handle.", name_.c_str());
      handle->abort(result);
    }
    handle.reset();
  }

private:
  std::shared_ptr<const Goal> goal_of(const Handle & handle, const char * which) const
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (!is_active(handle)) {
      RCLCPP_ERROR(logger_, "[%s] [ActionServer] A goal is not available or has reached a final state: %s", name_.c_str(), which);
      return nullptr;
    }
    return handle->get_goal();
  }
  void tell_completed()
  {
    if (completed_) {
      completed_();
    }
  }
  void end_all()
  {
    terminate_all();
    tell_completed();
  }

  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base_;
  rclcpp::Logger logger_;
  std::string name_;
  ExecuteCallback execute_;
  CompletionCallback completed_;
  std::chrono::milliseconds timeout_;
  mutable std::recursive_mutex lock_;
  bool active_ = false;
  bool stops_ = false;
  bool preempted_ = false;
  Handle current_;
  Handle pending_;
  rclcpp::CallbackGroup::SharedPtr group_;
  typename rclcpp_action::Server<ActionT>::SharedPtr server_;
  std::unique_ptr<NodeThread> thread_;
  std::future<void> running_;
};
}  // namespace nav2_util
