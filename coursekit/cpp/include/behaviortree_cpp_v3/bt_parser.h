// What makes trees of texts and files.
#pragma once
#include <string>
#include <vector>

#include "behaviortree_cpp_v3/tree.h"

namespace BT
{
class Parser
{
public:
  Parser() = default;
  Parser(const Parser &) = delete;
  Parser & operator=(const Parser &) = delete;
  virtual ~Parser() = default;

  virtual void loadFromFile(const std::string & filename, bool add_includes = true) = 0;
  virtual void loadFromText(const std::string & xml_text, bool add_includes = true) = 0;
  virtual std::vector<std::string> registeredBehaviorTrees() const = 0;
  virtual Tree instantiateTree(const Blackboard::Ptr & root_blackboard, std::string tree_name = {}) = 0;
  virtual void clearInternalState() = 0;
};
}  // namespace BT
