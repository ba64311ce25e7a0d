// Plugins by their names: found by the descriptions that packages export, loaded from their libraries.
#pragma once
#include <map>
#include <set>

#include "class_loader/class_loader.hpp"
#include "pluginlib/descriptions.hpp"
#include "pluginlib/exceptions.hpp"

namespace pluginlib
{
template<class T>
using UniquePtr = class_loader::ClassLoader::UniquePtr<T>;

template<class T>
class ClassLoader
{
public:
  /// Plugins whose descriptions packages export under an attribute, or those of the given descriptions alone.
  ClassLoader(
    std::string package, std::string base_class, std::string attrib_name = "plugin",
    std::vector<std::string> plugin_xml_paths = {})
  : package_(std::move(package)), base_class_(std::move(base_class)), attribute_(std::move(attrib_name)),
    paths_(std::move(plugin_xml_paths))
  {
    refreshDeclaredClasses();
  }
  virtual ~ClassLoader() = default;

  std::shared_ptr<T> createSharedInstance(const std::string & lookup_name)
  {
    return std::shared_ptr<T>(createUnmanagedInstance(lookup_name));
  }
  UniquePtr<T> createUniqueInstance(const std::string & lookup_name)
  {
    return UniquePtr<T>(createUnmanagedInstance(lookup_name), std::default_delete<T>());
  }
  T * createUnmanagedInstance(const std::string & lookup_name)
  {
    if (!isClassLoaded(lookup_name)) {
      loadLibraryForClass(lookup_name);
    }
    try {
      return loader_of(lookup_name).template createUnmanagedInstance<T>(getClassType(lookup_name));
    } catch (const class_loader::CreateClassException & error) {
      throw CreateClassException(error.what());
    }
  }

  std::vector<std::string> getDeclaredClasses() const
  {
    std::vector<std::string> names;
    for (auto & entry : known_) {
      names.push_back(entry.first);
    }
    return names;
  }
  void refreshDeclaredClasses()
  {
    for (auto & one : read_descriptions(package_, base_class_, attribute_, paths_)) {
      known_.emplace(one.name, one);
    }
  }
  std::vector<std::string> getRegisteredLibraries() const
  {
    std::vector<std::string> paths;
    for (auto & entry : loaders_) {
      paths.push_back(entry.first);
    }
    return paths;
  }
  std::vector<std::string> getPluginXmlPaths() const
  {
    std::set<std::string> paths;
    for (auto & entry : known_) {
      paths.insert(entry.second.manifest);
    }
    return {paths.begin(), paths.end()};
  }
  bool isClassAvailable(const std::string & lookup_name) const {return known_.count(lookup_name);}
  bool isClassLoaded(const std::string & lookup_name) const
  {
    auto found = loaders_.find(text(lookup_name, &Description::library));
    return found != loaders_.end() && found->second->isLibraryLoaded();
  }
  std::string getBaseClassType() const {return base_class_;}
  std::string getClassType(const std::string & lookup_name) const {return text(lookup_name, &Description::type);}
  std::string getClassDescription(const std::string & lookup_name) const {return text(lookup_name, &Description::description);}
  std::string getClassPackage(const std::string & lookup_name) const {return text(lookup_name, &Description::package);}
  std::string getClassLibraryPath(const std::string & lookup_name) const {return text(lookup_name, &Description::library);}
  std::string getPluginManifestPath(const std::string & lookup_name) const {return text(lookup_name, &Description::manifest);}
  /// The name without its package: the part behind the last `/` or `::`.
  std::string getName(const std::string & lookup_name) const
  {
    size_t at = lookup_name.find_last_of("/:");
    return at == std::string::npos ? lookup_name : lookup_name.substr(at + 1);
  }
  void loadLibraryForClass(const std::string & lookup_name)
  {
    auto found = known_.find(lookup_name);
    if (found == known_.end()) {
      throw LibraryLoadException(unknown(lookup_name));
    }
    if (!found->second.has_library) {
      throw LibraryLoadException(
              "Could not find library corresponding to plugin " + lookup_name + ". Make sure that the library '" +
              found->second.library + "' actually exists.");
    }
    try {
      auto & loader = loaders_[found->second.library];
      loader = loader ? loader : class_loader::ClassLoader::Make(found->second.library, true);
      loader->loadLibrary();
    } catch (const class_loader::LibraryLoadException & error) {
      throw LibraryLoadException(
              "Failed to load library " + found->second.library + ". Make sure that you are calling the "
              "PLUGINLIB_EXPORT_CLASS macro in the library code, and that names are consistent between this macro and your "
              "XML. Error string: " + error.what());
    }
  }
  int unloadLibraryForClass(const std::string & lookup_name)
  {
    if (!isClassLoaded(lookup_name)) {
      throw LibraryUnloadException(unknown(lookup_name));
    }
    return loader_of(lookup_name).unloadLibrary();
  }

private:
  class_loader::ClassLoader & loader_of(const std::string & lookup_name)
  {
    return *loaders_.at(text(lookup_name, &Description::library));
  }
  std::string text(const std::string & lookup_name, std::string Description::* field) const
  {
    auto found = known_.find(lookup_name);
    return found == known_.end() ? "" : found->second.*field;
  }
  std::string unknown(const std::string & lookup_name) const
  {
    std::string declared;
    for (auto & entry : known_) {
      declared += " " + entry.first;
    }
    return "According to the loaded plugin descriptions the class " + lookup_name + " with base class type " + base_class_ +
           " does not exist. Declared types are " + declared;
  }
  std::string package_, base_class_, attribute_;
  std::vector<std::string> paths_;
  std::map<std::string, Description> known_;
  std::map<std::string, std::shared_ptr<class_loader::ClassLoader>> loaders_;
};
}  // namespace pluginlib
