// Depths, labels and colours as an image that people look at: cvtColorForDisplay.
#pragma once
#include <cmath>

#include "cv_bridge/detail/messages.hpp"

namespace cv_bridge
{
namespace detail
{
/// The encoding of the image to look at; Exception where that has no 8 bits, or neither colours nor shades of grey.
inline std::string encoding_to_show(const std::string & from, const std::string & wanted)
{
  if (!wanted.empty()) {
    if ((enc::isColor(wanted) || enc::isMono(wanted)) && enc::bitDepth(wanted) == 8) {
      return wanted;
    }
    throw Exception("cvtColorForDisplay has no images of [" + wanted + "]: ask for bgr8, rgb8 or mono8");
  }
  const int bits = enc::bitDepth(from);
  if (bits > 16 && (bits > 32 || enc::numChannels(from) > 1)) {
    throw Exception("cvtColorForDisplay chooses no encoding for [" + from + "]: name one, for example bgr8");
  }
  return enc::BGR8;
}
/// Each label is 137 degrees further round the circle of hues, so that labels that follow each other differ much.
inline cv::Vec3b colour_of(int label)
{
  const int hue = static_cast<int>((label * int64_t{137} % 360 + 360) % 360);
  auto part = [hue](int turn) {
      return static_cast<unsigned char>(std::min(std::max(std::abs((hue + turn) % 360 - 180) - 60, 0), 60) * 255 / 60);
    };
  return {part(120), part(240), part(0)};
}
inline cv::Mat colours_of_labels(const cv::Mat & labels, int background)
{
  cv::Mat made(labels.rows, labels.cols, CV_8UC3);
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      const int label = labels.at<int>(y, x);
      made.at<cv::Vec3b>(y, x) = label == background ? cv::Vec3b(0, 0, 0) : colour_of(label);
    }
  }
  return made;
}
/// Give `made` a value wherever the image has a number of that kind: std::isnan, or what is not finite.
template<class P, class F>
void set_where(const cv::Mat & image, cv::Mat & made, const P & value, F chosen)
{
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      if (chosen(image.depth() == CV_32F ? image.at<float>(y, x) : image.at<double>(y, x))) {
        made.at<P>(y, x) = value;
      }
    }
  }
}
/// The least and the greatest number of an image; what is not finite does not count.
inline void finite_limits(const cv::Mat & image, double & low, double & high)
{
  cv::Mat counts(image.rows, image.cols, CV_8U, cv::Scalar(255));
  if (image.depth() == CV_32F || image.depth() == CV_64F) {
    set_where(image, counts, static_cast<unsigned char>(0), [](double number) {return !std::isfinite(number);});
  }
  cv::minMaxLoc(image, &low, &high, nullptr, nullptr, counts);
}
/// 0 to 255 for low to high; what is not finite is black, as OpenCV's rounding makes it on a PC.
inline cv::Mat shades(const cv::Mat & image, double low, double high)
{
  cv::Mat above, made;
  image.convertTo(above, -1, 1, -low);
  above.convertTo(made, CV_8U, 255 / (high - low));
  if (image.depth() == CV_32F || image.depth() == CV_64F) {
    set_where(above, made, static_cast<unsigned char>(0), [](double number) {return !std::isfinite(number);});
  }
  return made;
}
inline CvImagePtr scaled(const CvImage & source, const std::string & wanted, double low, double high, int colormap)
{
  const cv::Mat grey = shades(source.image, low, high);
  if (colormap == -1) {
    return copied(grey, source.header, enc::MONO8, wanted);
  }
  cv::Mat coloured;
  cv::applyColorMap(grey, coloured, colormap);
  if (source.encoding == enc::TYPE_32FC1) {
    set_where(source.image, coloured, cv::Vec3b(0, 0, 0), [](double number) {return std::isnan(number);});
  }
  return copied(coloured, source.header, enc::BGR8, wanted);
}
}  // namespace detail

inline CvImageConstPtr cvtColorForDisplay(
  const CvImageConstPtr & source, const std::string & encoding, const CvtColorForDisplayOptions options)
{
  namespace enc = sensor_msgs::image_encodings;
  if (!source) {
    throw Exception("cvtColorForDisplay needs an image, and got a null pointer");
  }
  const std::string wanted = detail::encoding_to_show(source->encoding, encoding);
  if (source->encoding == enc::TYPE_32SC1 && wanted == enc::BGR8) {
    return std::make_shared<CvImage>(
      source->header, wanted, detail::colours_of_labels(source->image, options.bg_label));
  }
  double low = options.min_image_value, high = options.max_image_value;
  if ((options.do_dynamic_scaling || low != high) && source->image.channels() != 1) {
    throw Exception("cvtColorForDisplay scales images of one channel only, not of [" + source->encoding + "]");
  }
  if (options.do_dynamic_scaling) {
    detail::finite_limits(source->image, low, high);
    if (low == high) {  // all the same: the grey in the middle
      cv::Mat even(source->image.rows, source->image.cols, getCvType(wanted), cv::Scalar::all(127.5));
      return std::make_shared<CvImage>(source->header, wanted, even);
    }
  }
  if (low != high) {
    return detail::scaled(*source, wanted, low, high, options.colormap);
  }
  // without limits numbers have no shades; only the plain type that depth cameras use is taken for one of grey
  const std::string known = source->encoding == enc::TYPE_16UC1 ? std::string(enc::MONO16) : source->encoding;
  return known == wanted ? source : CvImageConstPtr(detail::copied(source->image, source->header, known, wanted));
}
}  // namespace cv_bridge
