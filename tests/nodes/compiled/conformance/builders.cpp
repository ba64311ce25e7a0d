// Builders of messages: each field in its turn, and none forgotten.
#include "action_msgs/msg/goal_info.hpp"
#include "check.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "geometry_msgs/msg/detail/point__builder.hpp"
#include "geometry_msgs/msg/detail/twist__struct.hpp"
#include "geometry_msgs/msg/detail/twist__traits.hpp"
#include "geometry_msgs/msg/pose_with_covariance.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "std_msgs/msg/empty.hpp"
#include "std_msgs/msg/string.hpp"

using geometry_msgs::msg::Point;

/// Whether a step has a function for `y`.
template<class T, class = void>
constexpr bool has_y = false;
template<class T>
constexpr bool has_y<T, std::void_t<decltype(std::declval<T>().y(1.0))>> = true;

int main()
{
  auto point = geometry_msgs::build<Point>().x(1).y(2).z(3);
  static_assert(std::is_same_v<decltype(point), Point>);
  check("a point", point.x == 1 && point.y == 2 && point.z == 3);
  auto begun = geometry_msgs::build<Point>();
  check("in the order of the fields", !has_y<decltype(begun)> && has_y<decltype(begun.x(1))>);
  check("the steps have rosidl's names", std::is_same_v<decltype(begun), geometry_msgs::msg::builder::Init_Point_x>);
  equal("a single field", std_msgs::build<std_msgs::msg::String>().data("text").data, "text");
  check("none at all", std_msgs::build<std_msgs::msg::Empty>() == std_msgs::msg::Empty());
  auto orientation = geometry_msgs::build<geometry_msgs::msg::Quaternion>().x(0).y(0).z(0).w(1);
  auto pose = geometry_msgs::build<geometry_msgs::msg::Pose>().position(point).orientation(orientation);
  std::array<double, 36> covariance{};
  covariance[35] = 7;
  auto guess = geometry_msgs::build<geometry_msgs::msg::PoseWithCovariance>().pose(pose).covariance(covariance);
  check("messages within messages", guess.pose.position.z == 3 && guess.covariance[35] == 7);
  auto joints = sensor_msgs::build<sensor_msgs::msg::JointState>()
    .header(std_msgs::build<std_msgs::msg::Header>().stamp(builtin_interfaces::msg::Time()).frame_id("arm"))
    .name({"shoulder", "elbow"}).position({0.5, 1.5}).velocity({}).effort({});
  check("lists", joints.name[1] == "elbow" && joints.position[0] == 0.5 && joints.header.frame_id == "arm");
  auto request = example_interfaces::build<example_interfaces::srv::AddTwoInts::Request>().a(3).b(4);
  equal("requests", request.b, 4);
  equal("goals", example_interfaces::build<example_interfaces::action::Fibonacci::Goal>().order(5).order, 5);
  check("twists by rosidl's inner headers", geometry_msgs::msg::Twist().linear.x == 0);
}
