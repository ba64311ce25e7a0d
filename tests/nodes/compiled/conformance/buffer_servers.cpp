// Buffers that other programs ask, and the rest of what a buffer can be asked.
#include "check.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/buffer_client.h"
#include "tf2_ros/buffer_server.h"
#include "tf2_ros/create_timer_ros.h"

using geometry_msgs::msg::PointStamped;
using geometry_msgs::msg::TransformStamped;

static TransformStamped link(const std::string & parent, const std::string & child, int32_t second, double x)
{
  TransformStamped transform;
  transform.header.frame_id = parent;
  transform.header.stamp.sec = second;
  transform.child_frame_id = child;
  transform.transform.translation.x = x;
  return transform;
}
static tf2::TimePoint at(int second) {return tf2::TimePoint(std::chrono::seconds(second));}

void forms(rclcpp::Node::SharedPtr node)
{
  tf2_ros::Buffer buffer(node->get_clock());
  for (int second = 1; second <= 3; ++second) {
    buffer.setTransform(link("map", "base", second, second), "test");
  }
  buffer.setTransform(link("base", "lidar", 0, 10), "test", true);
  std::string why;
  check("between two times", buffer.canTransform("base", at(1), "base", at(3), "map", tf2::Duration::zero()));
  check("by rclcpp's times", buffer.canTransform("base", rclcpp::Time(1, 0, RCL_ROS_TIME), "base",
    rclcpp::Time(3, 0, RCL_ROS_TIME), "map"));
  check("and why not", !buffer.canTransform("base", at(1), "base", at(9), "map", tf2::Duration::zero(), &why) && !why.empty());
  tf2::BufferCore & core = buffer;
  check("also of a core", core.canTransform("base", at(1), "base", at(3), "map"));
  PointStamped point, seen;
  point.header.frame_id = "base";
  point.header.stamp.sec = 3;
  buffer.transform(point, seen, "base", at(1), "map");
  equal("a point as it was seen earlier", seen.point.x, 2.0);
  equal("made anew", buffer.transform(point, "base", at(2), "map").point.x, 1.0);
  tf2::Stamped<tf2::Vector3> vector;
  buffer.transform(point, vector, "map");
  check("as another type", vector.x() == 3.0 && vector.frame_id_ == "map");
  buffer.transform(point, vector, "base", at(1), "map");
  equal("also between two times", vector.x(), 2.0);
  std::string parent;
  check("a frame's parent", core._getParent("lidar", tf2::TimePointZero, parent) && parent == "base");
  check("the root has none", !core._getParent("map", tf2::TimePointZero, parent));
  std::vector<std::string> names, chain;
  core._getFrameStrings(names);
  equal("all frames", names.size(), 3u);
  core._chainAsVector("map", at(1), "lidar", at(1), "map", chain);
  check("the way between two", chain.front() == "lidar" && chain.back() == "map");
  check("the tree for graphviz", core._allFramesAsDot().find("digraph") != std::string::npos);

  // what is waited for may be given up
  buffer.setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
      node->get_node_base_interface(), node->get_node_timers_interface()));
  int called = 0;
  auto count = [&](const tf2_ros::TransformStampedFuture &) {++called;};
  auto wait = buffer.waitForTransform("map", "crane", tf2::TimePointZero, 100ms, count);
  auto other = buffer.waitForTransform("map", "boom", tf2::TimePointZero, 100ms, count);
  check("requests have numbers", wait.getHandle() != other.getHandle());
  buffer.cancel(wait);
  spin_until(node, [] {return false;}, 200ms);
  equal("one that was cancelled is not called", called, 1);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("forms");
  forms(node);

  auto serves = rclcpp::Node::make_shared("serves"), asks = rclcpp::Node::make_shared("asks");
  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 4);
  executor.add_node(serves);
  executor.add_node(asks);
  std::thread spins([&] {executor.spin();});
  tf2_ros::Buffer buffer(serves->get_clock());
  tf2_ros::BufferClient client(asks, "far", 100.0);
  throws<tf2::ConnectivityException>("nobody serves", [&] {client.lookupTransform("map", "base", tf2::TimePointZero, 20ms);});
  auto server = std::make_unique<tf2_ros::BufferServer>(buffer, serves, "far");
  check("a client waits for its server", client.waitForServer(5s));
  throws<tf2::LookupException>("a frame that is not there", [&] {client.lookupTransform("map", "base", tf2::TimePointZero);});
  std::string why;
  check("why not", !client.canTransform("map", "base", tf2::TimePointZero, 20ms, &why) && why.find("map") != std::string::npos);
  std::thread later([&] {
      rclcpp::sleep_for(100ms);
      buffer.setTransform(link("map", "base", 1, 4), "test");
      buffer.setTransform(link("map", "base", 2, 6), "test");
    });
  equal("one that comes in time", client.lookupTransform("map", "base", tf2::TimePointZero, 5s).transform.translation.x > 3, true);
  later.join();
  check("it can be", client.canTransform("map", "base", at(1)));
  equal("across times", client.lookupTransform("base", at(1), "base", at(2), "map").transform.translation.x, 2.0);
  check("and asked whether", !client.canTransform("base", at(1), "base", at(9), "map"));
  throws<tf2::ExtrapolationException>("too late", [&] {client.lookupTransform("map", "base", at(9));});
  PointStamped point;
  point.header.frame_id = "base";
  point.header.stamp.sec = 2;
  equal("a client transforms", client.transform(point, "map").point.x, 6.0);
  server.reset();
  rclcpp::sleep_for(50ms);
  check("a server may leave", !client.waitForServer(20ms));
  executor.cancel();
  spins.join();
  rclcpp::shutdown();
}
