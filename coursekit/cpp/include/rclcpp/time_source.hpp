// Which node's time a clock shows.
#pragma once
#include "rclcpp/node.hpp"

namespace rclcpp
{
/// Has clocks follow the ROS time of a node: /clock, where its parameter use_sim_time says so.
class TimeSource
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimeSource)
  explicit TimeSource(const QoS & = ClockQoS(), bool = true) {}
  explicit TimeSource(Node::SharedPtr node, const QoS & = ClockQoS(), bool = true) {attachNode(node);}
  ~TimeSource() {detachNode();}

  void attachNode(Node::SharedPtr node) {attach(node->get_node_base_interface());}
  void attachNode(
    node_interfaces::NodeBaseInterface::SharedPtr base, node_interfaces::NodeTopicsInterface::SharedPtr,
    node_interfaces::NodeGraphInterface::SharedPtr, node_interfaces::NodeServicesInterface::SharedPtr,
    node_interfaces::NodeLoggingInterface::SharedPtr, node_interfaces::NodeClockInterface::SharedPtr,
    node_interfaces::NodeParametersInterface::SharedPtr)
  {
    attach(base);
  }
  void detachNode() {attach(nullptr);}
  void attachClock(Clock::SharedPtr clock)
  {
    if (clock->get_clock_type() != RCL_ROS_TIME) {
      throw std::invalid_argument("ros_time_source::attachClock: clock type must be RCL_ROS_TIME");
    }
    clock->follow(number());
    clocks_.push_back(clock);
  }
  void detachClock(Clock::SharedPtr clock)
  {
    clock->follow(0);
    clocks_.erase(std::remove(clocks_.begin(), clocks_.end(), clock), clocks_.end());
  }

private:
  int64_t number() const {return node_ ? node_->id : 0;}
  void attach(node_interfaces::NodeBaseInterface::SharedPtr node)
  {
    node_ = std::move(node);
    for (auto & clock : clocks_) {
      clock->follow(number());
    }
  }
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::vector<Clock::SharedPtr> clocks_;
};
}  // namespace rclcpp
