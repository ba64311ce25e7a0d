// Success for failure, and failure for success.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"

namespace BT
{
class InverterNode : public DecoratorNode
{
public:
  explicit InverterNode(const std::string & name)
  : DecoratorNode(name, {}) {setRegistrationID("Inverter");}

private:
  NodeStatus tick() override;
};
}  // namespace BT
