// Where the system looks for libraries.
#pragma once
#include <string>

namespace rcpputils
{
/// The file of a library in the folders of LD_LIBRARY_PATH (DYLD_LIBRARY_PATH, PATH); empty where none has it.
std::string find_library_path(const std::string & library_name);
/// The file of a library in a folder; empty where it is not there.
std::string path_for_library(const std::string & directory, const std::string & library_name);
/// The name of a library's file on this system.
std::string filename_for_library(const std::string & library_name);
}  // namespace rcpputils
