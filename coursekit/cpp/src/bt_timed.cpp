// The nodes of trees that wait, or do not wait any longer.
#include "behaviortree_cpp_v3/decorators/delay_node.h"
#include "behaviortree_cpp_v3/decorators/timeout_node.h"

namespace BT
{
Alarm::~Alarm()
{
  {
    std::lock_guard<std::mutex> hold(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  }
}
void Alarm::set(std::chrono::milliseconds time)
{
  {
    std::lock_guard<std::mutex> hold(mutex_);
    when_ = Clock::now() + time;
    waiting_ = true;
    if (!thread_.joinable()) {
      thread_ = std::thread([this] {run();});
    }
  }
  changed_.notify_all();
}
void Alarm::cancel()
{
  {
    std::lock_guard<std::mutex> hold(mutex_);
    when_ = Clock::time_point::max();
    waiting_ = false;
  }
  changed_.notify_all();
}
bool Alarm::over() const
{
  std::lock_guard<std::mutex> hold(mutex_);
  return Clock::now() >= when_;
}
void Alarm::run()
{
  std::unique_lock<std::mutex> hold(mutex_);
  while (!ended_) {
    if (!waiting_) {
      changed_.wait(hold);
    } else if (Clock::now() < when_) {
      changed_.wait_until(hold, Clock::time_point(when_));
    } else {
      waiting_ = false;
      hold.unlock();
      ring_();
      hold.lock();
    }
  }
}

TimeoutNodeBase::TimeoutNodeBase(
  const std::string & name, const NodeConfiguration & config, unsigned milliseconds, bool read_ports)
: DecoratorNode(name, config), milliseconds_(milliseconds), read_ports_(read_ports), alarm_([this] {ring();})
{
  setRegistrationID("Timeout");
}
PortsList TimeoutNodeBase::ports()
{
  return {InputPort<unsigned>("msec", "After a certain amount of time, halt() the child if it is still running.")};
}
NodeStatus TimeoutNodeBase::tick()
{
  std::lock_guard<std::recursive_mutex> hold(mutex_);
  if (!started_) {
    start();
  }
  if (alarm_.over()) {  // the alarm may be about to ring at this very time
    haltChild();
    started_ = false;
    return NodeStatus::FAILURE;
  }
  const NodeStatus status = child()->executeTick();
  if (status != NodeStatus::RUNNING) {
    started_ = false;
    alarm_.cancel();
  }
  return status;
}
void TimeoutNodeBase::start()
{
  if (read_ports_ && !getInput("msec", milliseconds_)) {
    throw RuntimeError("Missing parameter [msec] in TimeoutNode");
  }
  started_ = true;
  setStatus(NodeStatus::RUNNING);
  alarm_.cancel();
  if (milliseconds_ > 0) {
    alarm_.set(std::chrono::milliseconds(milliseconds_));
  }
}
void TimeoutNodeBase::ring()
{
  std::lock_guard<std::recursive_mutex> hold(mutex_);
  if (started_ && alarm_.over() && child()->status() == NodeStatus::RUNNING) {
    haltChild();
    emitStateChanged();
  }
}
void TimeoutNodeBase::halt()
{
  std::lock_guard<std::recursive_mutex> hold(mutex_);
  started_ = false;
  alarm_.cancel();
  DecoratorNode::halt();
}

PortsList DelayNode::providedPorts()
{
  return {InputPort<unsigned>("delay_msec", "Tick the child after a few milliseconds")};
}
NodeStatus DelayNode::tick()
{
  if (read_ports_ && !getInput("delay_msec", milliseconds_)) {
    throw RuntimeError("Missing parameter [delay_msec] in DelayNode");
  }
  if (!started_) {
    started_ = true;
    setStatus(NodeStatus::RUNNING);
    alarm_.set(std::chrono::milliseconds(milliseconds_));
  }
  if (!alarm_.over()) {
    return NodeStatus::RUNNING;
  }
  const NodeStatus status = child()->executeTick();
  started_ = status == NodeStatus::RUNNING;
  return status;
}
void DelayNode::halt()
{
  started_ = false;
  alarm_.cancel();
  DecoratorNode::halt();
}
}  // namespace BT
