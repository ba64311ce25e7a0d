// Buffers of transforms, which are the session's.
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

using coursekit::Packer;
using coursekit::Unpacker;

namespace tf2_ros
{
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
}  // namespace

Buffer::Buffer(rclcpp::Clock::SharedPtr, tf2::Duration cache_time, rclcpp::Node::SharedPtr node)
{
  id = asked("tf_buffer", Packer{}.i(cache_time.count()).i(node ? node->get_node_base_interface()->id : 0)).i();
}
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
  auto answer = asked("tf_can", Packer{}.i(id).i(timeout.count()).s(target).s(source).i(count(time)));
  bool can = answer.i();
  std::string why = answer.s();
  if (why_not) {
    *why_not = why;
  }
  return can;
}
bool Buffer::setTransform(const geometry_msgs::msg::TransformStamped & transform, const std::string & authority, bool is_static)
{
  asked("tf_set", Packer{}.i(id).s(authority).i(is_static).m(transform));
  return true;
}
void Buffer::clear() {asked("tf_clear", Packer{}.i(id));}
std::string Buffer::allFramesAsString() const {return asked("tf_text", Packer{}.i(id)).s();}
std::string Buffer::allFramesAsYAML() const {return asked("tf_yaml", Packer{}.i(id)).s();}
std::vector<std::string> Buffer::getAllFrameNames() const
{
  auto answer = asked("tf_names", Packer{}.i(id));
  std::vector<std::string> names(static_cast<size_t>(answer.i()));
  for (auto & name : names) {
    name = answer.s();
  }
  return names;
}
void TransformListener::listen(Buffer & buffer, bool static_only)
{
  id = asked("tf_listener", Packer{}.i(buffer.id).i(static_only)).i();
}
}  // namespace tf2_ros
