// What nav2's nodes and plugins share: names, parameters, poses, velocities.
#include <cctype>
#include <cmath>
#include <random>

#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/odometry_utils.hpp"
#include "nav2_util/robot_utils.hpp"

namespace nav2_util
{
// -- names

std::string sanitize_node_name(const std::string & potential_node_name)
{
  std::string name = potential_node_name;
  for (char & one : name) {
    one = std::isalnum(static_cast<unsigned char>(one)) ? one : '_';
  }
  return name;
}
std::string add_namespaces(const std::string & top_ns, const std::string & sub_ns)
{
  return !top_ns.empty() && top_ns.back() == '/' ? top_ns + sub_ns : top_ns + "/" + sub_ns;
}
std::string time_to_string(size_t len)
{
  static std::random_device entropy;
  std::string digits;
  while (digits.size() < len) {
    digits += static_cast<char>('0' + entropy() % 10);
  }
  return digits;
}
std::string generate_internal_node_name(const std::string & prefix)
{
  return sanitize_node_name(prefix) + "_" + time_to_string(8);
}
rclcpp::Node::SharedPtr generate_internal_node(const std::string & prefix)
{
  rclcpp::NodeOptions options;
  options.start_parameter_services(false).start_parameter_event_publisher(false);
  options.arguments({"--ros-args", "-r", "__node:=" + generate_internal_node_name(prefix), "--"});
  return rclcpp::Node::make_shared("_", options);
}

// -- managed nodes

LifecycleNode::LifecycleNode(const std::string & node_name, const std::string & ns, const rclcpp::NodeOptions & options)
: rclcpp_lifecycle::LifecycleNode(node_name, ns, options)
{
  declare_parameter_if_not_declared(this, "bond_heartbeat_period", rclcpp::ParameterValue(0.1));
  printLifecycleNodeNotification();
}
LifecycleNode::~LifecycleNode() = default;

static rcl_interfaces::msg::ParameterDescriptor descriptor(
  const std::string & name, const rclcpp::ParameterValue & value, const std::string & description,
  const std::string & constraints, bool read_only)
{
  rcl_interfaces::msg::ParameterDescriptor made;
  made.name = name;
  made.type = static_cast<uint8_t>(value.get_type());
  made.description = description;
  made.additional_constraints = constraints;
  made.read_only = read_only;
  return made;
}
template<class Ranges, class Given>
static void set_range(Ranges & ranges, const Given & given)
{
  ranges.resize(1);
  ranges[0].from_value = given.from_value;
  ranges[0].to_value = given.to_value;
  ranges[0].step = static_cast<decltype(ranges[0].step)>(given.step);
}
void LifecycleNode::add_parameter(
  const std::string & name, const rclcpp::ParameterValue & default_value, const std::string & description,
  const std::string & additional_constraints, bool read_only)
{
  declare_parameter(name, default_value, descriptor(name, default_value, description, additional_constraints, read_only));
}
void LifecycleNode::add_parameter(
  const std::string & name, const rclcpp::ParameterValue & default_value, const floating_point_range fp_range,
  const std::string & description, const std::string & additional_constraints, bool read_only)
{
  auto made = descriptor(name, default_value, description, additional_constraints, read_only);
  set_range(made.floating_point_range, fp_range);
  declare_parameter(name, default_value, made);
}
void LifecycleNode::add_parameter(
  const std::string & name, const rclcpp::ParameterValue & default_value, const integer_range int_range,
  const std::string & description, const std::string & additional_constraints, bool read_only)
{
  auto made = descriptor(name, default_value, description, additional_constraints, read_only);
  set_range(made.integer_range, int_range);
  declare_parameter(name, default_value, made);
}
CallbackReturn LifecycleNode::on_error(const rclcpp_lifecycle::State &)
{
  RCLCPP_FATAL(get_logger(), "Lifecycle node %s does not have error state implemented", get_name());
  return CallbackReturn::SUCCESS;
}
void LifecycleNode::printLifecycleNodeNotification()
{
  RCLCPP_INFO(
    get_logger(), "\n\t%s lifecycle node launched. \n\tWaiting on external lifecycle transitions to activate\n\t"
    "See https://design.ros2.org/articles/node_lifecycle.html for more information.", get_name());
}

// -- poses and transforms

static rclcpp::Logger logger(const char * function) {return rclcpp::get_logger(function);}

bool getCurrentPose(
  geometry_msgs::msg::PoseStamped & global_pose, tf2_ros::Buffer & tf_buffer, const std::string global_frame,
  const std::string robot_frame, const double transform_timeout, const rclcpp::Time stamp)
{
  geometry_msgs::msg::PoseStamped origin;
  tf2::toMsg(tf2::Transform::getIdentity(), origin.pose);
  origin.header.frame_id = robot_frame;
  origin.header.stamp = stamp;
  return transformPoseInTargetFrame(origin, global_pose, tf_buffer, global_frame, transform_timeout);
}
bool transformPoseInTargetFrame(
  const geometry_msgs::msg::PoseStamped & input_pose, geometry_msgs::msg::PoseStamped & transformed_pose,
  tf2_ros::Buffer & tf_buffer, const std::string target_frame, const double transform_timeout)
{
  const rclcpp::Logger log = logger("transformPoseInTargetFrame");
  try {
    transformed_pose = tf_buffer.transform(input_pose, target_frame, tf2::durationFromSec(transform_timeout));
    return true;
  } catch (const tf2::LookupException & error) {
    RCLCPP_ERROR(log, "No Transform available Error looking up target frame: %s\n", error.what());
  } catch (const tf2::ConnectivityException & error) {
    RCLCPP_ERROR(log, "Connectivity Error looking up target frame: %s\n", error.what());
  } catch (const tf2::ExtrapolationException & error) {
    RCLCPP_ERROR(log, "Extrapolation Error looking up target frame: %s\n", error.what());
  } catch (const tf2::TimeoutException &) {
    RCLCPP_ERROR(log, "Transform timeout with tolerance: %.4f", transform_timeout);
  } catch (const tf2::TransformException &) {
    RCLCPP_ERROR(
      log, "Failed to transform from %s to %s", input_pose.header.frame_id.c_str(), target_frame.c_str());
  }
  return false;
}
bool getTransform(
  const std::string & source_frame_id, const std::string & target_frame_id, const tf2::Duration & transform_tolerance,
  const std::shared_ptr<tf2_ros::Buffer> tf_buffer, tf2::Transform & transform_msg)
{
  transform_msg.setIdentity();
  if (source_frame_id == target_frame_id) {
    return true;
  }
  try {
    auto found = tf_buffer->lookupTransform(target_frame_id, source_frame_id, tf2::TimePointZero, transform_tolerance);
    tf2::fromMsg(found.transform, transform_msg);
    return true;
  } catch (const tf2::TransformException & error) {
    RCLCPP_ERROR(
      logger("getTransform"), "Failed to get \"%s\"->\"%s\" frame transform: %s", source_frame_id.c_str(),
      target_frame_id.c_str(), error.what());
    return false;
  }
}
bool getTransform(
  const std::string & source_frame_id, const rclcpp::Time & source_time, const std::string & target_frame_id,
  const rclcpp::Time & target_time, const std::string & fixed_frame_id, const tf2::Duration & transform_tolerance,
  const std::shared_ptr<tf2_ros::Buffer> tf_buffer, tf2::Transform & transform_msg)
{
  transform_msg.setIdentity();
  try {
    auto found = tf_buffer->lookupTransform(
      target_frame_id, tf2_ros::fromRclcpp(target_time), source_frame_id, tf2_ros::fromRclcpp(source_time), fixed_frame_id,
      transform_tolerance);
    tf2::fromMsg(found.transform, transform_msg);
    return true;
  } catch (const tf2::TransformException & error) {
    RCLCPP_ERROR(
      logger("getTransform"), "Failed to get \"%s\"->\"%s\" frame transform: %s", source_frame_id.c_str(),
      target_frame_id.c_str(), error.what());
    return false;
  }
}
bool validateTwist(const geometry_msgs::msg::Twist & msg)
{
  auto finite = [](const geometry_msgs::msg::Vector3 & one) {
      return std::isfinite(one.x) && std::isfinite(one.y) && std::isfinite(one.z);
    };
  return finite(msg.linear) && finite(msg.angular);
}

// -- odometry

OdomSmoother::OdomSmoother(rclcpp::NodeFace & node, double filter_duration, const std::string & odom_topic)
: span_(rclcpp::Duration::from_seconds(filter_duration))
{
  subscription_ = node.create_subscription<nav_msgs::msg::Odometry>(
    odom_topic, rclcpp::SystemDefaultsQoS(), [this](nav_msgs::msg::Odometry::SharedPtr message) {
      std::lock_guard<std::mutex> hold(lock_);
      const rclcpp::Time now(message->header.stamp);
      if (!heard_.empty() && now < rclcpp::Time(heard_.back().header.stamp)) {
        heard_.clear();  // the clock was set back
      }
      heard_.push_back(*message);
      while (now - rclcpp::Time(heard_.front().header.stamp) > span_) {
        heard_.pop_front();
      }
    });
}
geometry_msgs::msg::TwistStamped OdomSmoother::getTwistStamped()
{
  std::lock_guard<std::mutex> hold(lock_);
  geometry_msgs::msg::TwistStamped mean;
  if (heard_.empty()) {
    return mean;
  }
  mean.header = heard_.back().header;
  const double share = 1.0 / static_cast<double>(heard_.size());
  for (auto & one : heard_) {
    const auto & twist = one.twist.twist;
    mean.twist.linear.x += share * twist.linear.x;
    mean.twist.linear.y += share * twist.linear.y;
    mean.twist.linear.z += share * twist.linear.z;
    mean.twist.angular.x += share * twist.angular.x;
    mean.twist.angular.y += share * twist.angular.y;
    mean.twist.angular.z += share * twist.angular.z;
  }
  return mean;
}
}  // namespace nav2_util
