// The costmap of a server as its plugins see it, and layers for it: the server asks, their classes do.
#include "coursekit/nav2.hpp"
#include "coursekit/plugins.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_costmap_2d/inflation_layer.hpp"
#include "nav2_costmap_2d/layer.hpp"
#include "tf2/utils.h"

namespace nav2_costmap_2d
{
using coursekit::Packer;
using coursekit::Unpacker;
using geometry_msgs::msg::Point;

Costmap2DROS::Costmap2DROS(rclcpp::SharedNode node, std::shared_ptr<tf2_ros::Buffer> tf)
: nav2_util::LifecycleNode(node), tf_buffer_(std::move(tf)), global_frame_(get_parameter("global_frame").as_string()),
  robot_base_frame_(get_parameter("robot_base_frame").as_string()), transform_tolerance_(number("transform_tolerance")),
  layered_costmap_(std::make_unique<LayeredCostmap>(
      global_frame_, get_parameter("rolling_window").as_bool(), get_parameter("track_unknown_space").as_bool())) {}

namespace
{
/// Stands for a layer of the server, which does that layer's work.
struct LayerElsewhere : Layer
{
  void onInitialize() override {current_ = enabled_ = true;}
  void reset() override {}
  bool isClearable() override {return false;}
  void updateBounds(double, double, double, double *, double *, double *, double *) override {}
  void updateCosts(Costmap2D &, int, int, int, int) override {}
};
}  // namespace

void Costmap2DROS::meet_layers()
{
  const std::vector<std::string> names = get_parameter("plugins").as_string_array();
  for (const std::string & layer : names) {
    const bool inflates = get_parameter(layer + ".plugin").as_string() == "nav2_costmap_2d::InflationLayer";
    std::shared_ptr<Layer> made =
      inflates ? std::make_shared<InflationLayer>() : std::shared_ptr<Layer>(std::make_shared<LayerElsewhere>());
    layered_costmap_->addPlugin(made);
    made->initialize(
      layered_costmap_.get(), layer, tf_buffer_.get(), shared_from_this(),
      get_node_base_interface()->get_default_callback_group());
  }
}

double Costmap2DROS::number(const std::string & parameter)
{
  const rclcpp::Parameter found = get_parameter(parameter);  // 1 counts as 1.0
  return found.get_type() == rclcpp::PARAMETER_INTEGER ? static_cast<double>(found.as_int()) : found.as_double();
}
bool Costmap2DROS::getRobotPose(geometry_msgs::msg::PoseStamped & global_pose)
{
  return nav2_util::getCurrentPose(global_pose, *tf_buffer_, global_frame_, robot_base_frame_, transform_tolerance_);
}
bool Costmap2DROS::transformPoseToGlobalFrame(
  const geometry_msgs::msg::PoseStamped & input_pose, geometry_msgs::msg::PoseStamped & transformed_pose)
{
  if (input_pose.header.frame_id == global_frame_) {
    transformed_pose = input_pose;
    return true;
  }
  return nav2_util::transformPoseInTargetFrame(
    input_pose, transformed_pose, *tf_buffer_, global_frame_, transform_tolerance_);
}
bool Costmap2DROS::getUseRadius()
{
  const std::string told = get_parameter("footprint").as_string();
  return told.empty() || told == "[]";
}
double Costmap2DROS::getRobotRadius() {return number("robot_radius");}
std::vector<Point> Costmap2DROS::getUnpaddedRobotFootprint()
{
  std::vector<Point> told;
  const bool drawn = !getUseRadius() && makeFootprintFromString(get_parameter("footprint").as_string(), told);
  return drawn ? told : makeFootprintFromRadius(getRobotRadius());
}
void Costmap2DROS::getOrientedFootprint(std::vector<Point> & oriented_footprint)
{
  geometry_msgs::msg::PoseStamped here;
  if (getRobotPose(here)) {
    const double yaw = tf2::getYaw(here.pose.orientation);
    transformFootprint(here.pose.position.x, here.pose.position.y, yaw, getRobotFootprint(), oriented_footprint);
  }
}
void Costmap2DROS::renew(coursekit::Unpacker & from)
{
  const double resolution = from.d(), x = from.d(), y = from.d();
  const auto high = static_cast<unsigned int>(from.i()), wide = static_cast<unsigned int>(from.i());
  const std::string cells = from.s();
  std::vector<Point> outline(static_cast<size_t>(from.i()));
  for (auto & corner : outline) {
    corner.x = from.d();
    corner.y = from.d();
  }
  Costmap2D & costs = *getCostmap();
  std::lock_guard<Costmap2D::mutex_t> hold(*costs.getMutex());
  const bool same_size = costs.getSizeInCellsX() == wide && costs.getSizeInCellsY() == high &&
    costs.getResolution() == resolution;
  const bool moved = costs.getOriginX() != x || costs.getOriginY() != y;
  if (!same_size || (moved && !layered_costmap_->isRolling())) {
    layered_costmap_->resizeMap(wide, high, resolution, x, y, layered_costmap_->isRolling());
  } else if (moved) {
    costs.origin_x_ = x;
    costs.origin_y_ = y;
  }
  std::copy(cells.begin(), cells.end(), reinterpret_cast<char *>(costs.getCharMap()));
  layered_costmap_->setFootprint(outline);
}

// -- a layer

namespace
{
/// A layer of the program's own classes, on a copy of the server's costs.
struct LayerHost : coursekit::Nav2Server
{
  std::shared_ptr<Layer> layer;

  LayeredCostmap & all() {return *costmap->getLayeredCostmap();}
  void make(const std::string & type)
  {
    class_loader::ClassLoader own("");
    layer.reset(own.createUnmanagedInstance<Layer>(type));
  }
  void initialize(Unpacker & from)
  {
    meet_costmap(from);
    all().addPlugin(layer);
    layer->initialize(&all(), name, buffer.get(), costmap, costmap->get_node_base_interface()->get_default_callback_group());
    layer->onFootprintChanged();  // the robot's has just been set
  }
  void update(Unpacker & from, Packer & to)
  {
    costmap->renew(from);
    const double x = from.d(), y = from.d(), yaw = from.d();
    all().updateMap(x, y, yaw);
    const Costmap2D & costs = *costmap->getCostmap();
    const auto size = static_cast<size_t>(costs.getSizeInCellsX()) * costs.getSizeInCellsY();
    to.s(std::string(reinterpret_cast<const char *>(costs.getCharMap()), size));
  }
};

void change(LayerHost & host, const std::string & what, const std::string & type, Unpacker & from)
{
  if (what == "make") {
    host.make(type);
  } else if (what == "configure") {
    host.initialize(from);
  } else if (what == "activate") {
    host.layer->activate();
  } else if (what == "deactivate") {
    host.layer->deactivate();
  } else if (what == "reset") {
    host.layer->reset();
  }
}
void serve(LayerHost & host, const std::string & type, Unpacker & from, Packer & to)
{
  const std::string what = from.s();
  if (what == "update") {
    host.update(from, to);
  } else {
    coursekit::careful(to, [&](Packer &) {change(host, what, type, from);});
  }
}
}  // namespace
}  // namespace nav2_costmap_2d

coursekit::Handler coursekit::layer_of(const std::string & type)
{
  auto host = std::make_shared<nav2_costmap_2d::LayerHost>();
  return [host, type](Unpacker & from, Packer & to) {nav2_costmap_2d::serve(*host, type, from, to);};
}
