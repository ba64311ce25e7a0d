// Libraries that a program loads while it runs.
#pragma once
#include <string>

namespace rcpputils
{
class SharedLibrary
{
public:
  /// Load it; std::runtime_error where that fails.
  explicit SharedLibrary(const std::string & library_path);
  /// The program itself, with all that it is linked with.
  SharedLibrary();
  SharedLibrary(const SharedLibrary &) = delete;
  SharedLibrary & operator=(const SharedLibrary &) = delete;
  virtual ~SharedLibrary();
  /// std::runtime_error where it has been unloaded before.
  void unload_library();
  /// What the library exports under a name; std::runtime_error where there is nothing.
  void * get_symbol(const std::string & symbol_name);
  void * get_symbol(const char * symbol_name) {return get_symbol(std::string(symbol_name));}
  bool has_symbol(const std::string & symbol_name);
  bool has_symbol(const char * symbol_name) {return has_symbol(std::string(symbol_name));}
  std::string get_library_path() {return path_;}

private:
  void * library_;
  std::string path_;
};
/// A library's file name on this system: libname.so, libname.dylib or name.dll; std::runtime_error where that is too long.
std::string get_platform_library_name(const std::string & library_name, bool debug = false);
}  // namespace rcpputils
