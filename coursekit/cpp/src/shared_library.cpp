// Libraries and the program's file by the names that rcpputils and rcutils give them.
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "rcpputils/env.hpp"
#include "rcpputils/filesystem_helper.hpp"
#include "rcpputils/find_library.hpp"
#include "rcpputils/process.hpp"
#include "rcpputils/shared_library.hpp"
#include "rcpputils/split.hpp"
#include "rcutils/error_handling.h"
#include "rcutils/process.h"
#include "rcutils/shared_library.h"
#include "rcutils/strdup.h"
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
SharedLibrary::~SharedLibrary()
{
  if (library_) {
    coursekit::unload_library(library_);
  }
}
void SharedLibrary::unload_library()
{
  if (!library_) {
    throw std::runtime_error("invalid lib_pointer argument");
  }
  coursekit::unload_library(std::exchange(library_, nullptr));
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
  char name[1024];
  if (rcutils_get_platform_library_name(library_name.c_str(), name, sizeof(name), debug) != RCUTILS_RET_OK) {
    rcutils_reset_error();
    throw std::runtime_error("failed to format library name");
  }
  return name;
}
std::string filename_for_library(const std::string & library_name) {return PREFIX + library_name + SUFFIX;}

std::string path_for_library(const std::string & directory, const std::string & library_name)
{
  fs::path path = fs::path(directory) / filename_for_library(library_name);
  return path.is_regular_file() ? path.string() : "";
}
std::string find_library_path(const std::string & library_name)
{
  for (auto & folder : split(get_env_var(VARIABLE), SEPARATOR, true)) {
    std::string path = path_for_library(folder, library_name);
    if (!path.empty()) {
      return path;
    }
  }
  return "";
}

std::string get_executable_name()
{
  auto allocator = rcutils_get_default_allocator();
  char * found = rcutils_get_executable_name(allocator);
  if (!found) {
    throw std::runtime_error("failed to get executable name");
  }
  std::string name = found;
  allocator.deallocate(found, allocator.state);
  return name;
}
}  // namespace rcpputils

char * rcutils_get_executable_name(rcutils_allocator_t allocator)
{
  const std::filesystem::path path = coursekit::executable();
#ifdef _WIN32
  const std::string name = path.stem().string();
#else
  const std::string name = path.filename().string();
#endif
  return name.empty() ? nullptr : rcutils_strdup(name.c_str(), allocator);
}

static rcutils_ret_t fail(rcutils_ret_t how, const std::string & why)
{
  RCUTILS_SET_ERROR_MSG(why.c_str());
  return how;
}
rcutils_ret_t rcutils_load_shared_library(
  rcutils_shared_library_t * library, const char * path, rcutils_allocator_t allocator)
{
  if (!library || !path || library->lib_pointer || !rcutils_allocator_is_valid(&allocator)) {
    return fail(RCUTILS_RET_INVALID_ARGUMENT, "library, path or allocator is missing, or the library is loaded already");
  }
  char * kept = rcutils_strdup(path, allocator);
  if (!kept) {
    return fail(RCUTILS_RET_BAD_ALLOC, "unable to allocate memory");
  }
  std::string reason;
  void * loaded = coursekit::load_library(path, reason);
  if (!loaded) {
    allocator.deallocate(kept, allocator.state);
    return fail(RCUTILS_RET_ERROR, "LoadLibrary error: " + reason);
  }
  *library = {loaded, kept, allocator};
  return RCUTILS_RET_OK;
}
bool rcutils_has_symbol(const rcutils_shared_library_t * library, const char * name)
{
  return library && library->lib_pointer && name && coursekit::symbol_of(library->lib_pointer, name);
}
void * rcutils_get_symbol(const rcutils_shared_library_t * library, const char * name)
{
  if (!rcutils_has_symbol(library, name)) {
    fail(RCUTILS_RET_ERROR, "Error getting the symbol '" + std::string(name ? name : "") + "'");
    return nullptr;
  }
  return coursekit::symbol_of(library->lib_pointer, name);
}
rcutils_ret_t rcutils_unload_shared_library(rcutils_shared_library_t * library)
{
  if (!rcutils_is_shared_library_loaded(library)) {
    return fail(RCUTILS_RET_INVALID_ARGUMENT, "invalid lib_pointer argument");
  }
  coursekit::unload_library(library->lib_pointer);
  library->allocator.deallocate(library->library_path, library->allocator.state);
  *library = rcutils_get_zero_initialized_shared_library();
  return RCUTILS_RET_OK;
}
rcutils_ret_t rcutils_get_platform_library_name(const char * name, char * buffer, unsigned int size, bool debug)
{
  if (!name || !buffer) {
    return fail(RCUTILS_RET_INVALID_ARGUMENT, "name or buffer argument is null");
  }
  const std::string made = rcpputils::PREFIX + std::string(name) + (debug ? "d" : "") + rcpputils::SUFFIX;
  if (made.size() >= size) {
    return fail(RCUTILS_RET_ERROR, "failed to format library name");
  }
  memcpy(buffer, made.c_str(), made.size() + 1);
  return RCUTILS_RET_OK;
}
