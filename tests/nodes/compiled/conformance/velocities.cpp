// How fast a frame moves, from the transforms of its last seconds.
#include "check.hpp"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"

using geometry_msgs::msg::VelocityStamped;

static const double SPEED = 0.5, TURN = 0.25;

static tf2::TimePoint at(double seconds) {return tf2::timeFromSec(seconds);}
static void put(tf2_ros::Buffer & buffer, const char * parent, const char * child, double seconds, const tf2::Transform & where)
{
  geometry_msgs::msg::TransformStamped transform;
  transform.header.stamp = tf2_ros::toMsg(at(seconds));
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform = tf2::toMsg(where);
  buffer.setTransform(transform, "test");
}
static bool is(const geometry_msgs::msg::Vector3 & got, double x, double y, double z)
{
  return std::abs(got.x - x) < 1e-6 && std::abs(got.y - y) < 1e-6 && std::abs(got.z - z) < 1e-6;
}
/// A cart that drives along y, a plate that turns, and a mast that stands a metre before both.
static void fill(tf2_ros::Buffer & buffer)
{
  tf2::Quaternion straight(0, 0, 0, 1);
  for (double t = 1; t < 6; t += 0.125) {
    tf2::Quaternion turned;
    turned.setRPY(0, 0, TURN * t);
    put(buffer, "hall", "cart", t, tf2::Transform(straight, tf2::Vector3(0, SPEED * t, 0)));
    put(buffer, "hall", "plate", t, tf2::Transform(turned, tf2::Vector3(0, 0, 0)));
    put(buffer, "hall", "mast", t, tf2::Transform(straight, tf2::Vector3(1, 0, 0)));
  }
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  tf2_ros::Buffer buffer(std::make_shared<rclcpp::Clock>());
  fill(buffer);
  VelocityStamped drives = buffer.lookupVelocity("cart", "hall", at(3), 250ms);
  check("a frame drives", is(drives.velocity.linear, 0, SPEED, 0) && is(drives.velocity.angular, 0, 0, 0));
  check("it says of what and as seen from where", drives.body_frame_id == "cart" && drives.header.frame_id == "hall");
  check("the time is in the middle", drives.header.stamp == builtin_interfaces::msg::Time(tf2_ros::toMsg(at(3))));
  VelocityStamped turns = buffer.lookupVelocity("plate", "hall", at(3), 250ms);
  check("a frame turns", is(turns.velocity.angular, 0, 0, TURN) && is(turns.velocity.linear, 0, 0, 0));
  VelocityStamped beside = buffer.lookupVelocity("plate", "mast", at(3), 250ms);
  check("seen from beside, it also shifts", is(beside.velocity.angular, 0, 0, TURN) && is(beside.velocity.linear, 0, TURN, 0));
  VelocityStamped late = buffer.lookupVelocity("cart", "hall", at(5.8), 250ms);
  check("near the last transform it is the speed before", is(late.velocity.linear, 0, SPEED, 0));
  VelocityStamped given = buffer.lookupVelocity("cart", "hall", "mast", tf2::Vector3(0, 0, 0), "cart", at(3), 250ms);
  check("along another frame's axes", is(given.velocity.linear, 0, SPEED, 0) && given.header.frame_id == "mast");
  throws<tf2::LookupException>("of no frame", [&] {buffer.lookupVelocity("moon", "hall", at(3), 250ms);});
  throws<tf2::ExtrapolationException>("after the last transform", [&] {buffer.lookupVelocity("cart", "hall", at(9), 250ms);});
  throws<tf2::ExtrapolationException>("before the first transform", [&] {buffer.lookupVelocity("cart", "hall", at(0.5), 250ms);});
  rclcpp::shutdown();
}
