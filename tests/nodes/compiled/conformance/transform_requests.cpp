#include "check.hpp"
#include "tf2/buffer_core.h"
#include "tf2_ros/async_buffer_interface.h"
#include "tf2_ros/buffer.h"

static geometry_msgs::msg::TransformStamped at(int seconds, const std::string & child = "lidar")
{
  geometry_msgs::msg::TransformStamped transform;
  transform.header.frame_id = "base";
  transform.header.stamp.sec = seconds;
  transform.child_frame_id = child;
  transform.transform.rotation.w = 1;
  return transform;
}
static tf2::TimePoint second(int seconds) {return tf2::TimePoint(std::chrono::seconds(seconds));}
/// A function for requests that writes what it is told.
static tf2::BufferCore::TransformableCallback writer(std::ostringstream & told)
{
  return [&told](
    tf2::TransformableRequestHandle handle, const std::string & target, const std::string & source, tf2::TimePoint time,
    tf2::TransformableResult result) {
           told << handle << ' ' << target << ' ' << source << ' ' << tf2::timeToSec(time) << ' ' <<
             (result == tf2::TransformAvailable ? "available" : "failure") << '\n';
         };
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  tf2::BufferCore core;
  std::ostringstream told;
  const auto first = core.addTransformableRequest(writer(told), "base", "lidar", second(2));
  check("a request has a number", first != 0);
  core.setTransform(at(1), "test");
  equal("it waits for its time", told.str(), "");
  core.setTransform(at(3), "test");
  equal("a transform answers it", told.str(), std::to_string(first) + " base lidar 2 available\n");
  core.setTransform(at(4), "test");
  equal("it is answered once", told.str(), std::to_string(first) + " base lidar 2 available\n");
  equal("what is known needs no request", core.addTransformableRequest(writer(told), "base", "lidar", second(2)), 0u);
  equal("nor does a frame in itself", core.addTransformableRequest(writer(told), "moon", "moon", second(2)), 0u);

  told.str("");
  const auto cancelled = core.addTransformableRequest(writer(told), "base", "lidar", second(5));
  core.cancelTransformableRequest(cancelled);
  core.setTransform(at(6), "test");
  equal("a cancelled one is not answered", told.str(), "");

  core.addTransformableRequest(writer(told), "base", "camera", second(5));
  core.setTransform(at(90, "camera"), "test");
  check("it fails when only newer ones are kept", told.str().find(" base camera 5 failure") != std::string::npos, told.str());
  const auto too_old = core.addTransformableRequest(writer(told), "base", "camera", second(5));
  equal("a request that is too old is refused", too_old, 0xffffffffffffffffULL);

  throws<tf2::NoDataForExtrapolationException>("one transform is of one time", [&] {
      core.lookupTransform("base", "camera", second(91));
    });
  throws<tf2::ForwardExtrapolationException>("the future", [&] {core.lookupTransform("base", "lidar", second(99));});
  throws<tf2::BackwardExtrapolationException>("the past", [&] {core.lookupTransform("base", "lidar", second(0) + 1ns);});
  throws<tf2::ExtrapolationException>("all are extrapolations", [&] {core.lookupTransform("base", "lidar", second(99));});
  tf2_ros::Buffer buffer(std::make_shared<rclcpp::Clock>());
  tf2_ros::AsyncBufferInterface & waits = buffer;
  throws<tf2_ros::CreateTimerInterfaceException>("waiting needs timers", [&] {
      waits.waitForTransform("base", "lidar", tf2::TimePointZero, 1s, nullptr);
    });
  rclcpp::shutdown();
}
