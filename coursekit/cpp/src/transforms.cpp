// Buffers of transforms, which are the session's.
#include "tf2_ros/buffer.h"
#include "tf2_ros/buffer_server.h"
#include "tf2_ros/transform_listener.h"

using coursekit::Packer;
using coursekit::Unpacker;

namespace
{
Unpacker asked(const char * what, const Packer & with)
{
  try {
    return coursekit::request(what, with);
  } catch (const coursekit::Refused & refusal) {
#define COURSEKIT_THROW(Name) \
  if (refusal.kind == #Name) { \
    throw tf2::Name(refusal.what()); \
  }
    COURSEKIT_THROW(ConnectivityException)
    COURSEKIT_THROW(LookupException)
    COURSEKIT_THROW(ExtrapolationException)
    COURSEKIT_THROW(InvalidArgumentException)
    COURSEKIT_THROW(TimeoutException)
    throw tf2::TransformException(refusal.what());
  }
}
int64_t count(const tf2::TimePoint & time) {return time.time_since_epoch().count();}
bool can(const char * what, const Packer & with, std::string * why_not)
{
  auto answer = asked(what, with);
  bool can = answer.i();
  std::string why = answer.s();
  if (why_not) {
    *why_not = why;
  }
  return can;
}
}  // namespace

namespace tf2
{
BufferCore::BufferCore(Duration cache_time)
: BufferCore(cache_time, 0) {}
BufferCore::BufferCore(Duration cache_time, int64_t node)
: cache_time_(cache_time)
{
  id = asked("tf_buffer", Packer{}.i(cache_time.count()).i(node)).i();
}
geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(
  const std::string & target, const std::string & source, const TimePoint & time) const
{
  return asked("tf_lookup", Packer{}.i(id).i(0).s(target).s(source).i(count(time))).m<geometry_msgs::msg::TransformStamped>();
}
geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(
  const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
  const std::string & fixed) const
{
  Packer with = Packer{}.i(id).i(0).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  return asked("tf_lookup_full", with).m<geometry_msgs::msg::TransformStamped>();
}
bool BufferCore::canTransform(
  const std::string & target, const std::string & source, const TimePoint & time, std::string * why_not) const
{
  return can("tf_can", Packer{}.i(id).i(0).s(target).s(source).i(count(time)), why_not);
}
bool BufferCore::canTransform(
  const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
  const std::string & fixed, std::string * why_not) const
{
  Packer with = Packer{}.i(id).i(0).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  return can("tf_can_full", with, why_not);
}
bool BufferCore::_frameExists(const std::string & name) const
{
  auto names = getAllFrameNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}
bool BufferCore::setTransform(const geometry_msgs::msg::TransformStamped & transform, const std::string & authority, bool is_static)
{
  asked("tf_set", Packer{}.i(id).s(authority).i(is_static).m(transform));
  return true;
}
void BufferCore::clear() {asked("tf_clear", Packer{}.i(id));}
std::string BufferCore::allFramesAsString() const {return asked("tf_text", Packer{}.i(id)).s();}
std::string BufferCore::allFramesAsYAML() const {return asked("tf_yaml", Packer{}.i(id)).s();}
std::vector<std::string> BufferCore::getAllFrameNames() const
{
  return asked("tf_names", Packer{}.i(id)).texts();
}
void BufferCore::_getFrameStrings(std::vector<std::string> & names) const {names = getAllFrameNames();}
std::string BufferCore::_allFramesAsDot() const {return asked("tf_dot", Packer{}.i(id).i(0)).s();}
std::string BufferCore::_allFramesAsDot(TimePoint now) const {return asked("tf_dot", Packer{}.i(id).i(count(now))).s();}
bool BufferCore::_getParent(const std::string & frame, TimePoint, std::string & parent) const
{
  parent = asked("tf_parent", Packer{}.i(id).s(frame)).s();
  return !parent.empty();
}
void BufferCore::_chainAsVector(
  const std::string & target, TimePoint target_time, const std::string & source, TimePoint source_time,
  const std::string & fixed, std::vector<std::string> & chain) const
{
  Packer with = Packer{}.i(id).i(0).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  chain = asked("tf_chain", with).texts();
}
}  // namespace tf2

