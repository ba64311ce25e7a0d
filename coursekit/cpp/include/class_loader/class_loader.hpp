// Classes by their names: those of the libraries that a program is linked with. Libraries are static here.
#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rclcpp_components/node_factory.hpp"

namespace class_loader
{
class ClassLoaderException : public std::runtime_error {using std::runtime_error::runtime_error;};
class LibraryLoadException : public ClassLoaderException {using ClassLoaderException::ClassLoaderException;};
class CreateClassException : public ClassLoaderException {using ClassLoaderException::ClassLoaderException;};

class ClassLoader : public std::enable_shared_from_this<ClassLoader>
{
public:
  /// All that is linked in is under the path "", as upstream; no other library can be loaded while a program runs.
  explicit ClassLoader(const std::string & library_path, bool = false)
  : path_(library_path)
  {
    if (!path_.empty()) {
      throw LibraryLoadException(
              "Could not load library " + path_ + ": coursekit's libraries are static and each component is a program. "
              "Start it with `ros2 run`, or in a component container");
    }
  }
  static std::shared_ptr<ClassLoader> Make(const std::string & library_path, bool on_demand = false)
  {
    return std::make_shared<ClassLoader>(library_path, on_demand);
  }
  const std::string & getLibraryPath() const {return path_;}
  bool isLibraryLoaded() const {return true;}
  void loadLibrary() {}
  int unloadLibrary() {return 0;}
  template<class Base>
  std::vector<std::string> getAvailableClasses() const {return rclcpp_components::factory_names();}
  template<class Base>
  bool isClassAvailable(const std::string & name) const {return rclcpp_components::factory_called(name) != nullptr;}
  template<class Base>
  std::shared_ptr<Base> createInstance(const std::string & name)
  {
    static_assert(std::is_same_v<Base, rclcpp_components::NodeFactory>, "only components can be made by their names here");
    auto found = rclcpp_components::factory_called(name);
    if (!found) {
      throw CreateClassException("Could not create instance of type " + name);
    }
    return found;
  }

private:
  std::string path_;
};
}  // namespace class_loader
