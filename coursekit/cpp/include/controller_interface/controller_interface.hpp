// A controller that no other controller commands.
#pragma once
#include "controller_interface/controller_interface_base.hpp"

namespace controller_interface
{
class ControllerInterface : public ControllerInterfaceBase
{
public:
  bool is_chainable() const final {return false;}
  std::vector<hardware_interface::CommandInterface> export_reference_interfaces() final {return {};}
  bool set_chained_mode(bool) final {return false;}
  bool is_in_chained_mode() const final {return false;}
};
using ControllerInterfaceSharedPtr = std::shared_ptr<ControllerInterface>;
}  // namespace controller_interface
