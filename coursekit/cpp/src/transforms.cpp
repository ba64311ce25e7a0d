// Buffers of transforms, which are the session's.
#include "tf2_ros/buffer.h"
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
bool can(const Packer & with, std::string * why_not)
{
  auto answer = asked("tf_can", with);
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
  return can(Packer{}.i(id).i(0).s(target).s(source).i(count(time)), why_not);
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
  auto answer = asked("tf_names", Packer{}.i(id));
  std::vector<std::string> names(static_cast<size_t>(answer.i()));
  for (auto & name : names) {
    name = answer.s();
  }
  return names;
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
  return can(Packer{}.i(id).i(timeout.count()).s(target).s(source).i(count(time)), why_not);
}
TransformStampedFuture Buffer::waitForTransform(
  const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration & timeout,
  TransformReadyCallback callback)
{
  if (!timers_) {
    throw CreateTimerInterfaceException("timer interface not set before call to waitForTransform");
  }
  auto promise = std::make_shared<std::promise<geometry_msgs::msg::TransformStamped>>();
  TransformStampedFuture future = promise->get_future().share();
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
  waiting_.remove_if([](auto & timer) {return timer->is_canceled();});
  waiting_.push_back(rclcpp::detail::timer(*timers_->base, std::chrono::milliseconds(10), look, timers_->group, nullptr));
  return future;
}
void TransformListener::listen(tf2::BufferCore & buffer, bool static_only)
{
  id = asked("tf_listener", Packer{}.i(buffer.id).i(static_only)).i();
}
}  // namespace tf2_ros
