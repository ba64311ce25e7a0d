#include "check.hpp"
#include "tf2/buffer_core.h"
#include "tf2/transform_datatypes.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"
#include "tf2_sensor_msgs/tf2_sensor_msgs.hpp"

using geometry_msgs::msg::PoseWithCovarianceStamped;
using geometry_msgs::msg::TransformStamped;

static bool ends(const std::string & text, const std::string & with)
{
  return text.size() >= with.size() && text.compare(text.size() - with.size(), with.size(), with) == 0;
}
static bool near(double a, double b) {return std::abs(a - b) < 1e-6;}

struct Buoy
{
  double x = 0;
  builtin_interfaces::msg::Time stamp;
};
namespace tf2
{
template<>
TimePoint getTimestamp(const Buoy & buoy) {return tf2_ros::fromMsg(buoy.stamp);}
template<>
std::string getFrameId(const Buoy &) {return "lidar";}
template<>
void doTransform(const Buoy & in, Buoy & out, const TransformStamped & transform)
{
  out.x = in.x + transform.transform.translation.x;
}
}  // namespace tf2
/// What another library counts with.
struct Transport {double x;};
namespace tf2
{
geometry_msgs::msg::PointStamped toMsg(const Stamped<Transport> & in)
{
  geometry_msgs::msg::PointStamped out;
  out.header.frame_id = in.frame_id_;
  out.point.x = in.x;
  return out;
}
}  // namespace tf2

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("buffers");
  tf2::BufferCore core;
  tf2_ros::TransformListener listener(core);
  tf2_ros::StaticTransformBroadcaster fixed(node);
  throws<tf2::LookupException>("a core does not wait", [&] {core.lookupTransform("base", "lidar", tf2::TimePointZero);});
  std::string why;
  check("nor can it", !core.canTransform("base", "lidar", tf2::TimePointZero, &why) && !why.empty());
  TransformStamped transform;
  transform.header.frame_id = "base";
  transform.child_frame_id = "lidar";
  transform.transform.translation.x = 1;
  transform.transform.rotation.z = transform.transform.rotation.w = std::sqrt(0.5);  // a quarter turn
  fixed.sendTransform(transform);
  check("a listener fills it", spin_until(node, [&] {return core.canTransform("base", "lidar", tf2::TimePointZero);}));
  check("frames are known", core._frameExists("lidar") && !core._frameExists("moon"));
  check("it is found", near(core.lookupTransform("base", "lidar", tf2::TimePointZero).transform.translation.x, 1));

  tf2::Stamped<tf2::Transform> stamped;
  transform.header.stamp.sec = 5;
  transform.header.stamp.nanosec = 7;
  tf2::fromMsg(transform, stamped);
  check("a transform with its time and frame", stamped.frame_id_ == "base" && near(stamped.getOrigin().x(), 1));
  equal("its time", stamped.stamp_.time_since_epoch().count(), 5000000007);
  auto back = tf2::toMsg(stamped);
  check("and back", back.header == transform.header && near(back.transform.rotation.z, std::sqrt(0.5)));
  equal("none yet", tf2::Stamped<tf2::Vector3>().frame_id_, "NO_ID_STAMPED_DEFAULT_CONSTRUCTION");
  tf2::Stamped<tf2::Vector3> place(tf2::Vector3(1, 2, 3), tf2::TimePointZero, "base");
  geometry_msgs::msg::PointStamped point;
  tf2::toMsg(place, point);
  check("a point with its frame", point.header.frame_id == "base" && near(point.point.z, 3));

  throws<std::invalid_argument>("a buffer needs a clock", [] {tf2_ros::Buffer(nullptr);});
  tf2_ros::Buffer buffer(node->get_clock());
  check("a transform is taken", buffer.setTransform(transform, "test", true));
  auto itself = transform;
  itself.header.frame_id = itself.child_frame_id;
  check("one from a frame to itself is not", !buffer.setTransform(itself, "test"));
  tf2::BufferCore & base = buffer;
  check("a buffer is a core", base.canTransform("base", "lidar", tf2::TimePointZero));
  PoseWithCovarianceStamped pose, turned;
  pose.header.frame_id = "lidar";
  pose.pose.pose.orientation.w = 1;
  pose.pose.covariance[0] = 4;
  pose.pose.covariance[21] = 9;
  buffer.transform(pose, turned, "base");
  check("a covariance is turned", near(turned.pose.covariance[7], 4) && near(turned.pose.covariance[0], 0));
  check("in both halves", near(turned.pose.covariance[28], 9) && near(turned.pose.pose.position.x, 1));
  sensor_msgs::msg::PointCloud2 cloud, moved;
  cloud.header.frame_id = "lidar";
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(1);
  *sensor_msgs::PointCloud2Iterator<float>(cloud, "x") = 2;
  buffer.transform(cloud, moved, "base");
  sensor_msgs::PointCloud2ConstIterator<float> at(moved, "x");
  check("a cloud is transformed", near(at[0], 1) && near(at[1], 2) && moved.header.frame_id == "base");
  const std::string alone = "Do not call canTransform or lookupTransform with a timeout unless";
  check("nobody fills it meanwhile", !buffer.canTransform("base", "moon", tf2::TimePointZero, 1h, &why) && why.rfind(alone, 0) == 0);
  throws<tf2::LookupException>("so nobody waits", [&] {buffer.lookupTransform("base", "moon", tf2::TimePointZero, 1h);});
  check("without a time it is only looked up", buffer.canTransform("base", "lidar", tf2::TimePointZero, 0s));
  tf2_ros::TransformListener no_thread(buffer, node, false);
  check("a listener in the node's thread", !buffer.isUsingDedicatedThread());
  tf2_ros::TransformListener own_thread(buffer, node);
  check("a listener in a thread of its own", buffer.isUsingDedicatedThread());
  check("a buffer waits", !buffer.canTransform("base", "moon", tf2::TimePointZero, 20ms, &why));
  const std::string unknown = "Invalid frame ID \"moon\" passed to canTransform argument source_frame - frame does not exist";
  check("and says how long", why.rfind(unknown + ". canTransform returned after 0.0", 0) == 0 && ends(why, " timeout was 0.02."), why);
  buffer.canTransform("base", rclcpp::Time(), "moon", rclcpp::Time(), "base", 20ms, &why);
  check("also between two times", why.find(". canTransform returned after 0.0") != why.npos && ends(why, " timeout was 0.02."), why);
  core.canTransform("base", "moon", tf2::TimePointZero, &why);
  equal("a core does not", why, unknown);
  tf2::Stamped<Transport> carried(Transport{3}, tf2::TimePointZero, "base");
  tf2::Stamped<tf2::Vector3> arrived;
  tf2::convert(carried, arrived);
  check("by a message from one type to another", near(arrived.x(), 3) && arrived.frame_id_ == "base");
  equal("a type of one's own", buffer.transform(Buoy{2, {}}, "base").x, 3.0);
  rclcpp::shutdown();
}
