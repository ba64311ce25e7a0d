#pragma once
#include "ament_index_cpp/get_package_prefix.hpp"

namespace ament_index_cpp
{
/// The folder of a package's launch files, parameters and other data.
inline std::string get_package_share_directory(const std::string & name) {return get_package_prefix(name) + "/share/" + name;}
}  // namespace ament_index_cpp
