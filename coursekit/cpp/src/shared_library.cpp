// Libraries and the program's file by the names that rcpputils gives them.
#include <stdexcept>

#include "rcpputils/env.hpp"
#include "rcpputils/filesystem_helper.hpp"
#include "rcpputils/find_library.hpp"
#include "rcpputils/process.hpp"
#include "rcpputils/shared_library.hpp"
#include "rcpputils/split.hpp"
#include "system.hpp"

namespace rcpputils
{
namespace
{
#if defined(_WIN32)
const char * const VARIABLE = "PATH", * const PREFIX = "", * const SUFFIX = ".dll";
constexpr char SEPARATOR = ';';
#elif defined(__APPLE__)
const char * const VARIABLE = "DYLD_LIBRARY_PATH", * const PREFIX = "lib", * const SUFFIX = ".dylib";
constexpr char SEPARATOR = ':';
#else
const char * const VARIABLE = "LD_LIBRARY_PATH", * const PREFIX = "lib", * const SUFFIX = ".so";
constexpr char SEPARATOR = ':';
#endif
}  // namespace

SharedLibrary::SharedLibrary(const std::string & library_path)
: path_(library_path)
{
  std::string reason;
  library_ = coursekit::load_library(library_path, reason);
  if (!library_) {
    throw std::runtime_error("Could not load library " + library_path + ": " + reason);
  }
}
SharedLibrary::SharedLibrary()
: library_(nullptr), path_(coursekit::executable()) {}
SharedLibrary::~SharedLibrary() {unload_library();}
void SharedLibrary::unload_library()
{
  if (library_) {
    coursekit::unload_library(library_);
  }
  library_ = nullptr;
}
bool SharedLibrary::has_symbol(const std::string & symbol_name)
{
  return library_ && coursekit::symbol_of(library_, symbol_name);
}
void * SharedLibrary::get_symbol(const std::string & symbol_name)
{
  void * found = library_ ? coursekit::symbol_of(library_, symbol_name) : nullptr;
  if (!found) {
    throw std::runtime_error("Could not find symbol '" + symbol_name + "' in the library '" + path_ + "'");
  }
  return found;
}
std::string get_platform_library_name(const std::string & library_name, bool debug)
{
  return PREFIX + library_name + (debug ? "d" : "") + SUFFIX;
}

std::string path_for_library(const std::string & directory, const std::string & library_name)
{
  return (fs::path(directory) / get_platform_library_name(library_name)).string();
}
std::string find_library_path(const std::string & library_name)
{
  for (auto & folder : split(get_env_var(VARIABLE), SEPARATOR, true)) {
    std::string path = path_for_library(folder, library_name);
    if (fs::is_regular_file(path)) {
      return path;
    }
  }
  return "";
}

std::string get_executable_name()
{
  std::string path = coursekit::executable();
  if (path.empty()) {
    throw std::runtime_error("failed to get executable name");
  }
#ifdef _WIN32
  return fs::path(path).stem().string();
#else
  return fs::path(path).filename().string();
#endif
}
}  // namespace rcpputils
