// Another tree in the place of a node: SubTree has its ports named, SubTreePlus may have them all by the same name.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"

namespace BT
{
class SubtreeNode : public DecoratorNode
{
public:
  explicit SubtreeNode(const std::string & name)
  : DecoratorNode(name, {}) {setRegistrationID("SubTree");}
  NodeType type() const final {return NodeType::SUBTREE;}

private:
  NodeStatus tick() override;
};

class SubtreePlusNode : public DecoratorNode
{
public:
  explicit SubtreePlusNode(const std::string & name)
  : DecoratorNode(name, {}) {setRegistrationID("SubTreePlus");}
  NodeType type() const final {return NodeType::SUBTREE;}

private:
  NodeStatus tick() override;
};
}  // namespace BT
