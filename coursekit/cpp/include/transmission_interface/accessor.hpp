// Handles by the names of what they belong to.
#pragma once
#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "transmission_interface/exception.hpp"

namespace transmission_interface
{
template<class T>
std::string to_string(const std::vector<T> & list)
{
  std::ostringstream out;
  out << "[";
  for (const auto & one : list) {
    out << " " << one;
  }
  out << " ]";
  return out.str();
}

/// The names of joints or actuators, each once, in the order of the alphabet.
template<class T>
std::vector<std::string> get_names(const std::vector<T> & handles)
{
  std::set<std::string> names;
  for (const auto & handle : handles) {
    names.insert(handle.get_prefix_name());
  }
  return {names.begin(), names.end()};
}

/// Those of one interface that have a number, in the order of the names.
template<class T>
std::vector<T> get_ordered_handles(
  const std::vector<T> & unordered, const std::vector<std::string> & names, const std::string & interface_type)
{
  std::vector<T> ordered;
  for (const auto & name : names) {
    std::copy_if(
      unordered.begin(), unordered.end(), std::back_inserter(ordered), [&](const T & handle) {
        return handle.get_prefix_name() == name && handle.get_interface_name() == interface_type && handle;
      });
  }
  return ordered;
}
}  // namespace transmission_interface
