// Geometry messages to what tf2 counts with, back, and through transforms.
#pragma once
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/polygon_stamped.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/vector3_stamped.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "tf2/LinearMath/Transform.h"
#include "tf2/convert.h"
#include "tf2/transform_datatypes.h"

namespace tf2
{
namespace gm = geometry_msgs::msg;

// -- one message, one class of tf2's

inline gm::Vector3 toMsg(const Vector3 & v) {return gm::Vector3().set__x(v.x()).set__y(v.y()).set__z(v.z());}
inline void fromMsg(const gm::Vector3 & m, Vector3 & v) {v = Vector3(m.x, m.y, m.z);}
inline gm::Point & toMsg(const Vector3 & v, gm::Point & m)
{
  m.x = v.x();
  m.y = v.y();
  m.z = v.z();
  return m;
}
inline void fromMsg(const gm::Point & m, Vector3 & v) {v = Vector3(m.x, m.y, m.z);}
inline gm::Quaternion toMsg(const Quaternion & q)
{
  return gm::Quaternion().set__x(q.x()).set__y(q.y()).set__z(q.z()).set__w(q.w());
}
inline void fromMsg(const gm::Quaternion & m, Quaternion & q) {q = Quaternion(m.x, m.y, m.z, m.w);}
inline gm::Transform toMsg(const Transform & t)
{
  return gm::Transform().set__translation(toMsg(t.getOrigin())).set__rotation(toMsg(t.getRotation()));
}
inline void fromMsg(const gm::Transform & m, Transform & t)
{
  Quaternion turn;
  Vector3 shift;
  fromMsg(m.rotation, turn);
  fromMsg(m.translation, shift);
  t = Transform(turn, shift);
}
inline gm::Pose & toMsg(const Transform & t, gm::Pose & m)
{
  toMsg(t.getOrigin(), m.position);
  m.orientation = toMsg(t.getRotation());
  return m;
}
inline void fromMsg(const gm::Pose & m, Transform & t)
{
  Quaternion turn;
  Vector3 place;
  fromMsg(m.orientation, turn);
  fromMsg(m.position, place);
  t = Transform(turn, place);
}

// -- with a time and a frame

inline TimePoint time_of(const std_msgs::msg::Header & header)
{
  return TimePoint(std::chrono::seconds(header.stamp.sec) + std::chrono::nanoseconds(header.stamp.nanosec));
}
template<class T>
std_msgs::msg::Header header_of(const Stamped<T> & data)
{
  std_msgs::msg::Header header;
  auto nanoseconds = data.stamp_.time_since_epoch().count();
  header.stamp.sec = static_cast<int32_t>(nanoseconds / 1000000000);
  header.stamp.nanosec = static_cast<uint32_t>(nanoseconds % 1000000000);
  header.frame_id = data.frame_id_;
  return header;
}
#define COURSEKIT_STAMPED_DATA(Type, field, Data) \
  inline void fromMsg(const gm::Type & m, Stamped<Data> & out) \
  { \
    out.stamp_ = time_of(m.header); \
    out.frame_id_ = m.header.frame_id; \
    fromMsg(m.field, static_cast<Data &>(out)); \
  }
COURSEKIT_STAMPED_DATA(TransformStamped, transform, Transform)
COURSEKIT_STAMPED_DATA(PoseStamped, pose, Transform)
COURSEKIT_STAMPED_DATA(PointStamped, point, Vector3)
COURSEKIT_STAMPED_DATA(Vector3Stamped, vector, Vector3)
COURSEKIT_STAMPED_DATA(QuaternionStamped, quaternion, Quaternion)
inline gm::TransformStamped toMsg(const Stamped<Transform> & in)
{
  return gm::TransformStamped().set__header(header_of(in)).set__transform(toMsg(static_cast<const Transform &>(in)));
}
inline gm::QuaternionStamped toMsg(const Stamped<Quaternion> & in)
{
  return gm::QuaternionStamped().set__header(header_of(in)).set__quaternion(toMsg(static_cast<const Quaternion &>(in)));
}
inline gm::PoseStamped & toMsg(const Stamped<Transform> & in, gm::PoseStamped & m)
{
  m.header = header_of(in);
  toMsg(static_cast<const Transform &>(in), m.pose);
  return m;
}
inline gm::PointStamped & toMsg(const Stamped<Vector3> & in, gm::PointStamped & m)
{
  m.header = header_of(in);
  toMsg(static_cast<const Vector3 &>(in), m.point);
  return m;
}

// -- messages stay messages

template<class M, class = std::enable_if_t<coursekit::is_message<M>::value>>
M toMsg(const M & message) {return message;}
template<class M, class = std::enable_if_t<coursekit::is_message<M>::value>>
void fromMsg(const M & message, M & out) {out = message;}

// -- through a transform

inline void doTransform(const gm::Point & in, gm::Point & out, const gm::TransformStamped & transform)
{
  Transform t;
  Vector3 v;
  fromMsg(transform.transform, t);
  fromMsg(in, v);
  toMsg(t * v, out);
}
inline void doTransform(const gm::Vector3 & in, gm::Vector3 & out, const gm::TransformStamped & transform)
{
  Transform t;
  Vector3 v;
  fromMsg(transform.transform, t);
  fromMsg(in, v);
  out = toMsg(t.getBasis() * v);  // a direction is turned, not shifted
}
inline void doTransform(const gm::Quaternion & in, gm::Quaternion & out, const gm::TransformStamped & transform)
{
  Quaternion turn, q;
  fromMsg(transform.transform.rotation, turn);
  fromMsg(in, q);
  out = toMsg(turn * q);
}
inline void doTransform(const gm::Pose & in, gm::Pose & out, const gm::TransformStamped & transform)
{
  Transform t, pose;
  fromMsg(transform.transform, t);
  fromMsg(in, pose);
  toMsg(t * pose, out);
}
inline void doTransform(const gm::Transform & in, gm::Transform & out, const gm::TransformStamped & transform)
{
  Transform t, own;
  fromMsg(transform.transform, t);
  fromMsg(in, own);
  out = toMsg(t * own);
}
/// A covariance of place and direction, turned: both of its halves are.
inline std::array<double, 36> transformCovariance(const std::array<double, 36> & in, const Transform & transform)
{
  std::array<double, 36> out{};
  const Matrix3x3 & turn = transform.getBasis();
  for (int block = 0; block < 4; ++block) {
    int at = (block / 2) * 18 + (block % 2) * 3;
    Matrix3x3 part(
      in[at], in[at + 1], in[at + 2], in[at + 6], in[at + 7], in[at + 8], in[at + 12], in[at + 13], in[at + 14]);
    Matrix3x3 turned = turn * part * turn.transpose();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        out[at + row * 6 + column] = turned[row][column];
      }
    }
  }
  return out;
}
inline void doTransform(const gm::PoseWithCovariance & in, gm::PoseWithCovariance & out, const gm::TransformStamped & transform)
{
  Transform t;
  fromMsg(transform.transform, t);
  doTransform(in.pose, out.pose, transform);
  out.covariance = transformCovariance(in.covariance, t);
}
inline void doTransform(const gm::Wrench & in, gm::Wrench & out, const gm::TransformStamped & transform)
{
  Vector3 shift, force, torque;
  doTransform(in.force, out.force, transform);
  doTransform(in.torque, out.torque, transform);
  fromMsg(transform.transform.translation, shift);
  fromMsg(out.force, force);
  fromMsg(out.torque, torque);
  out.torque = toMsg(torque + shift.cross(force));  // a force turns what is beside it
}
inline void doTransform(const gm::Point32 & in, gm::Point32 & out, const gm::TransformStamped & transform)
{
  gm::Point point;
  doTransform(gm::Point().set__x(in.x).set__y(in.y).set__z(in.z), point, transform);
  out.x = static_cast<float>(point.x);
  out.y = static_cast<float>(point.y);
  out.z = static_cast<float>(point.z);
}
inline void doTransform(const gm::Polygon & in, gm::Polygon & out, const gm::TransformStamped & transform)
{
  gm::Polygon moved = in;
  for (auto & point : moved.points) {
    doTransform(gm::Point32(point), point, transform);
  }
  out = moved;
}
inline std::array<std::array<double, 6>, 6> getCovarianceMatrix(const gm::PoseWithCovarianceStamped & message)
{
  return covarianceRowMajorToNested(message.pose.covariance);
}
#define COURSEKIT_STAMPED(Type, field) \
  inline void doTransform(const gm::Type & in, gm::Type & out, const gm::TransformStamped & transform) \
  { \
    gm::Type moved = in; \
    doTransform(in.field, moved.field, transform); \
    moved.header.stamp = transform.header.stamp; \
    moved.header.frame_id = transform.header.frame_id; \
    out = moved; \
  } \
  inline TimePoint getTimestamp(const gm::Type & m) \
  { \
    return TimePoint(std::chrono::seconds(m.header.stamp.sec) + std::chrono::nanoseconds(m.header.stamp.nanosec)); \
  } \
  inline std::string getFrameId(const gm::Type & m) {return m.header.frame_id;}
