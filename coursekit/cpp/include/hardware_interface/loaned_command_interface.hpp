// A command that a controller has claimed, and gives back at its end.
#pragma once
#include <functional>
#include <string>
#include <utility>

#include "hardware_interface/handle.hpp"

namespace hardware_interface
{
class LoanedCommandInterface
{
public:
  using Deleter = std::function<void (void)>;

  explicit LoanedCommandInterface(CommandInterface & command_interface)
  : LoanedCommandInterface(command_interface, nullptr) {}
  LoanedCommandInterface(CommandInterface & command_interface, Deleter && deleter)
  : command_interface_(command_interface), deleter_(std::move(deleter)) {}
  LoanedCommandInterface(const LoanedCommandInterface &) = delete;
  LoanedCommandInterface(LoanedCommandInterface && other)
  : command_interface_(other.command_interface_), deleter_(std::exchange(other.deleter_, nullptr)) {}
  virtual ~LoanedCommandInterface()
  {
    if (deleter_) {
      deleter_();
    }
  }

  const std::string get_name() const {return command_interface_.get_name();}
  [[deprecated("Use get_name() instead")]] const std::string get_full_name() const {return get_name();}
  const std::string & get_interface_name() const {return command_interface_.get_interface_name();}
  const std::string & get_prefix_name() const {return command_interface_.get_prefix_name();}
  void set_value(double value) {command_interface_.set_value(value);}
  double get_value() const {return command_interface_.get_value();}

protected:
  CommandInterface & command_interface_;
  Deleter deleter_;
};
}  // namespace hardware_interface
