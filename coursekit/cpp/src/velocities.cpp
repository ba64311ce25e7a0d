// How fast a frame moves: the difference of two transforms, over the time between them.
#include <algorithm>

#include "tf2/buffer_core.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace tf2
{
namespace
{
/// The times between which a frame is watched: as far as transforms reach, and not before the first time that can be asked for.
struct Span
{
  Span(double middle, double length, double newest)
  : end(std::min(middle + length / 2, newest)), start(std::max(EARLIEST + length, end) - length) {}
  static constexpr double EARLIEST = 1e-5;  // s; time zero means the newest
  double end, start;
};
Transform transform_at(const BufferCore & buffer, const std::string & target, const std::string & source, double seconds)
{
  Transform found;
  fromMsg(buffer.lookupTransform(target, source, timeFromSec(seconds)).transform, found);
  return found;
}
/// The axis between two orientations, as long as its angle.
Vector3 turn_between(const Transform & start, const Transform & end)
{
  Quaternion turn;
  (start.getBasis().inverse() * end.getBasis()).getRotation(turn);
  return start.getBasis() * turn.getAxis() * turn.getAngle();
}
}  // namespace

geometry_msgs::msg::VelocityStamped BufferCore::lookupVelocity(
  const std::string & tracking_frame, const std::string & observation_frame, const TimePoint & time,
  const Duration & averaging_interval) const
{
  return lookupVelocity(
    tracking_frame, observation_frame, observation_frame, Vector3(0, 0, 0), tracking_frame, time, averaging_interval);
}
geometry_msgs::msg::VelocityStamped BufferCore::lookupVelocity(
  const std::string & tracking_frame, const std::string & observation_frame, const std::string & reference_frame,
  const Vector3 & reference_point, const std::string & reference_point_frame, const TimePoint & time,
  const Duration & averaging_interval) const
{
  const double at = timeToSec(time), length = durationToSec(averaging_interval);
  const TimePoint newest = time_of(lookupTransform(observation_frame, tracking_frame, TimePointZero).header);
  const Span span(at, length, timeToSec(newest));
  const Transform start = transform_at(*this, observation_frame, tracking_frame, span.start);
  const Transform end = transform_at(*this, observation_frame, tracking_frame, span.end);
  const Vector3 speed = (end.getOrigin() - start.getOrigin()) / (span.end - span.start);
  const Vector3 turn = turn_between(start, end) / (span.end - span.start);

  const Transform reference = transform_at(*this, reference_frame, tracking_frame, at);
  const Vector3 point = transform_at(*this, reference_frame, reference_point_frame, at) * reference_point;
  const Vector3 angular = reference.getBasis() * turn;
  Vector3 linear = reference.getBasis() * speed + reference.getOrigin().cross(angular);
  linear += angular * (point - reference.getOrigin());  // Humble multiplies axis by axis here, where physics has a cross product

  geometry_msgs::msg::VelocityStamped velocity;
  velocity.header = header_of(Stamped<Vector3>(linear, timeFromSec(span.start + length / 2), reference_frame));
  velocity.body_frame_id = tracking_frame;
  velocity.velocity.linear = toMsg(linear);
  velocity.velocity.angular = toMsg(angular);
  return velocity;
}
}  // namespace tf2
