#pragma once
#include <filesystem>

#include "ament_index_cpp/get_package_prefix.hpp"

namespace ament_index_cpp
{
/// All resources of a type, each with the prefix that lists it first.
inline std::map<std::string, std::string> get_resources(const std::string & type)
{
  if (type.empty()) {
    throw std::runtime_error("ament_index_cpp::get_resources() resource type must not be empty");
  }
  std::map<std::string, std::string> all;
  for (auto & prefix : get_search_paths()) {
    std::error_code why_not;
    for (auto & entry : std::filesystem::directory_iterator(prefix + "/share/ament_index/resource_index/" + type, why_not)) {
      std::string name = entry.path().filename().string();
      if (name[0] != '.' && entry.is_regular_file(why_not)) {
        all.emplace(name, prefix);
      }
    }
  }
  return all;
}
}  // namespace ament_index_cpp
