// Actions: at once, over several ticks, or in a thread of their own.
#pragma once
#include <atomic>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "behaviortree_cpp_v3/leaf_node.h"

namespace BT
{
class ActionNodeBase : public LeafNode
{
public:
  ActionNodeBase(const std::string & name, const NodeConfiguration & config)
  : LeafNode(name, config) {}
  NodeType type() const final {return NodeType::ACTION;}
};

/// Done within a tick: RUNNING is an error.
class SyncActionNode : public ActionNodeBase
{
public:
  SyncActionNode(const std::string & name, const NodeConfiguration & config)
  : ActionNodeBase(name, config) {}
  NodeStatus executeTick() override;
  void halt() final {resetStatus();}
};

class SimpleActionNode : public SyncActionNode
{
public:
  using TickFunctor = std::function<NodeStatus(TreeNode &)>;

  SimpleActionNode(const std::string & name, TickFunctor tick_functor, const NodeConfiguration & config)
  : SyncActionNode(name, config), tick_functor_(std::move(tick_functor)) {}

protected:
  NodeStatus tick() final;

  TickFunctor tick_functor_;
};

/// tick() has a thread of its own, and looks whether it shall end.
class AsyncActionNode : public ActionNodeBase
{
public:
  AsyncActionNode(const std::string & name, const NodeConfiguration & config)
  : ActionNodeBase(name, config) {}
  ~AsyncActionNode() override;
  bool isHaltRequested() const {return halt_requested_;}
  NodeStatus executeTick() final;
  void halt() override;

private:
  void run();
  void join();

  std::exception_ptr thrown_;
  std::atomic_bool halt_requested_{false};
  std::thread thread_;
  std::mutex thrown_mutex_;
};

/// Begins, goes on at each tick, and is told when it is halted.
class StatefulActionNode : public ActionNodeBase
{
public:
  StatefulActionNode(const std::string & name, const NodeConfiguration & config)
  : ActionNodeBase(name, config) {}
  NodeStatus tick() final;
  void halt() final;

  virtual NodeStatus onStart() = 0;
  virtual NodeStatus onRunning() = 0;
  virtual void onHalted() = 0;
};

/// tick() stops where it says so, and goes on there at the next tick.
class CoroActionNode : public ActionNodeBase
{
public:
  CoroActionNode(const std::string & name, const NodeConfiguration & config);
  ~CoroActionNode() override;
  void setStatusRunningAndYield();
  NodeStatus executeTick() final;
  void halt() override;

protected:
  struct Pimpl;
  std::unique_ptr<Pimpl> _p;
};
}  // namespace BT
