// The trees of XML documents by their names, with those of the documents that they include.
#pragma once
#include <filesystem>
#include <list>
#include <map>
#include <string>

#include "behaviortree_cpp_v3/bt_factory.h"
#include "bt_description.hpp"

namespace BT::description
{
class Documents
{
public:
  /// The factory tells the types of nodes.
  explicit Documents(const BehaviorTreeFactory & factory)
  : factory_(factory) {}

  /// Includes are looked for beside the file, those of a text in the current folder.
  void load_file(const std::filesystem::path & file, bool add_includes);
  void load(Element document, bool add_includes);

  /// The name of the tree that is executed where none is asked for. Throws RuntimeError where that is not clear.
  std::string main_tree() const;
  /// A tree's one node at the top. Throws std::runtime_error where there is no such tree.
  const Element & root_of(const std::string & id) const;
  const std::map<std::string, const Element *> & trees() const {return trees_;}

private:
  void include(const Element & element);

  const BehaviorTreeFactory & factory_;
  std::list<Element> documents_;  // the trees are parts of them
  std::map<std::string, const Element *> trees_;
  std::filesystem::path folder_ = std::filesystem::current_path();
  int unnamed_ = 0;
};
}  // namespace BT::description
