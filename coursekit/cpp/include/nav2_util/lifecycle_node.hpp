// The managed node of nav2's servers.
#pragma once
#include <memory>
#include <string>

#include "nav2_util/node_utils.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_util
{
using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class LifecycleNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNode)
  explicit LifecycleNode(
    const std::string & node_name, const std::string & ns = "", const rclcpp::NodeOptions & options = rclcpp::NodeOptions());
  explicit LifecycleNode(rclcpp::SharedNode node)
  : rclcpp_lifecycle::LifecycleNode(node) {}
  ~LifecycleNode() override;

  struct floating_point_range
  {
    double from_value;
    double to_value;
    double step;
  };
  struct integer_range
  {
    int from_value;
    int to_value;
    int step;
  };
  void add_parameter(
    const std::string & name, const rclcpp::ParameterValue & default_value, const std::string & description = "",
    const std::string & additional_constraints = "", bool read_only = false);
  void add_parameter(
    const std::string & name, const rclcpp::ParameterValue & default_value, const floating_point_range fp_range,
    const std::string & description = "", const std::string & additional_constraints = "", bool read_only = false);
  void add_parameter(
    const std::string & name, const rclcpp::ParameterValue & default_value, const integer_range int_range,
    const std::string & description = "", const std::string & additional_constraints = "", bool read_only = false);

  std::shared_ptr<LifecycleNode> shared_from_this()
  {
    return std::static_pointer_cast<LifecycleNode>(rclcpp_lifecycle::LifecycleNode::shared_from_this());
  }
  nav2_util::CallbackReturn on_error(const rclcpp_lifecycle::State & state) override;
  /// The lifecycle manager here asks for no bonds: a session sees when a node ends.
  void createBond() {}
  void destroyBond() {}

protected:
  void printLifecycleNodeNotification();
};
}  // namespace nav2_util