COURSEKIT_STAMPED(PointStamped, point)
COURSEKIT_STAMPED(Vector3Stamped, vector)
COURSEKIT_STAMPED(QuaternionStamped, quaternion)
COURSEKIT_STAMPED(PoseStamped, pose)
COURSEKIT_STAMPED(TransformStamped, transform)
COURSEKIT_STAMPED(PoseWithCovarianceStamped, pose)
COURSEKIT_STAMPED(WrenchStamped, wrench)
COURSEKIT_STAMPED(PolygonStamped, polygon)

inline gm::PoseWithCovarianceStamped toMsg(const WithCovarianceStamped<Transform> & in)
{
  gm::PoseWithCovarianceStamped out;
  out.header = header_of(Stamped<Transform>(in, in.stamp_, in.frame_id_));
  out.pose.covariance = covarianceNestedToRowMajor(in.cov_mat_);
  toMsg(static_cast<const Transform &>(in), out.pose.pose);
  return out;
}
inline void fromMsg(const gm::PoseWithCovarianceStamped & in, WithCovarianceStamped<Transform> & out)
{
  out.stamp_ = getTimestamp(in);
  out.frame_id_ = in.header.frame_id;
  out.cov_mat_ = getCovarianceMatrix(in);
  fromMsg(in.pose.pose, static_cast<Transform &>(out));
}
}  // namespace tf2
