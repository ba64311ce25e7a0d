// KDL's vectors, twists, wrenches and frames to messages, back, and through transforms. KDL itself is the system's.
#pragma once
#include <kdl/frames.hpp>

#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer_interface.h"

namespace tf2
{
inline KDL::Frame transformToKDL(const gm::TransformStamped & t)
{
  const auto & turn = t.transform.rotation;
  const auto & shift = t.transform.translation;
  return KDL::Frame(
    KDL::Rotation::Quaternion(turn.x, turn.y, turn.z, turn.w), KDL::Vector(shift.x, shift.y, shift.z));
}
inline gm::TransformStamped kdlToTransform(const KDL::Frame & k)
{
  gm::TransformStamped t;
  t.transform.translation.set__x(k.p.x()).set__y(k.p.y()).set__z(k.p.z());
  auto & turn = t.transform.rotation;
  k.M.GetQuaternion(turn.x, turn.y, turn.z, turn.w);
  return t;
}

namespace detail
{
template<class M>
void kdl_to_msg(const KDL::Vector & v, M & m) {m.set__x(v.x()).set__y(v.y()).set__z(v.z());}
template<class M>
KDL::Vector kdl_of(const M & m) {return KDL::Vector(m.x, m.y, m.z);}
/// A message with a header whose content `fill` writes.
template<class M, class T, class Fill>
M kdl_stamped(const Stamped<T> & in, Fill fill)
{
  M message;
  message.header.stamp = tf2_ros::toMsg(in.stamp_);
  message.header.frame_id = in.frame_id_;
  fill(message);
  return message;
}
template<class T>
Stamped<T> kdl_moved(const Stamped<T> & in, const gm::TransformStamped & transform)
{
  return Stamped<T>(transformToKDL(transform) * static_cast<const T &>(in), time_of(transform.header), transform.header.frame_id);
}
}  // namespace detail

#define COURSEKIT_KDL_MOVED(Type) \
  template<> \
  inline void doTransform(const Stamped<Type> & in, Stamped<Type> & out, const gm::TransformStamped & transform) \
  { \
    out = detail::kdl_moved(in, transform); \
  }
COURSEKIT_KDL_MOVED(KDL::Vector)
COURSEKIT_KDL_MOVED(KDL::Twist)
COURSEKIT_KDL_MOVED(KDL::Wrench)
COURSEKIT_KDL_MOVED(KDL::Frame)

// -- positions

inline gm::PointStamped toMsg(const Stamped<KDL::Vector> & in)
{
  return detail::kdl_stamped<gm::PointStamped>(in, [&](auto & m) {detail::kdl_to_msg(in, m.point);});
}
inline void fromMsg(const gm::PointStamped & m, Stamped<KDL::Vector> & out)
{
  out = Stamped<KDL::Vector>(detail::kdl_of(m.point), time_of(m.header), m.header.frame_id);
}

// -- velocities and forces

inline gm::TwistStamped toMsg(const Stamped<KDL::Twist> & in)
{
  return detail::kdl_stamped<gm::TwistStamped>(
    in, [&](auto & m) {
      detail::kdl_to_msg(in.vel, m.twist.linear);
      detail::kdl_to_msg(in.rot, m.twist.angular);
    });
}
inline void fromMsg(const gm::TwistStamped & m, Stamped<KDL::Twist> & out)
{
  const KDL::Twist twist(detail::kdl_of(m.twist.linear), detail::kdl_of(m.twist.angular));
  out = Stamped<KDL::Twist>(twist, time_of(m.header), m.header.frame_id);
}
inline gm::WrenchStamped toMsg(const Stamped<KDL::Wrench> & in)
{
  return detail::kdl_stamped<gm::WrenchStamped>(
    in, [&](auto & m) {
      detail::kdl_to_msg(in.force, m.wrench.force);
      detail::kdl_to_msg(in.torque, m.wrench.torque);
    });
}
inline void fromMsg(const gm::WrenchStamped & m, Stamped<KDL::Wrench> & out)
{
  const KDL::Wrench wrench(detail::kdl_of(m.wrench.force), detail::kdl_of(m.wrench.torque));
  out = Stamped<KDL::Wrench>(wrench, time_of(m.header), m.header.frame_id);
}

// -- poses

inline gm::Pose toMsg(const KDL::Frame & in)
{
  gm::Pose pose;
  detail::kdl_to_msg(in.p, pose.position);
  in.M.GetQuaternion(pose.orientation.x, pose.orientation.y, pose.orientation.z, pose.orientation.w);
  return pose;
}
inline void fromMsg(const gm::Pose & m, KDL::Frame & out)
{
  const auto & turn = m.orientation;
  out = KDL::Frame(KDL::Rotation::Quaternion(turn.x, turn.y, turn.z, turn.w), detail::kdl_of(m.position));
}
inline gm::PoseStamped toMsg(const Stamped<KDL::Frame> & in)
{
  return detail::kdl_stamped<gm::PoseStamped>(in, [&](auto & m) {m.pose = toMsg(static_cast<const KDL::Frame &>(in));});
}
inline void fromMsg(const gm::PoseStamped & m, Stamped<KDL::Frame> & out)
{
  KDL::Frame frame;
  fromMsg(m.pose, frame);
  out = Stamped<KDL::Frame>(frame, time_of(m.header), m.header.frame_id);
}
}  // namespace tf2
