// A controller that other controllers may command by its reference interfaces.
#pragma once
#include "controller_interface/controller_interface_base.hpp"

namespace controller_interface
{
class ChainableControllerInterface : public ControllerInterfaceBase
{
public:
  return_type update(const rclcpp::Time & time, const rclcpp::Duration & period) final;
  bool is_chainable() const final {return true;}
  std::vector<hardware_interface::CommandInterface> export_reference_interfaces() final;
  bool set_chained_mode(bool chained_mode) final;
  bool is_in_chained_mode() const final {return in_chained_mode_;}

protected:
  virtual std::vector<hardware_interface::CommandInterface> on_export_reference_interfaces() = 0;
  /// Whether the mode may be changed.
  virtual bool on_set_chained_mode(bool) {return true;}
  /// Called outside of chains alone.
  virtual return_type update_reference_from_subscribers() = 0;
  virtual return_type update_and_write_commands(const rclcpp::Time & time, const rclcpp::Duration & period) = 0;

  std::vector<double> reference_interfaces_;

private:
  bool in_chained_mode_ = false;
};
}  // namespace controller_interface
