// Writes a text to the blackboard.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/action_node.h"

namespace BT
{
class SetBlackboard : public SyncActionNode
{
public:
  SetBlackboard(const std::string & name, const NodeConfiguration & config)
  : SyncActionNode(name, config) {setRegistrationID("SetBlackboard");}
  static PortsList providedPorts();

private:
  NodeStatus tick() override;
};
}  // namespace BT
