// Documents of trees, and what they include.
#include "bt_documents.hpp"

#include <iostream>
#include <utility>

#include "ament_index_cpp/get_package_share_directory.hpp"

namespace BT::description
{
void Documents::load_file(const std::filesystem::path & file, bool add_includes)
{
  folder_ = std::filesystem::absolute(file).parent_path();
  load(read_file(file), add_includes);
}
void Documents::load(Element document, bool add_includes)
{
  documents_.push_back(std::move(document));
  const Element & root = documents_.back();
  for (const Element & child : root.children) {
    if (add_includes && child.name == "include") {
      include(child);
    }
  }
  Types types;
  for (auto & manifest : factory_.manifests()) {
    types.emplace(manifest.first, manifest.second.type);
  }
  verify(root, types);
  for (const Element & child : root.children) {
    if (child.name == "BehaviorTree") {
      const std::string * id = child.attribute("ID");
      trees_.emplace(id ? *id : "BehaviorTree_" + std::to_string(unnamed_++), &child);
    }
  }
}
void Documents::include(const Element & element)
{
  const std::string * path = element.attribute("path"), * package = element.attribute("ros_pkg");
  if (!path) {
    fail(element, "The node <include> must have the attribute [path]");
  }
  std::filesystem::path file = *path;
  if (package && file.is_absolute()) {
    std::cout << "WARNING: <include path=\"...\"> contains an absolute path.\nAttribute [ros_pkg] will be ignored." <<
      std::endl;
  } else if (package) {
    file = std::filesystem::path(ament_index_cpp::get_package_share_directory(*package)) / file;
  }
  file = folder_ / file;
  const std::filesystem::path before = std::exchange(folder_, file.parent_path());
  load(read_file(file), true);
  folder_ = before;
}
std::string Documents::main_tree() const
{
  const std::string * named = documents_.empty() ? nullptr : documents_.front().attribute("main_tree_to_execute");
  if (!named && trees_.size() != 1) {
    throw RuntimeError("[main_tree_to_execute] was not specified correctly");
  }
  return named ? *named : trees_.begin()->first;
}
const Element & Documents::root_of(const std::string & id) const
{
  auto found = trees_.find(id);
  if (found == trees_.end()) {
    throw std::runtime_error("Can't find a tree with name: " + id);
  }
  return found->second->children.front();
}
}  // namespace BT::description