namespace tf2_ros
{
Buffer::Buffer(rclcpp::Clock::SharedPtr, tf2::Duration cache_time, rclcpp::Node::SharedPtr node)
: BufferCore(cache_time, node ? node->get_node_base_interface()->id : 0) {}
geometry_msgs::msg::TransformStamped Buffer::lookupTransform(
  const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration timeout) const
{
  auto answer = asked("tf_lookup", Packer{}.i(id).i(timeout.count()).s(target).s(source).i(count(time)));
  return answer.m<geometry_msgs::msg::TransformStamped>();
}
geometry_msgs::msg::TransformStamped Buffer::lookupTransform(
  const std::string & target, const tf2::TimePoint & target_time, const std::string & source, const tf2::TimePoint & source_time,
  const std::string & fixed, const tf2::Duration timeout) const
{
  Packer with = Packer{}.i(id).i(timeout.count()).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  return asked("tf_lookup_full", with).m<geometry_msgs::msg::TransformStamped>();
}
bool Buffer::canTransform(
  const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration timeout,
  std::string * why_not) const
{
  return can("tf_can", Packer{}.i(id).i(timeout.count()).s(target).s(source).i(count(time)), why_not);
}
bool Buffer::canTransform(
  const std::string & target, const tf2::TimePoint & target_time, const std::string & source, const tf2::TimePoint & source_time,
  const std::string & fixed, const tf2::Duration timeout, std::string * why_not) const
{
  Packer with = Packer{}.i(id).i(timeout.count()).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  return can("tf_can_full", with, why_not);
}
TransformStampedFuture Buffer::waitForTransform(
  const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration & timeout,
  TransformReadyCallback callback)
{
  if (!timers_) {
    throw CreateTimerInterfaceException("timer interface not set before call to waitForTransform");
  }
  auto promise = std::make_shared<std::promise<geometry_msgs::msg::TransformStamped>>();
  TransformStampedFuture future(promise->get_future().share());
  future.setHandle(++waits_);
  int64_t end = coursekit::steady_now() + timeout.count();
  auto settled = [this, target, source, time, end, promise, future, callback] {
      if (canTransform(target, source, time)) {
        promise->set_value(lookupTransform(target, source, time, tf2::Duration::zero()));
      } else if (coursekit::steady_now() >= end) {
        promise->set_exception(
          std::make_exception_ptr(tf2::TimeoutException(std::string("Timed out waiting for transform from ") +
          source + " to " + target)));
      } else {
        return false;
      }
      callback(future);
      return true;
    };
  if (settled()) {
    return future;
  }
  auto look = [settled](rclcpp::TimerBase & timer) {
      if (settled()) {
        timer.cancel();
      }
    };
  std::lock_guard<std::mutex> hold(lock_);
  forget_ended();
  waiting_.emplace_back(
    future.getHandle(), rclcpp::detail::timer(*timers_->base, std::chrono::milliseconds(10), look, timers_->group, nullptr));
  return future;
}
void Buffer::forget_ended()
{
  waiting_.remove_if([](auto & wait) {return wait.second->is_canceled();});
}
void Buffer::cancel(const TransformStampedFuture & future)
{
  std::lock_guard<std::mutex> hold(lock_);
  for (auto & wait : waiting_) {
    if (wait.first == future.getHandle()) {
      wait.second->cancel();
    }
  }
  forget_ended();
}
BufferServer::BufferServer(
  const tf2::BufferCore & buffer, const rclcpp::node_interfaces::NodeBaseInterface & node, const std::string & ns,
  tf2::Duration check_period)
{
  id = asked("tf_server", Packer{}.i(buffer.id).i(node.id).s(ns).i(check_period.count())).i();
}
void TransformListener::listen(tf2::BufferCore & buffer, bool static_only)
{
  id = asked("tf_listener", Packer{}.i(buffer.id).i(static_only)).i();
}
}  // namespace tf2_ros
