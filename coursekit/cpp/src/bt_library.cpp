// Libraries of nodes for trees.
#include "behaviortree_cpp_v3/utils/shared_library.h"

#include "behaviortree_cpp_v3/exceptions.h"
#include "class_loader/exceptions.hpp"
#include "class_loader/registry.hpp"
#include "system.hpp"

namespace BT
{
void SharedLibrary::load(const std::string & path, int)
{
  std::lock_guard<std::mutex> hold(mutex_);
  if (library_) {
    throw RuntimeError("Library already loaded: " + path);
  }
  try {
    library_ = class_loader::registry::load(path);
  } catch (const class_loader::LibraryLoadException & error) {
    throw RuntimeError(error.what());
  }
  path_ = path;
}
void SharedLibrary::unload()
{
  std::lock_guard<std::mutex> hold(mutex_);
  library_ = nullptr;  // its code stays: nodes may still be there
}
bool SharedLibrary::hasSymbol(const std::string & name)
{
  std::lock_guard<std::mutex> hold(mutex_);
  return library_ && coursekit::symbol_of(library_, name);
}
void * SharedLibrary::getSymbol(const std::string & name)
{
  std::lock_guard<std::mutex> hold(mutex_);
  void * found = library_ ? coursekit::symbol_of(library_, name) : nullptr;
  return found ? found : throw RuntimeError("[SharedLibrary::getSymbol]: can't find symbol ", name);
}
#ifdef _WIN32
std::string SharedLibrary::prefix() {return "";}
std::string SharedLibrary::suffix() {return ".dll";}
#else
std::string SharedLibrary::prefix() {return "lib";}
std::string SharedLibrary::suffix() {return ".so";}
#endif
}  // namespace BT
