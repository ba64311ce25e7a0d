// A tree that can be ticked; its nodes go with it.
#pragma once
#include <chrono>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "behaviortree_cpp_v3/behavior_tree.h"

namespace BT
{
class Tree
{
public:
  std::vector<TreeNode::Ptr> nodes;
  std::vector<Blackboard::Ptr> blackboard_stack;
  std::unordered_map<std::string, TreeNodeManifest> manifests;

  Tree() = default;
  Tree(Tree && other) = default;
  Tree & operator=(Tree && other) = default;
  ~Tree();

  void initialize();
  NodeStatus tickRoot();
  /// Tick until it has ended, and sleep meanwhile.
  NodeStatus tickRootWhileRunning(std::chrono::milliseconds sleep_time = std::chrono::milliseconds(10));
  void haltTree();
  TreeNode * rootNode() const {return nodes.empty() ? nullptr : nodes.front().get();}
  Blackboard::Ptr rootBlackboard() {return blackboard_stack.empty() ? nullptr : blackboard_stack.front();}
  /// Until the time is over, or a node says that its state has changed.
  void sleep(std::chrono::system_clock::duration timeout);

private:
  std::shared_ptr<WakeUpSignal> wake_up_;
};
}  // namespace BT
