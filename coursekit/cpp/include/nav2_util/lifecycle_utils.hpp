// Several nodes brought up or reset, one after the other.
#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "lifecycle_msgs/msg/transition.hpp"
#include "nav2_util/lifecycle_service_client.hpp"
#include "nav2_util/string_utils.hpp"

namespace nav2_util
{
/// Make a transition; a service that does not answer is asked so many times more.
inline void change_state(
  LifecycleServiceClient & client, uint8_t transition, std::chrono::seconds timeout, int retries)
{
  for (int left = retries; ; --left) {
    try {
      client.change_state(transition, timeout);
      return;
    } catch (const std::runtime_error &) {
      if (left <= 0) {
        throw;
      }
    }
  }
}
/// Take each node through these transitions, one node after the other.
inline void change_states(
  const std::vector<std::string> & node_names, std::initializer_list<uint8_t> transitions, std::chrono::seconds timeout,
  int retries)
{
  for (const auto & name : node_names) {
    LifecycleServiceClient client(name);
    for (const uint8_t transition : transitions) {
      change_state(client, transition, timeout, retries);
    }
  }
}
/// Configure and activate them; throws std::runtime_error for a node that does not answer.
inline void startup_lifecycle_nodes(
  const std::vector<std::string> & node_names, const std::chrono::seconds service_call_timeout = std::chrono::seconds::max(),
  const int retries = 3)
{
  using Transition = lifecycle_msgs::msg::Transition;
  change_states(node_names, {Transition::TRANSITION_CONFIGURE, Transition::TRANSITION_ACTIVATE}, service_call_timeout, retries);
}
/// The same for names with ':' between them.
inline void startup_lifecycle_nodes(
  const std::string & nodes, const std::chrono::seconds service_call_timeout = std::chrono::seconds::max(),
  const int retries = 3)
{
  startup_lifecycle_nodes(split(nodes, ':'), service_call_timeout, retries);
}
/// Deactivate them and clean up.
inline void reset_lifecycle_nodes(
  const std::vector<std::string> & node_names, const std::chrono::seconds service_call_timeout = std::chrono::seconds::max(),
  const int retries = 3)
{
  using Transition = lifecycle_msgs::msg::Transition;
  change_states(node_names, {Transition::TRANSITION_DEACTIVATE, Transition::TRANSITION_CLEANUP}, service_call_timeout, retries);
}
inline void reset_lifecycle_nodes(
  const std::string & nodes, const std::chrono::seconds service_call_timeout = std::chrono::seconds::max(),
  const int retries = 3)
{
  reset_lifecycle_nodes(split(nodes, ':'), service_call_timeout, retries);
}
}  // namespace nav2_util
