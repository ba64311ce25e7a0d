// A node of a tree.
#pragma once
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <unordered_map>

#include "behaviortree_cpp_v3/basic_types.h"
#include "behaviortree_cpp_v3/blackboard.h"
#include "behaviortree_cpp_v3/exceptions.h"
#include "behaviortree_cpp_v3/utils/signal.h"
#include "behaviortree_cpp_v3/utils/strcat.hpp"
#include "behaviortree_cpp_v3/utils/wakeup_signal.hpp"

namespace BT
{
/// What a factory knows of a kind of nodes.
struct TreeNodeManifest
{
  NodeType type;
  std::string registration_ID;
  PortsList ports;
  std::string description;
};
using PortsRemapping = std::unordered_map<std::string, std::string>;

struct NodeConfiguration
{
  NodeConfiguration() {}

  Blackboard::Ptr blackboard;
  PortsRemapping input_ports;
  PortsRemapping output_ports;
};

class TreeNode
{
public:
  using Ptr = std::shared_ptr<TreeNode>;
  using StatusChangeSignal = Signal<TimePoint, const TreeNode &, NodeStatus, NodeStatus>;
  using StatusChangeSubscriber = StatusChangeSignal::Subscriber;
  using StatusChangeCallback = StatusChangeSignal::CallableFunction;
  using PreTickOverrideCallback = std::function<Optional<NodeStatus>(TreeNode &, NodeStatus)>;
  using PostTickOverrideCallback = std::function<Optional<NodeStatus>(TreeNode &, NodeStatus, NodeStatus)>;

  TreeNode(std::string name, NodeConfiguration config);
  virtual ~TreeNode() = default;

  /// tick() between what overrides it, and the status that follows.
  virtual NodeStatus executeTick();
  virtual void halt() = 0;
  virtual NodeType type() const = 0;

  bool isHalted() const {return status() == NodeStatus::IDLE;}
  NodeStatus status() const;
  const std::string & name() const {return name_;}
  uint16_t UID() const {return uid_;}
  const std::string & registrationName() const {return registration_ID_;}
  const NodeConfiguration & config() const {return config_;}
  /// Wait until another thread sets a status other than IDLE.
  NodeStatus waitValidStatus();
  /// Called as long as what it returns is kept.
  StatusChangeSubscriber subscribeToStatusChange(StatusChangeCallback callback);
  /// What it returns, if anything, stands for a tick.
  void setPreTickOverrideFunction(PreTickOverrideCallback callback);
  /// What it returns, if anything, replaces the result of a tick.
  void setPostTickOverrideFunction(PostTickOverrideCallback callback);

  template<class T>
  Result getInput(const std::string & key, T & destination) const;
  template<class T>
  Optional<T> getInput(const std::string & key) const
  {
    T value{};
    Result read = getInput(key, value);
    return read ? Optional<T>(value) : Optional<T>(nonstd::make_unexpected(read.error()));
  }
  template<class T>
  Result setOutput(const std::string & key, const T & value);
  /// As it stands in the tree's file.
  StringView getRawPortValue(const std::string & key) const;

  /// Whether it is {key} or ${key}.
  static bool isBlackboardPointer(StringView text);
  static StringView stripBlackboardPointer(StringView text);
  static Optional<StringView> getRemappedKey(StringView port_name, StringView remapping_value);

  /// Have the tree's sleep end.
  void emitStateChanged();

protected:
  friend class BehaviorTreeFactory;
  friend class DecoratorNode;
  friend class ControlNode;
  friend class Tree;
  friend struct ServedNode;  // of a tree that another process ticks

  virtual NodeStatus tick() = 0;
  void setStatus(NodeStatus new_status);
  /// IDLE, which nobody is told.
  void resetStatus();
  void setRegistrationID(StringView ID) {registration_ID_ = ID;}
  void setWakeUpInstance(std::shared_ptr<WakeUpSignal> signal) {wake_up_ = signal;}
  void modifyPortsRemapping(const PortsRemapping & remapping);

private:
  /// The text of a port, or the key that it is remapped to: what there is of the two.
  struct Source
  {
    Optional<StringView> key;
    StringView text;
  };
  Optional<Source> source(const std::string & port) const;
  Optional<std::string> target(const std::string & port) const;

  const std::string name_;
  NodeStatus status_ = NodeStatus::IDLE;
  std::condition_variable changed_;
  mutable std::mutex mutex_;
  StatusChangeSignal status_changed_;
  const uint16_t uid_;
  NodeConfiguration config_;
  std::string registration_ID_;
  PreTickOverrideCallback before_;
  PostTickOverrideCallback after_;
  std::shared_ptr<WakeUpSignal> wake_up_;
};

template<class T>
Result TreeNode::getInput(const std::string & key, T & destination) const
{
  const Optional<Source> from = source(key);
  if (!from) {
    return nonstd::make_unexpected(from.error());
  }
  try {
    if (!from->key) {
      destination = convertFromString<T>(from->text);
      return {};
    }
    std::unique_lock<std::mutex> hold(config_.blackboard->entryMutex());
    const Any * value = config_.blackboard->getAny(std::string(*from->key));
    if (!value || value->empty()) {
      return nonstd::make_unexpected(
        StrCat("getInput() failed because it was unable to find the key [", key, "] remapped to [", *from->key, "]"));
    }
    if (!std::is_same_v<T, std::string> && value->type() == typeid(std::string)) {
      destination = convertFromString<T>(value->cast<std::string>());
    } else {
      destination = value->cast<T>();
    }
    return {};
  } catch (const std::exception & error) {
    return nonstd::make_unexpected(error.what());
  }
}

template<class T>
Result TreeNode::setOutput(const std::string & key, const T & value)
{
  const Optional<std::string> to = target(key);
  if (!to) {
    return nonstd::make_unexpected(to.error());
  }
  config_.blackboard->set(*to, value);
  return {};
}

/// Give each port the blackboard's key of its own name.
template<class T>
void assignDefaultRemapping(NodeConfiguration & config)
{
  for (const auto & port : getProvidedPorts<T>()) {
    if (port.second.direction() != PortDirection::OUTPUT) {
      config.input_ports[port.first] = "=";
    }
    if (port.second.direction() != PortDirection::INPUT) {
      config.output_ports[port.first] = "=";
    }
  }
}
}  // namespace BT
