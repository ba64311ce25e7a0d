// What all controllers have: a managed node, and the interfaces that they claim.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "controller_interface/visibility_control.h"
#include "hardware_interface/handle.hpp"
#include "hardware_interface/loaned_command_interface.hpp"
#include "hardware_interface/loaned_state_interface.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/node_interfaces/lifecycle_node_interface.hpp"

namespace controller_interface
{
using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

enum class return_type : std::uint8_t {OK = 0, ERROR = 1};
enum class interface_configuration_type : std::uint8_t {ALL = 0, INDIVIDUAL = 1, NONE = 2};
struct InterfaceConfiguration
{
  interface_configuration_type type;
  std::vector<std::string> names = {};
};

class ControllerInterfaceBase : public rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface
{
public:
  ControllerInterfaceBase() = default;

  virtual InterfaceConfiguration command_interface_configuration() const = 0;
  virtual InterfaceConfiguration state_interface_configuration() const = 0;
  virtual CallbackReturn on_init() = 0;
  virtual return_type update(const rclcpp::Time & time, const rclcpp::Duration & period) = 0;
  virtual bool is_chainable() const = 0;
  virtual std::vector<hardware_interface::CommandInterface> export_reference_interfaces() = 0;
  virtual bool set_chained_mode(bool chained_mode) = 0;
  virtual bool is_in_chained_mode() const = 0;

  /// Make the node and call on_init.
  virtual return_type init(
    const std::string & controller_name, const std::string & namespace_ = "",
    const rclcpp::NodeOptions & node_options =
    rclcpp::NodeOptions().allow_undeclared_parameters(true).automatically_declare_parameters_from_overrides(true));
  const rclcpp_lifecycle::State & configure();
  void assign_interfaces(
    std::vector<hardware_interface::LoanedCommandInterface> && command_interfaces,
    std::vector<hardware_interface::LoanedStateInterface> && state_interfaces);
  void release_interfaces();

  /// Throws std::runtime_error before init.
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> get_node() const;
  const rclcpp_lifecycle::State & get_state() const;
  unsigned int get_update_rate() const {return update_rate_;}

  /// The parameter's value, after declaring it where it is not.
  template<class ParameterT>
  auto auto_declare(const std::string & name, const ParameterT & default_value)
  {
    if (!node_->has_parameter(name)) {
      return node_->declare_parameter<ParameterT>(name, default_value);
    }
    return node_->get_parameter(name).template get_value<ParameterT>();
  }

protected:
  std::vector<hardware_interface::LoanedCommandInterface> command_interfaces_;
  std::vector<hardware_interface::LoanedStateInterface> state_interfaces_;
  unsigned int update_rate_ = 0;

private:
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node_;
};
using ControllerInterfaceBaseSharedPtr = std::shared_ptr<ControllerInterfaceBase>;
}  // namespace controller_interface
