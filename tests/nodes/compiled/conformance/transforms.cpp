#include "check.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "message_filters/subscriber.h"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_msgs/msg/string.hpp"
#include "tf2/LinearMath/Matrix3x3.h"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Transform.h"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/message_filter.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"

using geometry_msgs::msg::PointStamped;
using geometry_msgs::msg::TransformStamped;

static bool near(double a, double b) {return std::abs(a - b) < 1e-6;}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  tf2::Quaternion turn;
  turn.setRPY(0, 0, M_PI / 2);
  check("a quarter turn", near(turn.z(), std::sqrt(0.5)) && near(turn.w(), std::sqrt(0.5)));
  double roll, pitch, yaw;
  tf2::Matrix3x3(turn).getRPY(roll, pitch, yaw);
  check("and back", near(yaw, M_PI / 2) && near(roll, 0) && near(pitch, 0));
  auto turned = tf2::quatRotate(turn, tf2::Vector3(1, 0, 0));
  check("a vector is turned", near(turned.x(), 0) && near(turned.y(), 1));
  check("angle", near(turn.getAngle(), M_PI / 2));
  check("a turn and its inverse", near((turn * turn.inverse()).w(), 1));
  tf2::Transform move(turn, tf2::Vector3(1, 2, 3));
  auto moved = move * tf2::Vector3(1, 0, 0);
  check("a vector is moved", near(moved.x(), 1) && near(moved.y(), 3) && near(moved.z(), 3));
  check("moved back", near((move.inverse() * moved).x(), 1));
  check("half way", near(tf2::Quaternion::getIdentity().slerp(turn, 0.5).getAngle(), M_PI / 4));
  check("as message", near(tf2::toMsg(turn).z, turn.z()));

  auto node = rclcpp::Node::make_shared("transforms");
  tf2_ros::Buffer buffer(node->get_clock());
  tf2_ros::TransformListener listener(buffer);
  tf2_ros::StaticTransformBroadcaster fixed(node);
  tf2_ros::TransformBroadcaster broadcaster(node);
  throws<tf2::LookupException>("no such frame", [&] {buffer.lookupTransform("map", "lidar", tf2::TimePointZero);});
  throws<tf2::TransformException>("caught as any transform's", [&] {buffer.lookupTransform("map", "lidar", tf2::TimePointZero);});
  TransformStamped transform;
  transform.header.frame_id = "base";
  transform.child_frame_id = "lidar";
  transform.transform.translation.x = 1;
  transform.transform.rotation = tf2::toMsg(turn);
  fixed.sendTransform(transform);
  check("a static one comes", buffer.canTransform("base", "lidar", tf2::TimePointZero, 2s));
  auto found = buffer.lookupTransform("base", "lidar", tf2::TimePointZero);
  check("it is that", near(found.transform.translation.x, 1) && near(found.transform.rotation.z, turn.z()));
  auto inverse = buffer.lookupTransform("lidar", "base", tf2::TimePointZero);
  check("and its inverse", near(inverse.transform.translation.y, 1));
  PointStamped point, out;
  point.header.frame_id = "lidar";
  point.point.x = 2;
  buffer.transform(point, out, "base");
  check("a point is transformed", near(out.point.x, 1) && near(out.point.y, 2) && out.header.frame_id == "base");

  // a filter passes on what can be transformed
  message_filters::Subscriber<PointStamped> points(node, "points");
  tf2_ros::MessageFilter<PointStamped> filter(points, buffer, "map", 10, node, 500ms);
  std::vector<double> passed;
  int failed = 0;
  filter.registerCallback([&](const std::shared_ptr<const PointStamped> & m) {passed.push_back(m->point.x);});
  filter.registerFailureCallback([&](const auto &, tf2_ros::FilterFailureReason) {++failed;});
  auto publisher = node->create_publisher<PointStamped>("points", 10);
  point.header.stamp = node->now();
  publisher->publish(point);
  check("it waits for the transform", !spin_until(node, [&] {return !passed.empty();}, 100ms));
  transform.header.frame_id = "map";
  transform.child_frame_id = "base";
  transform.header.stamp = node->now() - rclcpp::Duration(1s);
  broadcaster.sendTransform(transform);
  transform.header.stamp = node->now() + rclcpp::Duration(1s);
  broadcaster.sendTransform(transform);
  check("and passes it on then", spin_until(node, [&] {return passed.size() == 1;}));
  publisher->publish(point);
  check("at once from then on", spin_until(node, [&] {return passed.size() == 2;}));
  point.header.frame_id = "nowhere";
  publisher->publish(point);
  check("what never can is dropped", spin_until(node, [&] {return failed == 1;}));
  point.header.frame_id = "";
  publisher->publish(point);
  check("what has no frame too", spin_until(node, [&] {return failed == 2;}));
  // it asks a message's header, not tf2's functions for what it transforms
  using sensor_msgs::msg::LaserScan;
  namespace traits = message_filters::message_traits;
  tf2_ros::MessageFilter<LaserScan> scans(buffer, "map", 10, node, 500ms);
  std::vector<float> farthest;
  scans.registerCallback([&](const LaserScan::ConstSharedPtr & scan) {farthest.push_back(scan->range_max);});
  auto scan = std::make_shared<LaserScan>();
  scan->header.stamp = node->now();
  check("what has a header tells its frame and time", traits::HasHeader<LaserScan>::value &&
    !traits::HasHeader<std_msgs::msg::String>::value && traits::FrameId<LaserScan>::value(*scan).empty() &&
    traits::TimeStamp<LaserScan>::value(*scan) == scan->header.stamp);
  *traits::FrameId<LaserScan>::pointer(*scan) = "base";
  scan->range_max = 8;
  scans.add(std::shared_ptr<const LaserScan>(scan));
  check("a scan is passed on, too", farthest == std::vector<float>{8});
  throws<tf2::ExtrapolationException>("too far ahead", [&] {
      buffer.lookupTransform("map", "base", node->now() + rclcpp::Duration(60s));
    });
  // a function is called when a transform has come
  std::string came;
  auto told = [&](const tf2_ros::TransformStampedFuture & future) {
      try {
        came = future.get().child_frame_id;
      } catch (const tf2::TimeoutException &) {
        came = "too late";
      }
    };
  throws<tf2_ros::CreateTimerInterfaceException>("it needs timers", [&] {
      buffer.waitForTransform("base", "hand", tf2::TimePointZero, 1s, told);
    });
  buffer.setCreateTimerInterface(
    std::make_shared<tf2_ros::CreateTimerROS>(node->get_node_base_interface(), node->get_node_timers_interface()));
  auto hand = buffer.waitForTransform("base", "hand", tf2::TimePointZero, 5s, told);
  check("not before it is there", !spin_until(node, [&] {return !came.empty();}, 100ms));
  transform.header.frame_id = "base";
  transform.child_frame_id = "hand";
  broadcaster.sendTransform(transform);
  check("but then", spin_until(node, [&] {return came == "hand";}) && hand.get().child_frame_id == "hand");
  buffer.waitForTransform("base", "foot", tf2::TimePointZero, 100ms, told);
  check("or when the time is over", spin_until(node, [&] {return came == "too late";}));
  tf2_ros::Buffer second(node->get_clock());
  tf2_ros::TransformListener with_options(
    second, node, true, tf2_ros::DynamicListenerQoS(), tf2_ros::StaticListenerQoS(), rclcpp::SubscriptionOptions(),
    rclcpp::SubscriptionOptions());
  tf2_ros::TransformBroadcaster sends(node->get_node_topics_interface(), rclcpp::QoS(10), rclcpp::PublisherOptions());
  tf2_ros::StaticTransformBroadcaster says(node, tf2_ros::StaticBroadcasterQoS(), rclcpp::PublisherOptions());
  transform.header.frame_id = "hand";
  transform.child_frame_id = "finger";
  sends.sendTransform(transform);
  transform.child_frame_id = "ring";
  says.sendTransform(transform);
  auto both = [&] {return second._frameExists("finger") && second._frameExists("ring");};
  check("options are given to all three", spin_until(node, both));
  message_filters::Subscriber<std_msgs::msg::String> words;
  words.subscribe(node, "words", rmw_qos_profile_default, rclcpp::SubscriptionOptions());
  check("a filter subscribes with options", words.getSubscriber() && words.getTopic() == "words");
  auto still = tf2::getTransformIdentity<tf2::Transform>();
  check("what moves nothing", near((still * tf2::Vector3(1, 2, 3)).z(), 3));
  check("in one go", near(buffer.lookupTransform("map", "lidar", tf2::TimePointZero).transform.translation.x, 1));
  rclcpp::shutdown();
}
