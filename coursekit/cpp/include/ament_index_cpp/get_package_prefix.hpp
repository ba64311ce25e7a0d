// Where packages are installed.
#pragma once
#include <sys/stat.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ament_index_cpp
{
class PackageNotFoundError : public std::out_of_range
{
public:
  explicit PackageNotFoundError(const std::string & name)
  : std::out_of_range("package '" + name + "' not found, searching: [" + searched() + "]"), package_name(name) {}
  const std::string package_name;

private:
  static std::string searched()
  {
    const char * path = std::getenv("AMENT_PREFIX_PATH");
    return path ? path : "";
  }
};

/// The prefixes of all sourced workspaces, the last one sourced first.
inline std::vector<std::string> get_search_paths()
{
  const char * path = std::getenv("AMENT_PREFIX_PATH");
  std::vector<std::string> prefixes;
  std::istringstream parts(path ? path : "");
  for (std::string part; std::getline(parts, part, ':'); ) {
    if (!part.empty()) {
      prefixes.push_back(part);
    }
  }
  return prefixes;
}
/// Whether the index of a prefix lists a resource, such as the package of that name.
inline bool has_resource_at(const std::string & prefix, const std::string & type, const std::string & name)
{
  struct stat found;
  return stat((prefix + "/share/ament_index/resource_index/" + type + "/" + name).c_str(), &found) == 0;
}
inline std::string get_package_prefix(const std::string & name)
{
  for (auto & prefix : get_search_paths()) {
    if (has_resource_at(prefix, "packages", name)) {
      return prefix;
    }
  }
  throw PackageNotFoundError(name);
}
}  // namespace ament_index_cpp
