// From one encoding to another, by cv::cvtColor.
#pragma once
#include "cv_bridge/cv_bridge.h"

namespace cv_bridge
{
namespace detail
{
namespace enc = sensor_msgs::image_encodings;

/// The order of colours, without the bits: "bgr", "bayer_rggb", ...; empty for plain numbers.
inline std::string colours_of(const std::string & encoding)
{
  if (encoding == enc::YUV422 || encoding == enc::YUV422_YUY2) {
    return encoding;
  }
  if (enc::isColor(encoding) || enc::isMono(encoding) || enc::isBayer(encoding)) {
    return encoding.substr(0, encoding.find_last_not_of("0123456789") + 1);
  }
  return "";
}
/// cv::cvtColor's number for two orders of colours; -1 where there is none.
inline int code_between(const std::string & from, const std::string & to)
{
  static const std::map<std::pair<std::string, std::string>, int> codes = {
    {{"mono", "rgb"}, cv::COLOR_GRAY2RGB}, {{"mono", "bgr"}, cv::COLOR_GRAY2BGR},
    {{"mono", "rgba"}, cv::COLOR_GRAY2RGBA}, {{"mono", "bgra"}, cv::COLOR_GRAY2BGRA},
    {{"rgb", "mono"}, cv::COLOR_RGB2GRAY}, {{"rgb", "bgr"}, cv::COLOR_RGB2BGR},
    {{"rgb", "rgba"}, cv::COLOR_RGB2RGBA}, {{"rgb", "bgra"}, cv::COLOR_RGB2BGRA},
    {{"bgr", "mono"}, cv::COLOR_BGR2GRAY}, {{"bgr", "rgb"}, cv::COLOR_BGR2RGB},
    {{"bgr", "rgba"}, cv::COLOR_BGR2RGBA}, {{"bgr", "bgra"}, cv::COLOR_BGR2BGRA},
    {{"rgba", "mono"}, cv::COLOR_RGBA2GRAY}, {{"rgba", "rgb"}, cv::COLOR_RGBA2RGB},
    {{"rgba", "bgr"}, cv::COLOR_RGBA2BGR}, {{"rgba", "bgra"}, cv::COLOR_RGBA2BGRA},
    {{"bgra", "mono"}, cv::COLOR_BGRA2GRAY}, {{"bgra", "rgb"}, cv::COLOR_BGRA2RGB},
    {{"bgra", "bgr"}, cv::COLOR_BGRA2BGR}, {{"bgra", "rgba"}, cv::COLOR_BGRA2RGBA},
    {{"yuv422", "mono"}, cv::COLOR_YUV2GRAY_UYVY}, {{"yuv422", "rgb"}, cv::COLOR_YUV2RGB_UYVY},
    {{"yuv422", "bgr"}, cv::COLOR_YUV2BGR_UYVY}, {{"yuv422", "rgba"}, cv::COLOR_YUV2RGBA_UYVY},
    {{"yuv422", "bgra"}, cv::COLOR_YUV2BGRA_UYVY},
    {{"yuv422_yuy2", "mono"}, cv::COLOR_YUV2GRAY_YUY2}, {{"yuv422_yuy2", "rgb"}, cv::COLOR_YUV2RGB_YUY2},
    {{"yuv422_yuy2", "bgr"}, cv::COLOR_YUV2BGR_YUY2}, {{"yuv422_yuy2", "rgba"}, cv::COLOR_YUV2RGBA_YUY2},
    {{"yuv422_yuy2", "bgra"}, cv::COLOR_YUV2BGRA_YUY2},
    {{"bayer_rggb", "mono"}, cv::COLOR_BayerBG2GRAY}, {{"bayer_rggb", "rgb"}, cv::COLOR_BayerBG2RGB},
    {{"bayer_rggb", "bgr"}, cv::COLOR_BayerBG2BGR}, {{"bayer_bggr", "mono"}, cv::COLOR_BayerRG2GRAY},
    {{"bayer_bggr", "rgb"}, cv::COLOR_BayerRG2RGB}, {{"bayer_bggr", "bgr"}, cv::COLOR_BayerRG2BGR},
    {{"bayer_gbrg", "mono"}, cv::COLOR_BayerGR2GRAY}, {{"bayer_gbrg", "rgb"}, cv::COLOR_BayerGR2RGB},
    {{"bayer_gbrg", "bgr"}, cv::COLOR_BayerGR2BGR}, {{"bayer_grbg", "mono"}, cv::COLOR_BayerGB2GRAY},
    {{"bayer_grbg", "rgb"}, cv::COLOR_BayerGB2RGB}, {{"bayer_grbg", "bgr"}, cv::COLOR_BayerGB2BGR}};
  auto found = codes.find({from, to});
  return found == codes.end() ? -1 : found->second;
}
/// Which conversion is needed, -1 for none but perhaps another depth; Exception where it makes no sense.
inline int conversion(const std::string & from, const std::string & to)
{
  std::string before = colours_of(from), after = colours_of(to);
  if (before.empty() && !after.empty()) {
    throw Exception("[" + from + "] is not a color format. but [" + to + "] is. The conversion does not make sense");
  }
  if (before.empty() || after.empty()) {
    if (enc::numChannels(from) != enc::numChannels(to)) {
      throw Exception(
              before.empty() ? "[" + from + "] and [" + to + "] do not have the same number of channel" :
              "[" + from + "] is a color format but [" + to +
              "] is not so they must have the same OpenCV type, CV_8UC3, CV16UC1 ....");
    }
    return -1;
  }
  if (before == after) {
    return -1;
  }
  int code = code_between(before, after);
  if (code < 0) {
    throw Exception("Unsupported conversion from [" + from + "] to [" + to + "]");
  }
  return code;
}
/// An image in another encoding; the first of these is the one that it has.
inline cv::Mat converted(const cv::Mat & image, const std::string & from, const std::string & to)
{
  int code = conversion(from, to);
  cv::Mat made;  // not the image: cvtColor writes into memory that fits, and this one may be a message's
  if (code >= 0) {
    cv::cvtColor(image, made, code);
  } else {
    made = image;
  }
  int before = enc::bitDepth(from), after = enc::bitDepth(to);
  if (CV_MAT_DEPTH(getCvType(from)) != CV_MAT_DEPTH(getCvType(to))) {
    double scale = before == 8 && after == 16 ? 65535. / 255. : before == 16 && after == 8 ? 255. / 65535. : 1;
    cv::Mat other;
    made.convertTo(other, getCvType(to), scale);
    return other;
  }
  return made.data == image.data ? image.clone() : made;
}
}  // namespace detail

inline int getCvType(const std::string & encoding)
{
  namespace enc = sensor_msgs::image_encodings;
  if (encoding == enc::YUV422 || encoding == enc::YUV422_YUY2) {
    return CV_8UC2;
  }
  if (!detail::colours_of(encoding).empty()) {
    return CV_MAKETYPE(enc::bitDepth(encoding) == 16 ? CV_16U : CV_8U, enc::numChannels(encoding));
  }
  static const std::map<std::string, int> depths = {
    {"8U", CV_8U}, {"8S", CV_8S}, {"16U", CV_16U}, {"16S", CV_16S}, {"32S", CV_32S}, {"32F", CV_32F}, {"64F", CV_64F}};
  auto found = depths.find(encoding.substr(0, encoding.find('C')));
  if (found == depths.end()) {
    throw Exception("Unrecognized image encoding [" + encoding + "]");
  }
  return CV_MAKETYPE(found->second, encoding.find('C') == std::string::npos ? 1 : enc::numChannels(encoding));
}
}  // namespace cv_bridge
