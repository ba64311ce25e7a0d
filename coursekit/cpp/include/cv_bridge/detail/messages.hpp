// Messages to images and images to messages.
#pragma once
#include "cv_bridge/detail/conversions.hpp"

namespace cv_bridge
{
namespace detail
{
inline bool is_big_endian_here()
{
  const uint16_t one = 1;
  return *reinterpret_cast<const uint8_t *>(&one) == 0;
}
/// A message's memory as an image; Exception where it is too short.
inline cv::Mat view(const sensor_msgs::msg::Image & source)
{
  int type = getCvType(source.encoding);
  size_t number = static_cast<size_t>(enc::bitDepth(source.encoding)) / 8;
  size_t width = source.width * number * static_cast<size_t>(CV_MAT_CN(type));
  if (source.step < width) {
    throw Exception(
            "Image is wrongly formed: step < width * byte_depth * num_channels  or  " +
            std::to_string(source.step) + " != " +
            std::to_string(source.width) + " * " + std::to_string(number) + " * " + std::to_string(CV_MAT_CN(type)));
  }
  if (source.data.size() < static_cast<size_t>(source.height) * source.step) {
    throw Exception(
            "Image is wrongly formed: height * step != size  or  " + std::to_string(source.height) + " * " +
            std::to_string(source.step) + " != " + std::to_string(source.data.size()));
  }
  return cv::Mat(
    static_cast<int>(source.height), static_cast<int>(source.width), type, const_cast<uint8_t *>(source.data.data()),
    source.step);
}
/// The same image with the bytes of each number as this computer has them.
inline cv::Mat in_order(const cv::Mat & image, bool big_endian)
{
  size_t size = image.elemSize1();
  if (size == 1 || big_endian == is_big_endian_here()) {
    return image;
  }
  cv::Mat turned = image.clone();
  for (int y = 0; y < turned.rows; ++y) {
    unsigned char * row = turned.ptr(y);
    for (size_t at = 0; at < static_cast<size_t>(turned.cols) * turned.elemSize(); at += size) {
      std::reverse(row + at, row + at + size);
    }
  }
  return turned;
}
inline CvImagePtr copied(
  const cv::Mat & image, const std_msgs::msg::Header & header, const std::string & from, const std::string & wanted)
{
  std::string to = wanted.empty() ? from : wanted;
  return std::make_shared<CvImage>(header, to, from == to ? image.clone() : converted(image, from, to));
}
inline const char * name_of(Format format)
{
  static const char * const names[] = {
    "bmp", "dib", "jpeg", "jpg", "jpe", "jp2", "png", "pbm", "pgm", "ppm", "sr", "ras", "tiff", "tif"};
  return names[format];
}
}  // namespace detail

inline void CvImage::toImageMsg(sensor_msgs::msg::Image & message) const
{
  message.header = header;
  message.height = static_cast<uint32_t>(image.rows);
  message.width = static_cast<uint32_t>(image.cols);
  message.encoding = encoding;
  message.is_bigendian = detail::is_big_endian_here();
  size_t width = static_cast<size_t>(image.cols) * image.elemSize();
  message.step = static_cast<uint32_t>(width);
  message.data.resize(width * static_cast<size_t>(image.rows));
  for (int y = 0; y < image.rows; ++y) {
    std::memcpy(message.data.data() + static_cast<size_t>(y) * width, image.ptr(y), width);
  }
}
inline void CvImage::toCompressedImageMsg(sensor_msgs::msg::CompressedImage & message, const Format format) const
{
  message.header = header;
  message.format = detail::name_of(format);
  cv::Mat shown = encoding == sensor_msgs::image_encodings::BGR8 || image.channels() == 1 ?
    image : detail::converted(image, encoding, sensor_msgs::image_encodings::BGR8);
  std::vector<unsigned char> bytes;
  cv::imencode("." + message.format, shown, bytes);
  message.data.assign(bytes.begin(), bytes.end());
}

inline CvImagePtr toCvCopy(const sensor_msgs::msg::Image & source, const std::string & encoding)
{
  return detail::copied(
    detail::in_order(detail::view(source), source.is_bigendian), source.header, source.encoding, encoding);
}
inline CvImagePtr toCvCopy(const sensor_msgs::msg::Image::ConstSharedPtr & source, const std::string & encoding)
{
  return toCvCopy(*source, encoding);
}
inline CvImagePtr toCvCopy(const sensor_msgs::msg::CompressedImage & source, const std::string & encoding)
{
  std::vector<unsigned char> bytes(source.data.begin(), source.data.end());
  cv::Mat image = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  if (image.empty()) {
    throw Exception("The compressed image of format [" + source.format + "] cannot be decoded");
  }
  std::string from = image.channels() == 1 ? "mono" : image.channels() == 4 ? "bgra" : "bgr";
  return detail::copied(image, source.header, from + (image.depth() == CV_16U ? "16" : "8"), encoding);
}
inline CvImagePtr toCvCopy(const sensor_msgs::msg::CompressedImage::ConstSharedPtr & source, const std::string & encoding)
{
  return toCvCopy(*source, encoding);
}
inline CvImageConstPtr toCvShare(const sensor_msgs::msg::Image::ConstSharedPtr & source, const std::string & encoding)
{
  return toCvShare(*source, source, encoding);
}
inline CvImageConstPtr toCvShare(
  const sensor_msgs::msg::Image & source, const std::shared_ptr<const void> & tracked, const std::string & encoding)
{
  bool ordered = source.is_bigendian == detail::is_big_endian_here() ||
    sensor_msgs::image_encodings::bitDepth(source.encoding) == 8;
  if ((!encoding.empty() && encoding != source.encoding) || !ordered) {
    return toCvCopy(source, encoding);
  }
  auto shared = std::make_shared<CvImage>(source.header, source.encoding, detail::view(source));
  shared->tracked_object_ = tracked;
  return shared;
}
inline CvImagePtr cvtColor(const CvImageConstPtr & source, const std::string & encoding)
{
  return detail::copied(source->image, source->header, source->encoding, encoding);
}
}  // namespace cv_bridge
