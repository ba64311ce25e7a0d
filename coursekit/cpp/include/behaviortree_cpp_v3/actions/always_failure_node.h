// An action that does nothing: FAILURE.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/action_node.h"

namespace BT
{
class AlwaysFailureNode : public SyncActionNode
{
public:
  explicit AlwaysFailureNode(const std::string & name)
  : SyncActionNode(name, {}) {setRegistrationID("AlwaysFailure");}

private:
  NodeStatus tick() override {return NodeStatus::FAILURE;}
};
}  // namespace BT
