// Depths, labels and colours as images that people look at.
#include <cmath>
#include <iostream>
#include <limits>

#include "cv_bridge/cv_bridge.h"

template<class T>
static cv_bridge::CvImageConstPtr image(const std::string & encoding, std::initializer_list<T> numbers)
{
  const std::vector<T> all(numbers);
  return std::make_shared<cv_bridge::CvImage>(std_msgs::msg::Header(), encoding, cv::Mat(all, true).reshape(1, 1));
}
template<class ... A>
static void show(const cv_bridge::CvImageConstPtr & source, const A & ... how)
{
  try {
    const auto shown = cv_bridge::cvtColorForDisplay(source, how ...);
    std::cout << shown->encoding << shown->image << std::endl;
  } catch (const cv_bridge::Exception & refused) {
    std::cout << refused.what() << std::endl;
  }
}
int main()
{
  const float far = std::numeric_limits<float>::infinity();
  const auto labels = image<int>("32SC1", {-1, 0, 1, 2}), depths = image<float>("32FC1", {0, 1, 5, std::nanf(""), far});
  const auto range = image<ushort>("16UC1", {0, 257, 65535});
  cv_bridge::CvtColorForDisplayOptions limits, own, other;
  limits.max_image_value = 2;
  own.do_dynamic_scaling = true;
  other.bg_label = 1;
  show(labels);
  show(labels, "bgr8", other);
  show(labels, "mono8");
  show(labels, "mono8", own);
  show(range, "mono8");
  show(range);
  show(range, "mono8", own);
  show(depths);
  show(depths, "mono8", limits);
  show(image<float>("32FC1", {50, 100, 150, -far, far, std::nanf("")}), "mono8", own);
  limits.colormap = cv::COLORMAP_JET;
  show(depths, "rgb8", limits);
  show(image<float>("32FC1", {4, 4}), "mono8", own);
  show(image<float>("32FC1", {4, 4}), "", own);
  show(image<uchar>("mono8", {10, 20}), "mono8", own);
  show(image<double>("64FC1", {1}));
  show(range, "mono16");
  show(image<uchar>("8UC1", {10, 20}), "mono8");
  const auto colour = std::make_shared<cv_bridge::CvImage>(
    std_msgs::msg::Header(), "bgr8", cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
  show(colour, "rgb8");
  show(colour, "rgb8", own);
  show(nullptr);
  std::cout << (cv_bridge::cvtColorForDisplay(colour) == colour) << std::endl;
}
