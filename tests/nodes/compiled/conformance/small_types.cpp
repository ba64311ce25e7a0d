// Small names that programs use beside the large ones.
#include "check.hpp"
#include "cv_bridge/rgb_colors.h"
#include "image_transport/camera_common.hpp"
#include "image_transport/single_subscriber_publisher.hpp"
#include "rcl/rcl.h"
#include "rclcpp_action/rclcpp_action.hpp"

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
  rclcpp::shutdown();
}
