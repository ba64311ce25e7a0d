// Classes by their names: of a library that is loaded while the program runs, or of what the program is linked with.
#pragma once
#include <atomic>
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
  bool isLibraryLoaded() const {return uses_->loads > 0;}
  bool isLibraryLoadedByAnyClassloader() const {return isLibraryLoaded();}
  void loadLibrary()
  {
    registry::load(path_);
    ++uses_->loads;
  }
  /// How many loads are left; a library with objects stays. The code is kept in memory, so that objects outlive this.
  int unloadLibrary() {return uses_->objects > 0 ? uses_->loads.load() : uses_->unload();}

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
    Base * made = createUnmanagedInstance<Base>(name);
    return std::shared_ptr<Base>(made, counted<Base>());
  }
  template<class Base>
  std::shared_ptr<Base> createInstance(const std::string & name) {return createSharedInstance<Base>(name);}
  template<class Base>
  UniquePtr<Base> createUniqueInstance(const std::string & name)
  {
    Base * made = createUnmanagedInstance<Base>(name);
    return UniquePtr<Base>(made, counted<Base>());
  }

private:
  struct Uses
  {
    std::atomic<int> loads{0}, objects{0};
    int unload() {return loads > 0 ? --loads : 0;}
  };
  /// Deletes an object; a library that was loaded on demand is unloaded with the last.
  template<class Base>
  DeleterType<Base> counted()
  {
    ++uses_->objects;
    return [uses = uses_, on_demand = on_demand_](Base * object) {
             delete object;
             if (--uses->objects == 0 && on_demand) {
               uses->unload();
             }
           };
  }
  std::string path_;
  bool on_demand_;
  std::shared_ptr<Uses> uses_ = std::make_shared<Uses>();
};
}  // namespace class_loader
