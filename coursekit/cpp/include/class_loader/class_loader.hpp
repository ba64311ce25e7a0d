// Classes by their names: of a library that is loaded while the program runs, or of what the program is linked with.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "class_loader/exceptions.hpp"
#include "class_loader/register_macro.hpp"
#include "class_loader/registry.hpp"
#include "rcpputils/shared_library.hpp"

namespace class_loader
{
/// A library's name with what this system puts around it.
inline std::string systemLibraryFormat(const std::string & library_name)
{
  return rcpputils::get_platform_library_name(library_name);
}

class ClassLoader : public std::enable_shared_from_this<ClassLoader>
{
public:
  template<class Base>
  using DeleterType = std::function<void (Base *)>;
  template<class Base>
  using UniquePtr = std::unique_ptr<Base, DeleterType<Base>>;

  /// All that is linked in is under the path "". With `on_demand` a library is loaded when one of its classes is made.
  explicit ClassLoader(const std::string & library_path, bool on_demand = false)
  : path_(library_path), on_demand_(on_demand)
  {
    if (!on_demand) {
      loadLibrary();
    }
  }
  virtual ~ClassLoader() = default;
  static std::shared_ptr<ClassLoader> Make(const std::string & library_path, bool on_demand = false)
  {
    return std::make_shared<ClassLoader>(library_path, on_demand);
  }
  const std::string & getLibraryPath() const {return path_;}
  bool isOnDemandLoadUnloadEnabled() const {return on_demand_;}
  bool isLibraryLoaded() const {return loads_ > 0;}
  bool isLibraryLoadedByAnyClassloader() const {return isLibraryLoaded();}
  void loadLibrary()
  {
    registry::load(path_);
    ++loads_;
  }
  /// How many loads are left. The code stays in memory, so that objects that were made outlive this.
  int unloadLibrary() {return loads_ > 0 ? --loads_ : 0;}

  template<class Base>
  std::vector<std::string> getAvailableClasses() const {return registry::names(registry::key<Base>(), path_);}
  template<class Base>
  bool isClassAvailable(const std::string & name) const
  {
    return static_cast<bool>(registry::maker(registry::key<Base>(), name, path_));
  }
  template<class Base>
  Base * createUnmanagedInstance(const std::string & name)
  {
    if (!isLibraryLoaded()) {
      loadLibrary();
    }
    registry::Maker make = registry::maker(registry::key<Base>(), name, path_);
    if (!make) {
      throw CreateClassException("Could not create instance of type " + name);
    }
    return static_cast<Base *>(make());
  }
  template<class Base>
  std::shared_ptr<Base> createSharedInstance(const std::string & name)
  {
    return std::shared_ptr<Base>(createUnmanagedInstance<Base>(name));
  }
  template<class Base>
  std::shared_ptr<Base> createInstance(const std::string & name) {return createSharedInstance<Base>(name);}
  template<class Base>
  UniquePtr<Base> createUniqueInstance(const std::string & name)
  {
    return UniquePtr<Base>(createUnmanagedInstance<Base>(name), std::default_delete<Base>());
  }

private:
  std::string path_;
  bool on_demand_;
  int loads_ = 0;
};
}  // namespace class_loader
