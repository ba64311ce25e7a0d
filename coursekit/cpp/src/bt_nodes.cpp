// What all nodes of trees have in common.
#include <atomic>
#include <utility>

#include "behaviortree_cpp_v3/control_node.h"
#include "behaviortree_cpp_v3/decorator_node.h"

namespace BT
{
namespace
{
uint16_t next_uid()
{
  static std::atomic<uint16_t> last{0};
  return ++last;
}
}  // namespace

bool WakeUpSignal::waitFor(std::chrono::system_clock::duration time)
{
  std::unique_lock<std::mutex> hold(mutex_);
  const bool woken = changed_.wait_for(hold, time, [this] {return ready_;});
  ready_ = false;
  return woken;
}
void WakeUpSignal::emitSignal()
{
  {
    std::lock_guard<std::mutex> hold(mutex_);
    ready_ = true;
  }
  changed_.notify_all();
}

TreeNode::TreeNode(std::string name, NodeConfiguration config)
: name_(std::move(name)), uid_(next_uid()), config_(std::move(config)) {}

NodeStatus TreeNode::executeTick()
{
  const NodeStatus before = status();
  NodeStatus now = before;
  Optional<NodeStatus> instead = nonstd::make_unexpected("");
  if (before_) {
    instead = before_(*this, before);
  }
  now = instead ? *instead : tick();
  if (after_) {
    if (Optional<NodeStatus> other = after_(*this, before, now)) {
      now = *other;
    }
  }
  setStatus(now);
  return now;
}
void TreeNode::setStatus(NodeStatus new_status)
{
  NodeStatus before;
  {
    std::lock_guard<std::mutex> hold(mutex_);
    before = std::exchange(status_, new_status);
  }
  if (before != new_status) {
    changed_.notify_all();
    status_changed_.notify(std::chrono::high_resolution_clock::now(), *this, before, new_status);
  }
}
void TreeNode::resetStatus()
{
  std::lock_guard<std::mutex> hold(mutex_);
  status_ = NodeStatus::IDLE;
}
NodeStatus TreeNode::status() const
{
  std::lock_guard<std::mutex> hold(mutex_);
  return status_;
}
NodeStatus TreeNode::waitValidStatus()
{
  std::unique_lock<std::mutex> hold(mutex_);
  changed_.wait(hold, [this] {return status_ != NodeStatus::IDLE;});
  return status_;
}
TreeNode::StatusChangeSubscriber TreeNode::subscribeToStatusChange(StatusChangeCallback callback)
{
  return status_changed_.subscribe(std::move(callback));
}
void TreeNode::setPreTickOverrideFunction(PreTickOverrideCallback callback) {before_ = std::move(callback);}
void TreeNode::setPostTickOverrideFunction(PostTickOverrideCallback callback) {after_ = std::move(callback);}

StringView TreeNode::getRawPortValue(const std::string & key) const
{
  auto found = config_.input_ports.find(key);
  if (found == config_.input_ports.end()) {
    throw std::logic_error(
            StrCat("getInput() failed because NodeConfiguration::input_ports does not contain the key: [", key, "]"));
  }
  return found->second;
}
bool TreeNode::isBlackboardPointer(StringView text) {return !stripBlackboardPointer(text).empty();}

StringView TreeNode::stripBlackboardPointer(StringView text)
{
  if (!text.empty() && text.front() == '$') {
    text.remove_prefix(1);
  }
  const bool pointer = text.size() >= 3 && text.front() == '{' && text.back() == '}';
  return pointer ? text.substr(1, text.size() - 2) : StringView();
}
Optional<StringView> TreeNode::getRemappedKey(StringView port_name, StringView remapping_value)
{
  if (remapping_value == "=") {
    return port_name;
  }
  if (isBlackboardPointer(remapping_value)) {
    return stripBlackboardPointer(remapping_value);
  }
  return nonstd::make_unexpected("Not a blackboard pointer");
}
Optional<TreeNode::Source> TreeNode::source(const std::string & port) const
{
  auto found = config_.input_ports.find(port);
  if (found == config_.input_ports.end()) {
    return nonstd::make_unexpected(
      StrCat("getInput() failed because NodeConfiguration::input_ports does not contain the key: [", port, "]"));
  }
  Source from{getRemappedKey(found->first, found->second), found->second};
  if (from.key && !config_.blackboard) {
    return nonstd::make_unexpected("getInput() trying to access a Blackboard(BB) entry, but BB is invalid");
  }
  return from;
}
Optional<std::string> TreeNode::target(const std::string & port) const
{
  if (!config_.blackboard) {
    return nonstd::make_unexpected("setOutput() failed: trying to access a Blackboard(BB) entry, but BB is invalid");
  }
  auto found = config_.output_ports.find(port);
  if (found == config_.output_ports.end()) {
    return nonstd::make_unexpected(
      StrCat("setOutput() failed: NodeConfiguration::output_ports does not contain the key: [", port, "]"));
  }
  const Optional<StringView> key = getRemappedKey(port, found->second);
  return key ? std::string(*key) : found->second;
}
void TreeNode::emitStateChanged()
{
  if (wake_up_) {
    wake_up_->emitSignal();
  }
}
void TreeNode::modifyPortsRemapping(const PortsRemapping & remapping)
{
  for (auto & one : remapping) {
    for (PortsRemapping * ports : {&config_.input_ports, &config_.output_ports}) {
      auto found = ports->find(one.first);
      if (found != ports->end()) {
        found->second = one.second;
      }
    }
  }
}

void ControlNode::halt()
{
  haltChildren();
  resetStatus();
}
void ControlNode::haltChildren()
{
  for (size_t index = 0; index < children_nodes_.size(); ++index) {
    haltChild(index);
  }
}
void ControlNode::haltChild(size_t index)
{
  TreeNode * child = children_nodes_.at(index);
  if (child->status() == NodeStatus::RUNNING) {
    child->halt();
  }
  child->resetStatus();
}

void DecoratorNode::setChild(TreeNode * child)
{
  if (child_node_) {
    throw BehaviorTreeException("Decorator [", name(), "] has already a child assigned");
  }
  child_node_ = child;
}
void DecoratorNode::halt()
{
  haltChild();
  resetStatus();
}
void DecoratorNode::haltChild()
{
  if (!child_node_) {
    return;
  }
  if (child_node_->status() == NodeStatus::RUNNING) {
    child_node_->halt();
  }
  child_node_->resetStatus();
}
NodeStatus DecoratorNode::executeTick()
{
  const NodeStatus status = TreeNode::executeTick();
  if (child_node_ && StatusCompleted(child_node_->status())) {
    child_node_->resetStatus();
  }
  return status;
}
}  // namespace BT
