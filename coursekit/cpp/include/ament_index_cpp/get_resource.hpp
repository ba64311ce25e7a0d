#pragma once
#include <fstream>
#include <iterator>

#include "ament_index_cpp/get_package_prefix.hpp"

namespace ament_index_cpp
{
/// The text of a resource of the first prefix that lists it, and which prefix that is; false where none does.
inline bool get_resource(const std::string & type, const std::string & name, std::string & content, std::string * where = nullptr)
{
  if (type.empty() || name.empty()) {
    const std::string what = type.empty() ? "type" : "name";
    throw std::runtime_error("ament_index_cpp::get_resource() resource " + what + " must not be empty");
  }
  for (auto & prefix : get_search_paths()) {
    if (has_resource_at(prefix, type, name)) {
      std::ifstream file(prefix + "/share/ament_index/resource_index/" + type + "/" + name);
      content.assign(std::istreambuf_iterator<char>(file), {});
      if (where) {
        *where = prefix;
      }
      return true;
    }
  }
  return false;
}
}  // namespace ament_index_cpp
