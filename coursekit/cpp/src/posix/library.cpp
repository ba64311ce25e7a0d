// Libraries that a program loads while it runs, and the program's own file.
#include <dlfcn.h>
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

#include "../system.hpp"

namespace coursekit
{
void * load_library(const std::string & path, std::string & reason)
{
  void * library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    reason = dlerror();
  }
  return library;
}
void * symbol_of(void * library, const std::string & name) {return dlsym(library, name.c_str());}
void unload_library(void * library) {dlclose(library);}
std::string executable()
{
  char path[4096];
#ifdef __APPLE__
  uint32_t size = sizeof(path);
  return _NSGetExecutablePath(path, &size) == 0 ? path : "";
#else
  ssize_t size = readlink("/proc/self/exe", path, sizeof(path));
  return size > 0 ? std::string(path, static_cast<size_t>(size)) : "";
#endif
}
}  // namespace coursekit
