#pragma once
#include "ament_index_cpp/get_package_prefix.hpp"

namespace ament_index_cpp
{
/// Whether a prefix lists a resource; which prefix it is.
inline bool has_resource(const std::string & type, const std::string & name, std::string * where = nullptr)
{
  for (auto & prefix : get_search_paths()) {
    if (has_resource_at(prefix, type, name)) {
      if (where) {
        *where = prefix;
      }
      return true;
    }
  }
  return false;
}
}  // namespace ament_index_cpp
