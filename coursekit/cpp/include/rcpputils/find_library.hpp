// Where the system looks for libraries.
#pragma once
#include <string>

namespace rcpputils
{
/// The file of a library in the folders of LD_LIBRARY_PATH (DYLD_LIBRARY_PATH, PATH); empty where none has it.
std::string find_library_path(const std::string & library_name);
/// A path with the file name of a library on this system, with nothing looked for.
std::string path_for_library(const std::string & directory, const std::string & library_name);
}  // namespace rcpputils
