// Images of ROS as cv::Mat and back.
#pragma once
#include <cstring>
#include <map>
#include <memory>
#include <opencv2/core/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "sensor_msgs/image_encodings.hpp"
#include "sensor_msgs/msg/compressed_image.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace cv_bridge
{
class Exception : public std::runtime_error
{
public:
  explicit Exception(const std::string & text)
  : std::runtime_error(text) {}
};

class CvImage;
using CvImagePtr = std::shared_ptr<CvImage>;
using CvImageConstPtr = std::shared_ptr<const CvImage>;

enum Format
{
  BMP, DIB, JPEG, JPG, JPE, JP2, PNG, PBM, PGM, PPM, SR, RAS, TIFF, TIF
};

class CvImage
{
public:
  using Ptr = CvImagePtr;
  using ConstPtr = CvImageConstPtr;
  CvImage() = default;
  CvImage(const std_msgs::msg::Header & header_, const std::string & encoding_, const cv::Mat & image_ = cv::Mat())
  : header(header_), encoding(encoding_), image(image_) {}

  sensor_msgs::msg::Image::SharedPtr toImageMsg() const
  {
    auto message = std::make_shared<sensor_msgs::msg::Image>();
    toImageMsg(*message);
    return message;
  }
  void toImageMsg(sensor_msgs::msg::Image & message) const;
  sensor_msgs::msg::CompressedImage::SharedPtr toCompressedImageMsg(const Format format = JPG) const
  {
    auto message = std::make_shared<sensor_msgs::msg::CompressedImage>();
    toCompressedImageMsg(*message, format);
    return message;
  }
  void toCompressedImageMsg(sensor_msgs::msg::CompressedImage & message, const Format format = JPG) const;

  std_msgs::msg::Header header;
  std::string encoding;
  cv::Mat image;

protected:
  std::shared_ptr<const void> tracked_object_;
  friend CvImageConstPtr toCvShare(
    const sensor_msgs::msg::Image & source, const std::shared_ptr<const void> & tracked_object,
    const std::string & encoding);
};

/// OpenCV's type for an encoding, as CV_8UC3 for bgr8; Exception for one that nobody knows.
int getCvType(const std::string & encoding);
/// A copy of a message's image, in another encoding where one is named; Exception where that makes no sense.
CvImagePtr toCvCopy(const sensor_msgs::msg::Image & source, const std::string & encoding = std::string());
CvImagePtr toCvCopy(const sensor_msgs::msg::Image::ConstSharedPtr & source, const std::string & encoding = std::string());
CvImagePtr toCvCopy(const sensor_msgs::msg::CompressedImage & source, const std::string & encoding = std::string());
CvImagePtr toCvCopy(
  const sensor_msgs::msg::CompressedImage::ConstSharedPtr & source, const std::string & encoding = std::string());
/// A message's image in the message's own memory, where the encoding stays.
CvImageConstPtr toCvShare(
  const sensor_msgs::msg::Image::ConstSharedPtr & source, const std::string & encoding = std::string());
CvImageConstPtr toCvShare(
  const sensor_msgs::msg::Image & source, const std::shared_ptr<const void> & tracked_object,
  const std::string & encoding = std::string());
CvImagePtr cvtColor(const CvImageConstPtr & source, const std::string & encoding);

/// How numbers become colours for a display.
struct CvtColorForDisplayOptions
{
  bool do_dynamic_scaling = false;
  double min_image_value = 0.0, max_image_value = 0.0;
  int colormap = -1, bg_label = -1;
};
CvImageConstPtr cvtColorForDisplay(
  const CvImageConstPtr & source, const std::string & encoding = std::string(),
  const CvtColorForDisplayOptions options = CvtColorForDisplayOptions());
}  // namespace cv_bridge

#include "cv_bridge/detail/conversions.hpp"
#include "cv_bridge/detail/messages.hpp"
#include "cv_bridge/detail/display.hpp"
