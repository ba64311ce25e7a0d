// One loader for classes of several libraries.
#pragma once
#include <map>

#include "class_loader/class_loader.hpp"

namespace class_loader
{
class MultiLibraryClassLoader
{
public:
  explicit MultiLibraryClassLoader(bool on_demand)
  : on_demand_(on_demand) {}
  void loadLibrary(const std::string & path)
  {
    if (!loaders_.count(path)) {
      loaders_[path] = ClassLoader::Make(path, on_demand_);
    }
  }
  int unloadLibrary(const std::string & path) {return static_cast<int>(loaders_.count(path) - loaders_.erase(path));}
  bool isLibraryAvailable(const std::string & path) const {return loaders_.count(path);}
  std::vector<std::string> getRegisteredLibraries() const
  {
    std::vector<std::string> paths;
    for (auto & entry : loaders_) {
      paths.push_back(entry.first);
    }
    return paths;
  }
  template<class Base>
  std::vector<std::string> getAvailableClasses() const
  {
    std::vector<std::string> names;
    for (auto & entry : loaders_) {
      auto more = entry.second->template getAvailableClasses<Base>();
      names.insert(names.end(), more.begin(), more.end());
    }
    return names;
  }
  template<class Base>
  std::vector<std::string> getAvailableClassesForLibrary(const std::string & path) const
  {
    return loader_for(path).template getAvailableClasses<Base>();
  }
  template<class Base>
  bool isClassAvailable(const std::string & name) const {return loader_of<Base>(name) != nullptr;}
  template<class Base>
  std::shared_ptr<Base> createSharedInstance(const std::string & name) {return found<Base>(name).template createSharedInstance<Base>(name);}
  template<class Base>
  std::shared_ptr<Base> createInstance(const std::string & name) {return createSharedInstance<Base>(name);}
  /// The class of one of the libraries.
  template<class Base>
  std::shared_ptr<Base> createSharedInstance(const std::string & name, const std::string & library_path)
  {
    return loader_for(library_path).template createSharedInstance<Base>(name);
  }
  template<class Base>
  std::shared_ptr<Base> createInstance(const std::string & name, const std::string & library_path)
  {
    return createSharedInstance<Base>(name, library_path);
  }
  template<class Base>
  ClassLoader::UniquePtr<Base> createUniqueInstance(const std::string & name, const std::string & library_path)
  {
    return loader_for(library_path).template createUniqueInstance<Base>(name);
  }
  template<class Base>
  ClassLoader::UniquePtr<Base> createUniqueInstance(const std::string & name)
  {
    return found<Base>(name).template createUniqueInstance<Base>(name);
  }
  template<class Base>
  Base * createUnmanagedInstance(const std::string & name) {return found<Base>(name).template createUnmanagedInstance<Base>(name);}

private:
  ClassLoader & loader_for(const std::string & path) const
  {
    auto found = loaders_.find(path);
    if (found == loaders_.end()) {
      throw NoClassLoaderExistsException(
              "There is no ClassLoader in MultiLibraryClassLoader bound to library " + path +
              " Ensure you called MultiLibraryClassLoader::loadLibrary()");
    }
    return *found->second;
  }
  template<class Base>
  ClassLoader * loader_of(const std::string & name) const
  {
    for (auto & entry : loaders_) {
      if (!entry.second->isLibraryLoaded()) {
        entry.second->loadLibrary();
      }
      if (entry.second->template isClassAvailable<Base>(name)) {
        return entry.second.get();
      }
    }
    return nullptr;
  }
  template<class Base>
  ClassLoader & found(const std::string & name) const
  {
    ClassLoader * loader = loader_of<Base>(name);
    if (!loader) {
      throw CreateClassException("MultiLibraryClassLoader: Could not create class of type " + name);
    }
    return *loader;
  }
  bool on_demand_;
  std::map<std::string, std::shared_ptr<ClassLoader>> loaders_;
};
}  // namespace class_loader
