// Geometry messages to Eigen's classes, back, and these through transforms.
#pragma once
#include <Eigen/Geometry>

#include "geometry_msgs/msg/accel.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/wrench.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace tf2
{
using Vector6d = Eigen::Matrix<double, 6, 1>;

inline gm::Point toMsg(const Eigen::Vector3d & v) {return gm::Point().set__x(v.x()).set__y(v.y()).set__z(v.z());}
inline void fromMsg(const gm::Point & m, Eigen::Vector3d & v) {v = Eigen::Vector3d(m.x, m.y, m.z);}
inline gm::Vector3 & toMsg(const Eigen::Vector3d & v, gm::Vector3 & m)
{
  return m = gm::Vector3().set__x(v.x()).set__y(v.y()).set__z(v.z());
}
/// The same, for who expects one argument: toMsg() of one makes a point.
inline gm::Vector3 toMsg2(const Eigen::Vector3d & v) {return gm::Vector3().set__x(v.x()).set__y(v.y()).set__z(v.z());}
inline void fromMsg(const gm::Vector3 & m, Eigen::Vector3d & v) {v = Eigen::Vector3d(m.x, m.y, m.z);}
inline gm::Quaternion toMsg(const Eigen::Quaterniond & q)
{
  return gm::Quaternion().set__x(q.x()).set__y(q.y()).set__z(q.z()).set__w(q.w());
}
inline void fromMsg(const gm::Quaternion & m, Eigen::Quaterniond & q) {q = Eigen::Quaterniond(m.w, m.x, m.y, m.z);}
inline gm::Twist toMsg(const Vector6d & v)
{
  gm::Twist twist;
  toMsg(Eigen::Vector3d(v.head<3>()), twist.linear);
  toMsg(Eigen::Vector3d(v.tail<3>()), twist.angular);
  return twist;
}
inline void fromMsg(const gm::Twist & m, Vector6d & v)
{
  v << m.linear.x, m.linear.y, m.linear.z, m.angular.x, m.angular.y, m.angular.z;
}
inline void fromMsg(const gm::Accel & m, Vector6d & v)
{
  v << m.linear.x, m.linear.y, m.linear.z, m.angular.x, m.angular.y, m.angular.z;
}

inline Eigen::Isometry3d transformToEigen(const gm::Transform & t)
{
  Eigen::Vector3d shift;
  Eigen::Quaterniond turn;
  fromMsg(t.translation, shift);
  fromMsg(t.rotation, turn);
  return Eigen::Isometry3d(Eigen::Translation3d(shift) * turn);
}
inline Eigen::Isometry3d transformToEigen(const gm::TransformStamped & t) {return transformToEigen(t.transform);}

/// Both of Eigen's classes of poses, to poses and transforms, back, and through a transform.
#define COURSEKIT_EIGEN_POSE(Class) \
  inline gm::TransformStamped eigenToTransform(const Eigen::Class & t) \
  { \
    gm::TransformStamped message; \
    toMsg(Eigen::Vector3d(t.translation()), message.transform.translation); \
    message.transform.rotation = toMsg(Eigen::Quaterniond(t.linear())); \
    return message; \
  } \
  inline gm::Pose toMsg(const Eigen::Class & t) \
  { \
    Eigen::Quaterniond turn(t.linear()); \
    if (turn.w() < 0) { \
      turn.coeffs() *= -1; \
    } \
    return gm::Pose().set__position(toMsg(Eigen::Vector3d(t.translation()))).set__orientation(toMsg(turn)); \
  } \
  inline void fromMsg(const gm::Pose & m, Eigen::Class & t) \
  { \
    Eigen::Quaterniond turn; \
    fromMsg(m.orientation, turn); \
    t = Eigen::Class(Eigen::Translation3d(m.position.x, m.position.y, m.position.z) * turn); \
  } \
  template<> \
  inline void doTransform(const Eigen::Class & in, Eigen::Class & out, const gm::TransformStamped & transform) \
  { \
    out = Eigen::Class(transformToEigen(transform) * in); \
  }
COURSEKIT_EIGEN_POSE(Affine3d)
COURSEKIT_EIGEN_POSE(Isometry3d)

template<>
inline void doTransform(const Eigen::Vector3d & in, Eigen::Vector3d & out, const gm::TransformStamped & transform)
{
  out = transformToEigen(transform) * in;
}
/// Of six numbers, such as a force and a torque: what turns is turned, and what it moves beside it is added to the rest.
template<>
inline void doTransform(const Eigen::VectorXd & in, Eigen::VectorXd & out, const gm::TransformStamped & transform)
{
  const Eigen::Isometry3d motion = transformToEigen(transform);
  const Eigen::Vector3d first = motion.linear() * in.head<3>(), second = motion.linear() * in.tail<3>();
  out.resize(6);
  out << first, second + motion.translation().cross(first);
}
template<>
inline void doTransform(const Eigen::Quaterniond & in, Eigen::Quaterniond & out, const gm::TransformStamped & transform)
{
  out = Eigen::Quaterniond(transformToEigen(transform).linear()) * in;
}

// -- with a time and a frame

#define COURSEKIT_EIGEN_STAMPED(Data, Message, field) \
  inline gm::Message toMsg(const Stamped<Eigen::Data> & in) \
  { \
    return gm::Message().set__header(header_of(in)).set__ ## field(toMsg(static_cast<const Eigen::Data &>(in))); \
  } \
  inline void fromMsg(const gm::Message & m, Stamped<Eigen::Data> & out) \
  { \
    Eigen::Data data; \
    fromMsg(m.field, data); \
    out = Stamped<Eigen::Data>(data, time_of(m.header), m.header.frame_id); \
  } \
  template<> \
  inline void doTransform( \
    const Stamped<Eigen::Data> & in, Stamped<Eigen::Data> & out, const gm::TransformStamped & transform) \
  { \
    Eigen::Data data; \
    doTransform(static_cast<const Eigen::Data &>(in), data, transform); \
    out = Stamped<Eigen::Data>(data, time_of(transform.header), transform.header.frame_id); \
  }
COURSEKIT_EIGEN_STAMPED(Vector3d, PointStamped, point)
COURSEKIT_EIGEN_STAMPED(Quaterniond, QuaternionStamped, quaternion)
COURSEKIT_EIGEN_STAMPED(Affine3d, PoseStamped, pose)
COURSEKIT_EIGEN_STAMPED(Isometry3d, PoseStamped, pose)

/// convert() of a pair: its template was read before these functions.
#define COURSEKIT_EIGEN_CONVERT(Data, Message) \
  inline void convert(const Data & a, gm::Message & b) {b = toMsg(a);} \
  inline void convert(const gm::Message & a, Data & b) {fromMsg(a, b);}
COURSEKIT_EIGEN_CONVERT(Eigen::Vector3d, Point)
COURSEKIT_EIGEN_CONVERT(Eigen::Quaterniond, Quaternion)
COURSEKIT_EIGEN_CONVERT(Eigen::Affine3d, Pose)
COURSEKIT_EIGEN_CONVERT(Eigen::Isometry3d, Pose)
COURSEKIT_EIGEN_CONVERT(Vector6d, Twist)
}  // namespace tf2
