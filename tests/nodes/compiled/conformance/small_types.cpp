// Small names that programs use beside the large ones.
#include "check.hpp"
#include "cv_bridge/rgb_colors.h"
#include "image_transport/camera_common.hpp"
#include "image_transport/single_subscriber_publisher.hpp"
#include "laser_geometry/laser_geometry.hpp"
#include "rcl/rcl.h"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rcutils/logging_macros.h"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2/buffer_core.h"

static int made = 0;
struct Shared
{
  explicit Shared(int number)
  : number(number) {++made;}
  int number;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto context = rclcpp::contexts::get_global_default_context();
  auto shared = context->get_sub_context<Shared>(3);
  check("a context keeps one of each type", shared == context->get_sub_context<Shared>(4) && shared->number == 3 && made == 1);
  check("another context another", rclcpp::Context().get_sub_context<Shared>(5) != shared);
  check("all signals are handled", rclcpp::get_current_signal_handler_options() == rclcpp::SignalHandlerOptions::All);
  rclcpp::uninstall_signal_handlers();
  check("none is", rclcpp::get_current_signal_handler_options() == rclcpp::SignalHandlerOptions::None);
  rclcpp::install_signal_handlers(rclcpp::SignalHandlerOptions::SigTerm);
  check("one is", rclcpp::get_current_signal_handler_options() == rclcpp::SignalHandlerOptions::SigTerm);

  rclcpp_action::GoalUUID number{1, 2, 3}, back{};
  rclcpp_action::GoalInfo info;
  rclcpp_action::convert(number, &info);
  rclcpp_action::convert(info, &back);
  check("a goal's number goes there and back", back == number && info.goal_id.uuid[2] == 3);
  rclcpp_action::DefaultActionStatusQoS status;
  check("late ones get the states of goals", status.durability() == rclcpp::DurabilityPolicy::TransientLocal && status.depth() == 1);
  equal("what rcl returns for a topic that is none", RCL_RET_TOPIC_NAME_INVALID, 103);

  namespace colors = cv_bridge::rgb_colors;
  check("a color", colors::getRGBColor(colors::ORANGE) == cv::Vec3d(1, 0.647, 0));
  check("the last one", colors::YELLOWGREEN == 145 && colors::getRGBColor(colors::YELLOWGREEN) == cv::Vec3d(0.604, 0.804, 0.196));
  check("they begin again", colors::getRGBColor(146) == colors::getRGBColor(colors::ALICEBLUE));
  equal("without its last end", image_transport::erase_last_copy("a_raw_raw", "_raw"), "a_raw");
  int published = 0;
  image_transport::SingleSubscriberPublisher one(
    "viewer", "/image", [] {return 7;}, [&](const sensor_msgs::msg::Image & image) {published += image.height;});
  sensor_msgs::msg::Image image;
  image.height = 4;
  one.publish(image);
  one.publish(std::make_shared<sensor_msgs::msg::Image>(image));
  check("a publisher for one", published == 8 && one.getNumSubscribers() == 7 && one.getSubscriberName() + one.getTopic() == "viewer/image");

  tf2::BufferCore buffer;
  geometry_msgs::msg::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.child_frame_id = "lidar";
  transform.transform.translation.y = 5;
  transform.transform.rotation.w = 1;
  buffer.setTransform(transform, "test", true);
  sensor_msgs::msg::LaserScan scan;
  scan.header.frame_id = "lidar";
  scan.header.stamp.sec = 3;
  scan.range_max = 9;
  scan.ranges = {2};
  sensor_msgs::msg::PointCloud2 cloud;
  laser_geometry::LaserProjection().transformLaserScanToPointCloud("map", scan, cloud, buffer);
  check("a scan by a buffer without a clock", *sensor_msgs::PointCloud2ConstIterator<float>(cloud, "y") == 5.0f);
  int asked = 0;
  const auto says = [&asked] {return ++asked > 1;};
  for (int i = 0; i < 2; ++i) {
    RCUTILS_LOG_FATAL_FUNCTION_NAMED(says, "small", "LINE %d", i);
    RCUTILS_LOG_FATAL_SKIPFIRST_THROTTLE(rcutils_steady_time_now, 0, "LINE skipped %d", i);
  }
  equal("a function is asked each time", asked, 2);
  rclcpp::shutdown();
}
