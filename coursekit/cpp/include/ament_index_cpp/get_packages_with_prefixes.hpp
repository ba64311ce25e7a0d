#pragma once
#include "ament_index_cpp/get_resources.hpp"

namespace ament_index_cpp
{
/// All packages, with where they are installed.
inline std::map<std::string, std::string> get_packages_with_prefixes() {return get_resources("packages");}
}  // namespace ament_index_cpp
