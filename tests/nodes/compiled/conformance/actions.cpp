#include "check.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using Fibonacci = example_interfaces::action::Fibonacci;
using Serving = rclcpp_action::ServerGoalHandle<Fibonacci>;
using Client = rclcpp_action::Client<Fibonacci>;
using Code = rclcpp_action::ResultCode;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("actions");
  auto client = rclcpp_action::create_client<Fibonacci>(node, "count");
  check("no server yet", !client->action_server_is_ready() && !client->wait_for_action_server(20ms));
  std::vector<std::thread> threads;
  std::atomic<bool> enough{false};
  auto execute = [&](std::shared_ptr<Serving> goal) {
      auto result = std::make_shared<Fibonacci::Result>();
      auto feedback = std::make_shared<Fibonacci::Feedback>();
      for (int i = 0; i < goal->get_goal()->order && !enough; ++i) {
        if (goal->is_canceling()) {
          result->sequence = feedback->sequence;
          goal->canceled(result);
          return;
        }
        feedback->sequence.push_back(i);
        goal->publish_feedback(feedback);
        rclcpp::sleep_for(20ms);
      }
      result->sequence = feedback->sequence;
      if (goal->get_goal()->order == 2 || enough) {
        goal->abort(result);
      } else {
        goal->succeed(result);
      }
    };
  auto server = rclcpp_action::create_server<Fibonacci>(
    node, "count",
    [](const rclcpp_action::GoalUUID &, std::shared_ptr<const Fibonacci::Goal> goal) {
      return goal->order < 0 ? rclcpp_action::GoalResponse::REJECT : rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
    },
    [](std::shared_ptr<Serving> goal) {
      return goal->get_goal()->order == 50 ? rclcpp_action::CancelResponse::REJECT : rclcpp_action::CancelResponse::ACCEPT;
    },
    [&](std::shared_ptr<Serving> goal) {threads.emplace_back(execute, goal);});
  check("server is there", client->wait_for_action_server(1s));
  auto until = [&](auto & future) {
      return rclcpp::spin_until_future_complete(node, future, 5s) == rclcpp::FutureReturnCode::SUCCESS;
    };
  Fibonacci::Goal goal;
  goal.order = 4;
  int answered = 0, fed = 0, done = 0;
  Client::SendGoalOptions options;
  options.goal_response_callback = [&](rclcpp_action::ClientGoalHandle<Fibonacci>::SharedPtr handle) {answered += bool(handle);};
  options.feedback_callback = [&](auto, const std::shared_ptr<const Fibonacci::Feedback> f) {fed = static_cast<int>(f->sequence.size());};
  options.result_callback = [&](const rclcpp_action::ClientGoalHandle<Fibonacci>::WrappedResult & r) {
      done = r.code == Code::SUCCEEDED ? static_cast<int>(r.result->sequence.size()) : -1;
    };
  auto sent = client->async_send_goal(goal, options);
  check("a goal is accepted", until(sent) && sent.get() != nullptr);
  auto handle = sent.get();
  check("it runs", handle->get_status() == rclcpp_action::GoalStatus::STATUS_ACCEPTED ||
    handle->get_status() == rclcpp_action::GoalStatus::STATUS_EXECUTING);
  check("feedback is wanted", handle->is_feedback_aware() && handle->is_result_aware());
  auto result = client->async_get_result(handle);
  check("its result comes", until(result));
  check("it succeeded", result.get().code == Code::SUCCEEDED);
  equal("the result", result.get().result->sequence.size(), 4u);
  check("the result's goal", result.get().goal_id == handle->get_goal_id());
  check("all callbacks ran", spin_until(node, [&] {return done == 4 && answered == 1 && fed == 4;}),
    std::to_string(done) + std::to_string(answered) + std::to_string(fed));
  auto leaving = rclcpp_action::create_client<Fibonacci>(node, "count");
  auto left = leaving->async_send_goal(goal);
  check("another client's goal is accepted", until(left) && left.get() != nullptr);
  auto lost = leaving->async_get_result(left.get());
  leaving.reset();
  check("without its client nobody knows a goal's state", left.get()->get_status() == rclcpp_action::GoalStatus::STATUS_UNKNOWN);
  check("nor waits for its result", !left.get()->is_result_aware());
  throws<rclcpp_action::exceptions::UnawareGoalHandleError>("which does not come", [&] {lost.get();});
  auto states = rclcpp::Node::make_shared("states");
  std::vector<int> seen;
  auto watching = states->create_subscription<action_msgs::msg::GoalStatusArray>(
    "count/_action/status", 10, [&](const action_msgs::msg::GoalStatusArray & all) {seen.push_back(all.status_list.back().status);});
  goal.order = 0;
  auto watched = client->async_send_goal(goal);
  check("a goal is accepted while its states are watched", until(watched) && watched.get() != nullptr);
  check("its states come", spin_until(states, [&] {return seen.size() >= 2;}));
  check("it is never told as accepted that runs at once", seen == std::vector<int>{2, 4});

  goal.order = -1;
  auto refused = client->async_send_goal(goal);
  check("a goal is rejected", until(refused) && refused.get() == nullptr);
  goal.order = 2;
  auto aborting = client->async_send_goal(goal);
  until(aborting);
  auto aborted = client->async_get_result(aborting.get());
  check("a goal is aborted", until(aborted) && aborted.get().code == Code::ABORTED);
  auto stranger = rclcpp_action::create_client<Fibonacci>(node, "count");
  throws<rclcpp_action::exceptions::UnknownGoalHandleError>(
    "another client's goal", [&] {stranger->async_get_result(handle);});
  goal.order = 100;
  auto long_goal = client->async_send_goal(goal);
  until(long_goal);
  auto cancelling = client->async_cancel_goal(long_goal.get());
  check("a goal is cancelled", until(cancelling));
  equal("one is cancelling", cancelling.get()->goals_canceling.size(), 1u);
  auto cancelled = client->async_get_result(long_goal.get());
  check("with this result", until(cancelled) && cancelled.get().code == Code::CANCELED);
  equal("its status is then the result's", int{long_goal.get()->get_status()}, int{rclcpp_action::GoalStatus::STATUS_CANCELED});
  goal.order = 50;
  auto stubborn = client->async_send_goal(goal);
  until(stubborn);
  auto asked = client->async_cancel_goal(stubborn.get());
  until(asked);
  check("a goal may refuse that", asked.get()->return_code == Client::CancelResponse::ERROR_REJECTED);
  auto all = client->async_cancel_all_goals();
  check("all are asked", until(all));
  check("a goal's number as text", !rclcpp_action::to_string(handle->get_goal_id()).empty());
  std::unordered_map<rclcpp_action::GoalUUID, int> numbers{{handle->get_goal_id(), 1}};
  equal("a goal's number as key", numbers.at(handle->get_goal_id()), 1);
  auto of_interfaces = rclcpp_action::create_client<Fibonacci>(
    node->get_node_base_interface(), node->get_node_graph_interface(), node->get_node_logging_interface(),
    node->get_node_waitables_interface(), "count");
  check("a client of a node's interfaces", of_interfaces->wait_for_action_server(1s));
  enough = true;
  for (auto & thread : threads) {
    thread.join();
  }
  rclcpp::shutdown();
}
