// Parameters of many nodes, as a file has them.
#pragma once
#include <unordered_map>
#include <vector>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp
{
using ParameterMap = std::unordered_map<std::string, std::vector<Parameter>>;

namespace detail
{
/// The parameters of a file; of one node where it is named.
ParameterMap parameter_file(const std::string & path, const std::string & node);
}  // namespace detail
inline ParameterMap parameter_map_from_yaml_file(const std::string & path) {return detail::parameter_file(path, "");}
/// All parameters of a map, of one node where it is named.
inline std::vector<Parameter> parameters_from_map(const ParameterMap & map, const char * node = nullptr)
{
  std::vector<Parameter> all;
  for (auto & entry : map) {
    if (!node || entry.first == node || entry.first == "/**") {
      all.insert(all.end(), entry.second.begin(), entry.second.end());
    }
  }
  return all;
}
}  // namespace rclcpp
