// Several states that together mean one thing.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "controller_interface/helpers.hpp"
#include "hardware_interface/loaned_state_interface.hpp"

namespace semantic_components
{
template<class MessageReturnType>
class SemanticComponentInterface
{
public:
  explicit SemanticComponentInterface(const std::string & name, size_t size = 0)
  : name_(name)
  {
    interface_names_.reserve(size);
    state_interfaces_.reserve(size);
  }
  virtual ~SemanticComponentInterface() = default;

  bool assign_loaned_state_interfaces(std::vector<hardware_interface::LoanedStateInterface> & state_interfaces)
  {
    return controller_interface::get_ordered_interfaces(state_interfaces, interface_names_, "", state_interfaces_);
  }
  void release_interfaces() {state_interfaces_.clear();}
  virtual std::vector<std::string> get_state_interface_names() {return interface_names_;}
  /// The numbers of all states; false where the list has no room for them.
  bool get_values(std::vector<double> & values) const
  {
    if (values.capacity() != state_interfaces_.size()) {
      return false;
    }
    for (auto & one : state_interfaces_) {
      values.push_back(one.get().get_value());
    }
    return true;
  }
  bool get_values_as_message(MessageReturnType &) {return false;}

protected:
  std::string name_;
  std::vector<std::string> interface_names_;
  std::vector<std::reference_wrapper<hardware_interface::LoanedStateInterface>> state_interfaces_;
};
}  // namespace semantic_components
