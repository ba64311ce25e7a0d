// Buffers with timers of a program's own, covariances of poses, and what parameters say of themselves.
#include <map>

#include "check.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/create_timer_ros.h"

using Future = tf2_ros::TransformStampedFuture;

/// Timers that tick when the test says so.
class ByHand : public tf2_ros::CreateTimerInterface
{
public:
  tf2_ros::TimerHandle createTimer(
    rclcpp::Clock::SharedPtr, const tf2::Duration & period, tf2_ros::TimerCallbackType callback) override
  {
    periods.push_back(period);
    callbacks[++last] = callback;
    return last;
  }
  void cancel(const tf2_ros::TimerHandle & handle) override {callbacks.erase(handle);}
  void reset(const tf2_ros::TimerHandle &) override {}
  void remove(const tf2_ros::TimerHandle & handle) override {callbacks.erase(handle);}
  void tick(tf2_ros::TimerHandle handle)
  {
    auto callback = callbacks.at(handle);
    callback(handle);
  }
  std::map<tf2_ros::TimerHandle, tf2_ros::TimerCallbackType> callbacks;
  std::vector<tf2::Duration> periods;
  tf2_ros::TimerHandle last = 0;
};
static bool is_ready(const Future & future) {return future.wait_for(0s) == std::future_status::ready;}

static void by_hand()
{
  tf2_ros::Buffer buffer(std::make_shared<rclcpp::Clock>(RCL_SYSTEM_TIME));
  auto ignore = [](const Future &) {};
  throws<tf2_ros::CreateTimerInterfaceException>(
    "no timers", [&] {buffer.waitForTransform("map", "base", tf2::TimePointZero, 1s, ignore);});
  auto timers = std::make_shared<ByHand>();
  buffer.setCreateTimerInterface(timers);
  int calls = 0;
  auto late = buffer.waitForTransform("map", "base", tf2::TimePointZero, 3s, [&](const Future &) {++calls;});
  auto cancelled = buffer.waitForTransform("map", "base", tf2::TimePointZero, 1s, [&](const Future &) {calls += 100;});
  check("a timer for the time that it may take", timers->periods == std::vector<tf2::Duration>{3s, 1s} && !is_ready(late));
  buffer.cancel(cancelled);
  equal("a cancelled one has none", timers->callbacks.size(), 1u);
  timers->tick(1);
  check("the time is over", is_ready(late) && calls == 1 && timers->callbacks.empty());
  try {
    late.get();
  } catch (const tf2::TimeoutException & error) {
    equal("which is an error", std::string(error.what()), "Timed out waiting for transform");
  }
  auto found = buffer.waitForTransform("map", "base", tf2::TimePointZero, 3s, [&](const Future &) {++calls;});
  geometry_msgs::msg::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.child_frame_id = "base";
  transform.transform.translation.x = 4;
  transform.transform.rotation.w = 1;
  buffer.setTransform(transform, "test", true);
  check("a transform that is set is found at once", is_ready(found) && calls == 2 && found.get().transform.translation.x == 4);
  check("its timer is gone", timers->callbacks.empty());
  auto there = buffer.waitForTransform("map", "base", tf2::TimePointZero, 3s, [&](const Future &) {++calls;});
  check("one that is there needs no timer", is_ready(there) && calls == 3 && timers->last == 3);
}
static void of_a_node()
{
  auto node = rclcpp::Node::make_shared("timers");
  tf2_ros::CreateTimerROS timers(node->get_node_base_interface(), node->get_node_timers_interface());
  int ticks = 0;
  auto handle = timers.createTimer(node->get_clock(), 1ms, [&](const tf2_ros::TimerHandle & which) {ticks += which == 1;});
  check("a node's timer ticks", spin_until(node, [&] {return ticks > 1;}) && handle == 1);
  timers.cancel(handle);
  timers.reset(handle);
  ticks = 0;
  check("and again", spin_until(node, [&] {return ticks > 0;}));
  timers.remove(handle);
  throws<tf2_ros::InvalidTimerHandleException>("it is gone", [&] {timers.reset(handle);});
  throws<tf2_ros::InvalidTimerHandleException>("it cannot be stopped", [&] {timers.cancel(handle);});
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  by_hand();
  of_a_node();
  geometry_msgs::msg::PoseWithCovarianceStamped pose;
  pose.header.frame_id = "map";
  pose.header.stamp.sec = 12;
  pose.pose.pose.position.y = 3;
  pose.pose.pose.orientation.w = 1;
  pose.pose.covariance[7] = 0.5;
  tf2::WithCovarianceStamped<tf2::Transform> transform;
  tf2::fromMsg(pose, transform);
  check("a pose as a transform", transform.getOrigin().y() == 3 && transform.cov_mat_[1][1] == 0.5 && transform.frame_id_ == "map");
  check("and back", tf2::toMsg(transform) == pose);
  equal("a parameter in JSON", rclcpp::_to_json_dict_entry(rclcpp::Parameter("a", 1)), "\"a\": {\"type\": \"integer\", \"value\": \"1\"}");
  rclcpp::ParameterTypeException error(rclcpp::PARAMETER_BOOL, rclcpp::PARAMETER_STRING);
  equal("a wrong type", std::string(error.what()), "expected [bool] got [string]");
  rclcpp::shutdown();
}
