// A state that a controller reads, and gives back at its end.
#pragma once
#include <functional>
#include <string>
#include <utility>

#include "hardware_interface/handle.hpp"

namespace hardware_interface
{
class LoanedStateInterface
{
public:
  using Deleter = std::function<void (void)>;

  explicit LoanedStateInterface(StateInterface & state_interface)
  : LoanedStateInterface(state_interface, nullptr) {}
  LoanedStateInterface(StateInterface & state_interface, Deleter && deleter)
  : state_interface_(state_interface), deleter_(std::move(deleter)) {}
  LoanedStateInterface(const LoanedStateInterface &) = delete;
  LoanedStateInterface(LoanedStateInterface && other)
  : state_interface_(other.state_interface_), deleter_(std::exchange(other.deleter_, nullptr)) {}
  virtual ~LoanedStateInterface()
  {
    if (deleter_) {
      deleter_();
    }
  }

  const std::string get_name() const {return state_interface_.get_name();}
  [[deprecated("Use get_name() instead")]] const std::string get_full_name() const {return get_name();}
  const std::string & get_interface_name() const {return state_interface_.get_interface_name();}
  const std::string & get_prefix_name() const {return state_interface_.get_prefix_name();}
  double get_value() const {return state_interface_.get_value();}

protected:
  StateInterface & state_interface_;
  Deleter deleter_;
};
}  // namespace hardware_interface
