// Behaviours and tasks at waypoints: behavior_server and waypoint_follower ask, their classes do.
#include "coursekit/nav2.hpp"
#include "coursekit/plugins.hpp"
#include "nav2_core/behavior.hpp"
#include "nav2_core/waypoint_task_executor.hpp"
#include "tf2/utils.h"

namespace nav2_costmap_2d
{
// -- what others publish

CostmapSubscriber::CostmapSubscriber(rclcpp::NodeFace & node, const std::string & topic_name)
{
  subscription_ = node.create_subscription<nav2_msgs::msg::Costmap>(
    topic_name, rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable(),
    [this](nav2_msgs::msg::Costmap::SharedPtr message) {
      std::lock_guard<std::mutex> hold(lock_);
      heard_ = message;
    });
}
std::shared_ptr<Costmap2D> CostmapSubscriber::getCostmap()
{
  std::lock_guard<std::mutex> hold(lock_);
  if (heard_) {
    const auto & about = heard_->metadata;
    costmap_ = std::make_shared<Costmap2D>(
      about.size_x, about.size_y, about.resolution, about.origin.position.x, about.origin.position.y);
    std::copy(heard_->data.begin(), heard_->data.end(), costmap_->getCharMap());
    heard_.reset();
  }
  if (!costmap_) {
    throw std::runtime_error("Costmap is not available");
  }
  return costmap_;
}

FootprintSubscriber::FootprintSubscriber(
  rclcpp::NodeFace & node, const std::string & topic_name, tf2_ros::Buffer & tf, std::string robot_base_frame,
  double transform_tolerance)
: tf_(tf), robot_base_frame_(std::move(robot_base_frame)), transform_tolerance_(transform_tolerance)
{
  subscription_ = node.create_subscription<geometry_msgs::msg::PolygonStamped>(
    topic_name, rclcpp::SystemDefaultsQoS(), [this](geometry_msgs::msg::PolygonStamped::SharedPtr message) {
      std::lock_guard<std::mutex> hold(lock_);
      footprint_ = message;
    });
}
bool FootprintSubscriber::getFootprintRaw(
  std::vector<geometry_msgs::msg::Point> & footprint, std_msgs::msg::Header & footprint_header)
{
  std::lock_guard<std::mutex> hold(lock_);
  if (!footprint_) {
    return false;
  }
  footprint = toPointVector(std::make_shared<geometry_msgs::msg::Polygon>(footprint_->polygon));
  footprint_header = footprint_->header;
  return true;
}
bool FootprintSubscriber::getFootprintInRobotFrame(
  std::vector<geometry_msgs::msg::Point> & footprint, std_msgs::msg::Header & footprint_header)
{
  geometry_msgs::msg::PoseStamped robot;
  if (!getFootprintRaw(footprint, footprint_header) ||
    !nav2_util::getCurrentPose(
      robot, tf_, footprint_header.frame_id, robot_base_frame_, transform_tolerance_, footprint_header.stamp))
  {
    return false;
  }
  const double yaw = tf2::getYaw(robot.pose.orientation);
  const double x = robot.pose.position.x, y = robot.pose.position.y;
  std::vector<geometry_msgs::msg::Point> about_map;
  transformFootprint(0.0, 0.0, -yaw, footprint, about_map);
  const double c = std::cos(yaw), s = std::sin(yaw);
  for (auto & corner : about_map) {
    corner.x -= c * x + s * y;
    corner.y -= c * y - s * x;
  }
  footprint = about_map;
  footprint_header.frame_id = robot_base_frame_;
  return true;
}

// -- collisions

bool CostmapTopicCollisionChecker::isCollisionFree(
  const geometry_msgs::msg::Pose2D & pose, bool fetch_costmap_and_footprint)
{
  const rclcpp::Logger log = rclcpp::get_logger(name_);
  try {
    return scorePose(pose, fetch_costmap_and_footprint) < LETHAL_OBSTACLE;
  } catch (const CollisionCheckerException & error) {
    RCLCPP_ERROR(log, "%s", error.what());
  } catch (...) {
    RCLCPP_ERROR(log, "Failed to check pose score!");
  }
  return false;
}
double CostmapTopicCollisionChecker::scorePose(const geometry_msgs::msg::Pose2D & pose, bool fetch_costmap_and_footprint)
{
  if (fetch_costmap_and_footprint) {
    try {
      collision_checker_.setCostmap(costmap_sub_.getCostmap());
    } catch (const std::runtime_error & error) {
      throw CollisionCheckerException(error.what());
    }
    std_msgs::msg::Header header;
    if (!footprint_sub_.getFootprintInRobotFrame(footprint_, header)) {
      throw CollisionCheckerException("Current footprint not available.");
    }
  }
  unsigned int x, y;
  if (!collision_checker_.worldToMap(pose.x, pose.y, x, y)) {
    RCLCPP_DEBUG(rclcpp::get_logger(name_), "Map Cell: [%d, %d]", x, y);
    throw CollisionCheckerException("Pose Goes Off Grid.");
  }
  return collision_checker_.footprintCostAtPose(pose.x, pose.y, pose.theta, footprint_);
}
}  // namespace nav2_costmap_2d

namespace nav2_core
{
using coursekit::Packer;
using coursekit::Unpacker;

namespace
{
/// A behaviour, and what tells it of collisions.
struct BehaviorHost : coursekit::Nav2Plugin<Behavior>
{
  using Nav2Plugin::Nav2Plugin;
  void configure(Unpacker & from)
  {
    meet_and_listen(from);
    auto checker = std::make_shared<nav2_costmap_2d::CostmapTopicCollisionChecker>(
      *heard_costs, *heard_outline, node->get_name());
    plugin->configure(node, name, buffer, checker);
  }
};
void serve(BehaviorHost & host, Unpacker & from)
{
  const std::string what = from.s();
  if (what == "configure") {
    host.configure(from);
  } else {
    host.change(what);
  }
}
void serve(coursekit::Nav2Plugin<WaypointTaskExecutor> & host, Unpacker & from, Packer & done)
{
  const std::string what = from.s();
  if (what == "make") {
    host.make();
  } else if (what == "configure") {
    host.meet_node(from);
    host.plugin->initialize(host.node, host.name);
  } else if (what == "process") {
    const auto pose = from.m<geometry_msgs::msg::PoseStamped>();
    done.i(host.plugin->processAtWaypoint(pose, static_cast<int>(from.i())));
  }
}
}  // namespace
}  // namespace nav2_core

coursekit::Handler coursekit::behavior_of(const std::string & type)
{
  auto host = std::make_shared<nav2_core::BehaviorHost>(type);
  return [host](Unpacker & from, Packer & to) {careful(to, [&](Packer &) {nav2_core::serve(*host, from);});};
}
coursekit::Handler coursekit::waypoint_task_of(const std::string & type)
{
  auto host = std::make_shared<Nav2Plugin<nav2_core::WaypointTaskExecutor>>(type);
  return [host](Unpacker & from, Packer & to) {careful(to, [&](Packer & done) {nav2_core::serve(*host, from, done);});};
}
