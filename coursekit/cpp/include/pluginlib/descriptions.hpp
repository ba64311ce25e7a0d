// The plugins that packages declare in XML, as the session reads them.
#pragma once
#include <string>
#include <vector>

namespace pluginlib
{
struct Description
{
  std::string name, type, library, description, package, manifest;
  bool has_library = false;
};
/// All that the sourced workspaces declare for a base class under a package's name and an attribute, by the order of their
/// names; with paths, what these files declare.
std::vector<Description> read_descriptions(
  const std::string & package, const std::string & base_class, const std::string & attribute,
  const std::vector<std::string> & paths);
}  // namespace pluginlib
