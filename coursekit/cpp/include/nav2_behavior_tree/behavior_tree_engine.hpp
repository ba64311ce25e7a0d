// Loads the libraries of a tree's nodes, and ticks the tree until it ends or is canceled.
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "behaviortree_cpp_v3/behavior_tree.h"
#include "behaviortree_cpp_v3/bt_factory.h"
#include "behaviortree_cpp_v3/xml_parsing.h"

namespace nav2_behavior_tree
{
enum class BtStatus {SUCCEEDED, FAILED, CANCELED};

class BehaviorTreeEngine
{
public:
  /// The names of libraries, without lib and .so. Throws BT::RuntimeError where one is missing.
  explicit BehaviorTreeEngine(const std::vector<std::string> & plugin_libraries);
  virtual ~BehaviorTreeEngine() = default;

  BtStatus run(
    BT::Tree * tree, std::function<void()> onLoop, std::function<bool()> cancelRequested,
    std::chrono::milliseconds loopTimeout = std::chrono::milliseconds(10));
  BT::Tree createTreeFromText(const std::string & xml_string, BT::Blackboard::Ptr blackboard);
  BT::Tree createTreeFromFile(const std::string & file_path, BT::Blackboard::Ptr blackboard);
  /// Halt the nodes that run.
  void haltAllActions(BT::TreeNode * root_node);

protected:
  BT::BehaviorTreeFactory factory_;
};
}  // namespace nav2_behavior_tree
