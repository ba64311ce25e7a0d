// Parameters of many nodes, as a file has them.
#pragma once
#include <unordered_map>
#include <vector>

#include "rcl_yaml_param_parser/parser.h"
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
/// The parameters of a file; where a node is named, those whose pattern fits it, under its name.
inline ParameterMap parameter_map_from_yaml_file(const std::string & path, const char * node_fqn = nullptr)
{
  return detail::parameter_file(path, node_fqn ? node_fqn : "");
}
/// The same of C's structure; throws InvalidParametersException where something of it is null.
ParameterMap parameter_map_from(const rcl_params_t * params, const char * node_fqn = nullptr);
/// A value of C's; throws InvalidParameterValueException where it has none.
ParameterValue parameter_value_from(const rcl_variant_t * value);
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
