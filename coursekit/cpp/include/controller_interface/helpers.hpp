// Lists of interfaces.
#pragma once
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace controller_interface
{
/// Put the interfaces in the order of names: of joints, if a type is given, else whole names. False unless all were there.
template<class T>
bool get_ordered_interfaces(
  std::vector<T> & unordered_interfaces, const std::vector<std::string> & ordered_names, const std::string & interface_type,
  std::vector<std::reference_wrapper<T>> & ordered_interfaces)
{
  ordered_interfaces.reserve(ordered_names.size());
  for (auto & name : ordered_names) {
    const std::string whole = interface_type.empty() ? name : name + "/" + interface_type;
    for (auto & one : unordered_interfaces) {
      if (one.get_name() == whole) {
        ordered_interfaces.push_back(std::ref(one));
      }
    }
  }
  return ordered_names.size() == ordered_interfaces.size();
}
inline bool interface_list_contains_interface_type(
  const std::vector<std::string> & interface_type_list, const std::string & interface_type)
{
  return std::find(interface_type_list.begin(), interface_type_list.end(), interface_type) != interface_type_list.end();
}
}  // namespace controller_interface
