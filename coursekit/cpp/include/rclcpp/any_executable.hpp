// A callback that is ready, which an executor of one's own runs when it likes.
#pragma once
#include <memory>

#include "coursekit/entity.hpp"
#include "rclcpp/callback_group.hpp"

namespace rclcpp
{
namespace node_interfaces
{
class NodeBaseInterface;
}

/// One that goes without being run gives its callback group free again.
struct AnyExecutable : coursekit::Entity
{
  RCLCPP_SMART_PTR_DEFINITIONS(AnyExecutable)

  // -- whose callback it is: one of these, none where the node has it for itself, as its services of parameters

  std::shared_ptr<SubscriptionBase> subscription;
  std::shared_ptr<TimerBase> timer;
  std::shared_ptr<ServiceBase> service;
  std::shared_ptr<ClientBase> client;
  std::shared_ptr<Waitable> waitable;

  std::shared_ptr<CallbackGroup> callback_group;
  std::shared_ptr<node_interfaces::NodeBaseInterface> node_base;
  std::shared_ptr<void> data;
};
}  // namespace rclcpp
