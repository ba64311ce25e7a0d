// Ticks trees as nav2 does.
#include <utility>

#include "behaviortree_cpp_v3/utils/shared_library.h"
#include "nav2_behavior_tree/behavior_tree_engine.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_behavior_tree
{
BehaviorTreeEngine::BehaviorTreeEngine(const std::vector<std::string> & plugin_libraries)
{
  for (auto & name : plugin_libraries) {
    factory_.registerFromPlugin(BT::SharedLibrary::getOSName(name));
  }
}
BtStatus BehaviorTreeEngine::run(
  BT::Tree * tree, std::function<void()> onLoop, std::function<bool()> cancelRequested,
  std::chrono::milliseconds loopTimeout)
{
  rclcpp::WallRate rate(loopTimeout);
  BT::NodeStatus status = BT::NodeStatus::RUNNING;
  try {
    while (rclcpp::ok() && status == BT::NodeStatus::RUNNING) {
      if (cancelRequested()) {
        tree->rootNode()->halt();
        return BtStatus::CANCELED;
      }
      status = tree->tickRoot();
      onLoop();
      rate.sleep();
    }
  } catch (const std::exception & error) {
    RCLCPP_ERROR(
      rclcpp::get_logger("BehaviorTreeEngine"), "Behavior tree threw exception: %s. Exiting with failure.", error.what());
    return BtStatus::FAILED;
  }
  return status == BT::NodeStatus::SUCCESS ? BtStatus::SUCCEEDED : BtStatus::FAILED;
}
BT::Tree BehaviorTreeEngine::createTreeFromText(const std::string & xml_string, BT::Blackboard::Ptr blackboard)
{
  return factory_.createTreeFromText(xml_string, std::move(blackboard));
}
BT::Tree BehaviorTreeEngine::createTreeFromFile(const std::string & file_path, BT::Blackboard::Ptr blackboard)
{
  return factory_.createTreeFromFile(file_path, std::move(blackboard));
}
void BehaviorTreeEngine::haltAllActions(BT::TreeNode * root_node)
{
  if (root_node) {
    root_node->halt();
    BT::applyRecursiveVisitor(root_node, [](BT::TreeNode * node) {
        if (node->type() == BT::NodeType::ACTION && node->status() == BT::NodeStatus::RUNNING) {
          node->halt();
        }
      });
  }
}
}  // namespace nav2_behavior_tree
