// A thread that spins a node.
#pragma once
#include <memory>
#include <thread>

#include "rclcpp/rclcpp.hpp"

namespace nav2_util
{
class NodeThread
{
public:
  explicit NodeThread(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base)
  : node_(std::move(node_base)), executor_(std::make_shared<rclcpp::executors::SingleThreadedExecutor>())
  {
    executor_->add_node(node_);
    thread_ = std::thread([this] {executor_->spin();});
  }
  explicit NodeThread(rclcpp::executors::SingleThreadedExecutor::SharedPtr executor)
  : executor_(std::move(executor)), thread_([this] {executor_->spin();}) {}
  template<typename NodeT>
  explicit NodeThread(NodeT node)
  : NodeThread(node->get_node_base_interface()) {}
  ~NodeThread()
  {
    executor_->cancel();
    thread_.join();
    if (node_) {
      executor_->remove_node(node_);
    }
  }

private:
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_;
  rclcpp::executors::SingleThreadedExecutor::SharedPtr executor_;
  std::thread thread_;
};
}  // namespace nav2_util
