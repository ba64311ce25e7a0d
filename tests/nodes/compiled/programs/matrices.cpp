// Pictures go over topics as matrices: within the process they are the same, else a message is made of them.
#include <iostream>
#include <opencv2/core.hpp>

#include "image_tools/cv_mat_sensor_msgs_image_type_adapter.hpp"
#include "rclcpp/rclcpp.hpp"

using image_tools::ROSCvMatContainer;
using sensor_msgs::msg::Image;
using Adapted = rclcpp::TypeAdapter<ROSCvMatContainer, Image>;

template<class Do>
static void refused(Do what)
{
  try {
    what();
  } catch (const std::exception & error) {
    std::cout << error.what() << std::endl;
  }
}
static void contained()
{
  ROSCvMatContainer none;
  std::cout << "empty: " << none.is_owning() << none.is_bigendian() << " " << none.cv_mat().rows << "x" << none.cv_mat().cols
            << std::endl;
  auto message = std::make_shared<Image>();
  message->encoding = "yuv422";
  message->height = 1;
  message->width = 2;
  message->step = 4;
  message->data = {1, 2, 3, 4};
  ROSCvMatContainer held(message);
  std::cout << "shown: " << held.is_owning() << (held.cv_mat().data == message->data.data()) << held.cv_mat().channels() << " "
            << held.get_sensor_msgs_msg_image_pointer()->encoding << " ";
  refused([&] {held.get_sensor_msgs_msg_image_copy();});
  message->encoding = "odd";
  refused([&] {ROSCvMatContainer other(*message);});
  refused([] {ROSCvMatContainer other(std::unique_ptr<Image>{});});
  ROSCvMatContainer copy(held);
  std::cout << "copied: " << copy.is_owning() << (copy.cv_mat().data != held.cv_mat().data)
            << (copy.get_sensor_msgs_msg_image_pointer() != nullptr) << std::endl;
}
static void sent(bool within)
{
  auto node = std::make_shared<rclcpp::Node>("eye", rclcpp::NodeOptions().use_intra_process_comms(within));
  auto publisher = node->create_publisher<Adapted>("picture", 3);
  const unsigned char * place = nullptr;
  std::string told;
  auto matrices = node->create_subscription<Adapted>(
    "picture", 3, [&](const ROSCvMatContainer & got) {
      told += got.cv_mat().data == place ? "the same " : "another ";
      told += std::to_string(got.cv_mat().at<unsigned char>(1, 2)) + " " + got.header().frame_id;
    });
  rclcpp::Subscription<Image>::SharedPtr images;
  if (!within) {
    images = node->create_subscription<Image>(
      "picture", 3, [&](const Image & got) {
        told += ", and an image " + got.encoding + " " + std::to_string(got.height) + "x" + std::to_string(got.width) + " " +
          std::to_string(got.data.back());
      });
  }
  cv::Mat picture(2, 3, CV_8UC1, cv::Scalar(7));
  picture.at<unsigned char>(1, 2) = 9;
  place = picture.data;
  std_msgs::msg::Header header;
  header.frame_id = "lens";
  publisher->publish(std::make_unique<ROSCvMatContainer>(std::move(picture), header));
  for (int i = 0; i < 20; ++i) {
    rclcpp::sleep_for(std::chrono::milliseconds(5));
    rclcpp::spin_some(node);
  }
  std::cout << (within ? "within: " : "between: ") << told << std::endl;
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  contained();
  sent(true);
  sent(false);
  rclcpp::shutdown();
}
