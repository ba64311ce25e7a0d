// cv_bridge and image_transport: conversions, shared memory, what is refused, a camera with its calibration.
#include <iostream>

#include "cv_bridge/cv_bridge.h"
#include "image_transport/image_transport.hpp"
#include "rclcpp/rclcpp.hpp"
using sensor_msgs::msg::CameraInfo;
using sensor_msgs::msg::Image;

static void conversions()
{
  cv::Mat colour(2, 3, CV_8UC3, cv::Scalar(10, 20, 30));
  std_msgs::msg::Header header;
  header.frame_id = "eye";
  Image::SharedPtr message = cv_bridge::CvImage(header, "bgr8", colour).toImageMsg();
  std::cout << message->width << message->height << message->step << message->encoding << int(message->is_bigendian)
            << message->data.size() << message->header.frame_id << std::endl;
  auto shared = cv_bridge::toCvShare(message), copy = cv_bridge::toCvShare(message, "rgb8");
  std::cout << (shared->image.data == message->data.data()) << copy->image.at<cv::Vec3b>(0, 0) << copy->encoding << " "
            << int(cv_bridge::toCvCopy(message, "mono8")->image.at<uchar>(0, 0)) << " "
            << cv_bridge::toCvCopy(message, sensor_msgs::image_encodings::BGR16)->image.at<cv::Vec3w>(1, 1) << std::endl;
  auto deep = cv_bridge::CvImage(header, "mono16", cv::Mat(1, 1, CV_16UC1, cv::Scalar(0x0102))).toImageMsg();
  std::swap(deep->data[0], deep->data[1]);
  deep->is_bigendian = true;
  std::cout << cv_bridge::toCvCopy(deep)->image.at<ushort>(0, 0) << cv_bridge::getCvType("32FC2") << std::endl;
  auto packed = cv_bridge::CvImage(header, "bgr8", colour).toCompressedImageMsg(cv_bridge::PNG);
  std::cout << packed->format << cv_bridge::toCvCopy(packed, "bgr8")->image.at<cv::Vec3b>(1, 2) << std::endl;
  message->encoding = "8UC3";
  for (auto wanted : {"bgr8", "8UC1", "odd"}) {
    try {
      cv_bridge::toCvCopy(message, wanted);
    } catch (const std::runtime_error & error) {
      std::cout << error.what() << std::endl;
    }
  }
  message->step = 2;
  try {
    cv_bridge::toCvCopy(message);
  } catch (const cv_bridge::Exception & error) {
    std::cout << error.what() << std::endl;
  }
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  conversions();
  auto node = rclcpp::Node::make_shared("eyes");
  image_transport::ImageTransport transport(node);
  auto camera = transport.advertiseCamera("front/image", 1);
  auto plain = transport.subscribe("front/image", 1, [](const Image::ConstSharedPtr & image) {std::cout << "image " << image->width;});
  auto both = transport.subscribeCamera(
    "front/image", 1, [](const Image::ConstSharedPtr & image, const CameraInfo::ConstSharedPtr & info) {
      std::cout << " with " << info->width << (image->header.stamp == info->header.stamp) << std::endl;
      rclcpp::shutdown();
    });
  std::cout << camera.getTopic() << " " << camera.getInfoTopic() << " " << camera.getNumSubscribers() << both.getTransport() << std::endl;
  Image image;
  CameraInfo info;
  image.width = info.width = 640;
  camera.publish(image, info, node->now());
  try {
    image_transport::create_subscription(node.get(), "x", [](const Image::ConstSharedPtr &) {}, "theora");
  } catch (const image_transport::TransportLoadException & error) {
    std::cout << error.getTransport() << std::endl;
  }
  rclcpp::spin(node);
}
