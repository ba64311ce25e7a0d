// Trees as a whole: ticked, halted, visited, printed and watched.
#include <algorithm>
#include <cstdio>

#include "behaviortree_cpp_v3/loggers/bt_cout_logger.h"

namespace BT
{
namespace
{
template<class Node, class Visitor>
void visit(Node * node, const Visitor & visitor)
{
  if (!node) {
    throw LogicError("One of the children of a DecoratorNode or ControlNode is nullptr");
  }
  visitor(node);
  if (auto control = dynamic_cast<const ControlNode *>(node)) {
    for (Node * child : control->children()) {
      visit(child, visitor);
    }
  } else if (auto decorator = dynamic_cast<const DecoratorNode *>(node)) {
    visit(const_cast<Node *>(static_cast<const TreeNode *>(decorator->child())), visitor);
  }
}
void print(const TreeNode * node, size_t depth, std::ostream & stream)
{
  stream << std::string(3 * depth, ' ') << (node ? node->name() : "!nullptr!") << std::endl;
  if (auto control = dynamic_cast<const ControlNode *>(node)) {
    for (const TreeNode * child : control->children()) {
      print(child, depth + 1, stream);
    }
  } else if (auto decorator = dynamic_cast<const DecoratorNode *>(node)) {
    print(decorator->child(), depth + 1, stream);
  }
}
}  // namespace

void applyRecursiveVisitor(const TreeNode * root_node, const std::function<void(const TreeNode *)> & visitor)
{
  visit(root_node, visitor);
}
void applyRecursiveVisitor(TreeNode * root_node, const std::function<void(TreeNode *)> & visitor)
{
  visit(root_node, visitor);
}
void printTreeRecursively(const TreeNode * root_node, std::ostream & stream)
{
  const char * const line = "----------------";
  stream << line << std::endl;
  print(root_node, 0, stream);
  stream << line << std::endl;
}
void buildSerializedStatusSnapshot(TreeNode * root_node, SerializedTreeStatus & serialized_buffer)
{
  serialized_buffer.clear();
  visit(root_node, [&serialized_buffer](const TreeNode * node) {
      serialized_buffer.emplace_back(node->UID(), static_cast<uint8_t>(node->status()));
    });
}

Tree::~Tree() {haltTree();}

void Tree::initialize()
{
  wake_up_ = std::make_shared<WakeUpSignal>();
  for (auto & node : nodes) {
    node->setWakeUpInstance(wake_up_);
  }
}
NodeStatus Tree::tickRoot()
{
  if (!wake_up_) {
    initialize();
  }
  if (!rootNode()) {
    throw RuntimeError("Empty Tree");
  }
  const NodeStatus status = rootNode()->executeTick();
  if (StatusCompleted(status)) {
    rootNode()->setStatus(NodeStatus::IDLE);
  }
  return status;
}
NodeStatus Tree::tickRootWhileRunning(std::chrono::milliseconds sleep_time)
{
  NodeStatus status = tickRoot();
  while (status == NodeStatus::RUNNING) {
    sleep(sleep_time);
    status = tickRoot();
  }
  return status;
}
void Tree::haltTree()
{
  if (!rootNode()) {
    return;
  }
  rootNode()->halt();
  rootNode()->setStatus(NodeStatus::IDLE);
  visit(rootNode(), [](TreeNode * node) {  // those that a node of the program's own has forgotten
      node->halt();
      node->setStatus(NodeStatus::IDLE);
    });
}
void Tree::sleep(std::chrono::system_clock::duration timeout)
{
  if (!wake_up_) {
    initialize();
  }
  wake_up_->waitFor(timeout);
}

StatusChangeLogger::StatusChangeLogger(TreeNode * root_node)
{
  visit(root_node, [this](TreeNode * node) {
      subscribers_.push_back(
        node->subscribeToStatusChange(
          [this](TimePoint when, const TreeNode & one, NodeStatus before, NodeStatus status) {
            hear(when, one, before, status);
          }));
    });
}
void StatusChangeLogger::hear(TimePoint when, const TreeNode & node, NodeStatus before, NodeStatus status)
{
  if (enabled_ && (status != NodeStatus::IDLE || show_transition_to_idle_)) {
    callback(type_ == TimestampType::ABSOLUTE ? when.time_since_epoch() : when - begin_, node, before, status);
  }
}

std::atomic<bool> StdCoutLogger::taken_{false};

StdCoutLogger::StdCoutLogger(const Tree & tree)
: StatusChangeLogger(tree.rootNode())
{
  if (taken_.exchange(true)) {
    throw LogicError("Only one instance of StdCoutLogger shall be created");
  }
}
StdCoutLogger::~StdCoutLogger() {taken_ = false;}

void StdCoutLogger::callback(Duration timestamp, const TreeNode & node, NodeStatus prev_status, NodeStatus status)
{
  std::printf(
    "[%.3f]: %-25s %s -> %s", std::chrono::duration<double>(timestamp).count(), node.name().c_str(),
    toStr(prev_status, true).c_str(), toStr(status, true).c_str());
  std::cout << std::endl;
}
void StdCoutLogger::flush() {std::cout << std::flush;}
}  // namespace BT
