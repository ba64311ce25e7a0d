// This program.
#pragma once
#include <string>

namespace rcpputils
{
/// The name of the file that runs; std::runtime_error where the system does not say.
std::string get_executable_name();
}  // namespace rcpputils
