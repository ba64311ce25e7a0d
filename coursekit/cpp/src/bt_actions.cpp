// Actions of trees that need more than a tick.
#include <iostream>
#include <utility>

#include "behaviortree_cpp_v3/actions/set_blackboard_node.h"

namespace BT
{
NodeStatus SyncActionNode::executeTick()
{
  const NodeStatus status = ActionNodeBase::executeTick();
  if (status == NodeStatus::RUNNING) {
    throw LogicError("SyncActionNode MUST never return RUNNING");
  }
  return status;
}
NodeStatus SimpleActionNode::tick()
{
  if (status() == NodeStatus::IDLE) {
    setStatus(NodeStatus::RUNNING);
  }
  return tick_functor_(*this);
}

AsyncActionNode::~AsyncActionNode()
{
  halt_requested_ = true;
  join();
}
NodeStatus AsyncActionNode::executeTick()
{
  if (status() == NodeStatus::IDLE) {
    join();
    halt_requested_ = false;
    setStatus(NodeStatus::RUNNING);
    thread_ = std::thread([this] {run();});
  }
  std::lock_guard<std::mutex> hold(thrown_mutex_);
  if (auto thrown = std::exchange(thrown_, nullptr)) {
    std::rethrow_exception(thrown);
  }
  return status();
}
void AsyncActionNode::run()
{
  try {
    setStatus(tick());
  } catch (...) {
    std::cerr << "\nUncaught exception from the method tick(): [" << registrationName() << "/" << name() << "]\n" <<
      std::endl;
    std::lock_guard<std::mutex> hold(thrown_mutex_);
    thrown_ = std::current_exception();
  }
  emitStateChanged();
}
void AsyncActionNode::join()
{
  if (thread_.joinable()) {
    thread_.join();
  }
}
void AsyncActionNode::halt()
{
  halt_requested_ = true;
  join();
}

NodeStatus StatefulActionNode::tick()
{
  const NodeStatus before = status();
  if (StatusCompleted(before)) {
    return before;
  }
  const bool begins = before == NodeStatus::IDLE;
  const NodeStatus now = begins ? onStart() : onRunning();
  if (now == NodeStatus::IDLE) {
    throw LogicError("StatefulActionNode::", begins ? "onStart" : "onRunning", "() must not return IDLE");
  }
  return now;
}
void StatefulActionNode::halt()
{
  if (status() == NodeStatus::RUNNING) {
    onHalted();
  }
  resetStatus();
}

namespace
{
struct CoroutineHalted {};
}  // namespace

/// A thread that only goes on while the tree waits for it.
struct CoroActionNode::Pimpl
{
  std::thread thread;
  std::mutex mutex;
  std::condition_variable changed;
  bool its_turn = false, alive = false, halted = false;
  std::exception_ptr thrown;

  void give_turn(bool to_it)
  {
    {
      std::lock_guard<std::mutex> hold(mutex);
      its_turn = to_it;
    }
    changed.notify_all();
    await_turn(!to_it);
  }
  void await_turn(bool its)
  {
    std::unique_lock<std::mutex> hold(mutex);
    changed.wait(hold, [this, its] {return its_turn == its;});
  }
  void end()
  {
    std::lock_guard<std::mutex> hold(mutex);
    alive = its_turn = false;
    changed.notify_all();
  }
  void stop()
  {
    if (alive) {
      halted = true;
      give_turn(true);
    }
    if (thread.joinable()) {
      thread.join();
    }
    halted = false;
  }
};

CoroActionNode::CoroActionNode(const std::string & name, const NodeConfiguration & config)
: ActionNodeBase(name, config), _p(std::make_unique<Pimpl>()) {}
CoroActionNode::~CoroActionNode() {_p->stop();}

void CoroActionNode::setStatusRunningAndYield()
{
  setStatus(NodeStatus::RUNNING);
  _p->give_turn(false);
  if (_p->halted) {
    throw CoroutineHalted();
  }
}
NodeStatus CoroActionNode::executeTick()
{
  if (!_p->alive) {
    _p->stop();
    _p->alive = true;
    _p->thread = std::thread([this] {
        _p->await_turn(true);
        try {
          setStatus(tick());
        } catch (const CoroutineHalted &) {
        } catch (...) {
          _p->thrown = std::current_exception();
        }
        _p->end();
      });
  }
  _p->give_turn(true);
  if (auto thrown = std::exchange(_p->thrown, nullptr)) {
    std::rethrow_exception(thrown);
  }
  return status();
}
void CoroActionNode::halt()
{
  _p->stop();
  resetStatus();
}

PortsList SetBlackboard::providedPorts()
{
  return {
    InputPort("value", "Value represented as a string. convertFromString must be implemented."),
    BidirectionalPort("output_key", "Name of the blackboard entry where the value should be written")};
}
NodeStatus SetBlackboard::tick()
{
  std::string key, value;
  if (!getInput("output_key", key)) {
    throw RuntimeError("missing port [output_key]");
  }
  if (!getInput("value", value)) {
    throw RuntimeError("missing port [value]");
  }
  setOutput("output_key", value);
  return NodeStatus::SUCCESS;
}
}  // namespace BT
