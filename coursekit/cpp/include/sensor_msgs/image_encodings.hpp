// The encodings of images, and what their names say.
#pragma once
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace sensor_msgs::image_encodings
{
#define COURSEKIT_ENCODING(name, text) const char name[] = text;
COURSEKIT_ENCODING(RGB8, "rgb8")
COURSEKIT_ENCODING(RGBA8, "rgba8")
COURSEKIT_ENCODING(RGB16, "rgb16")
COURSEKIT_ENCODING(RGBA16, "rgba16")
COURSEKIT_ENCODING(BGR8, "bgr8")
COURSEKIT_ENCODING(BGRA8, "bgra8")
COURSEKIT_ENCODING(BGR16, "bgr16")
COURSEKIT_ENCODING(BGRA16, "bgra16")
COURSEKIT_ENCODING(MONO8, "mono8")
COURSEKIT_ENCODING(MONO16, "mono16")
COURSEKIT_ENCODING(BAYER_RGGB8, "bayer_rggb8")
COURSEKIT_ENCODING(BAYER_BGGR8, "bayer_bggr8")
COURSEKIT_ENCODING(BAYER_GBRG8, "bayer_gbrg8")
COURSEKIT_ENCODING(BAYER_GRBG8, "bayer_grbg8")
COURSEKIT_ENCODING(BAYER_RGGB16, "bayer_rggb16")
COURSEKIT_ENCODING(BAYER_BGGR16, "bayer_bggr16")
COURSEKIT_ENCODING(BAYER_GBRG16, "bayer_gbrg16")
COURSEKIT_ENCODING(BAYER_GRBG16, "bayer_grbg16")
COURSEKIT_ENCODING(YUV422, "yuv422")
COURSEKIT_ENCODING(YUV422_YUY2, "yuv422_yuy2")
COURSEKIT_ENCODING(NV21, "nv21")
COURSEKIT_ENCODING(NV24, "nv24")
#define COURSEKIT_CV_ENCODINGS(type) \
  COURSEKIT_ENCODING(TYPE_ ## type ## C1, #type "C1") \
  COURSEKIT_ENCODING(TYPE_ ## type ## C2, #type "C2") \
  COURSEKIT_ENCODING(TYPE_ ## type ## C3, #type "C3") \
  COURSEKIT_ENCODING(TYPE_ ## type ## C4, #type "C4")
COURSEKIT_CV_ENCODINGS(8U)
COURSEKIT_CV_ENCODINGS(8S)
COURSEKIT_CV_ENCODINGS(16U)
COURSEKIT_CV_ENCODINGS(16S)
COURSEKIT_CV_ENCODINGS(32S)
COURSEKIT_CV_ENCODINGS(32F)
COURSEKIT_CV_ENCODINGS(64F)

inline bool starts_with(const std::string & text, const std::string & start) {return text.compare(0, start.size(), start) == 0;}
inline bool isColor(const std::string & encoding) {return starts_with(encoding, "rgb") || starts_with(encoding, "bgr");}
inline bool isMono(const std::string & encoding) {return starts_with(encoding, "mono");}
inline bool isBayer(const std::string & encoding) {return starts_with(encoding, "bayer");}
inline bool hasAlpha(const std::string & encoding) {return starts_with(encoding, "rgba") || starts_with(encoding, "bgra");}

/// How many numbers a pixel has; std::runtime_error for an encoding that nobody knows.
inline int numChannels(const std::string & encoding)
{
  if (isMono(encoding) || isBayer(encoding) || encoding == NV21 || encoding == NV24) {
    return 1;
  }
  if (isColor(encoding)) {
    return hasAlpha(encoding) ? 4 : 3;
  }
  if (encoding == YUV422 || encoding == YUV422_YUY2) {
    return 2;
  }
  size_t at = encoding.find('C');
  if (at != std::string::npos) {
    return at + 1 < encoding.size() ? std::atoi(encoding.c_str() + at + 1) : 1;
  }
  throw std::runtime_error("Unknown encoding " + encoding);
}
/// How many bits each of them has.
inline int bitDepth(const std::string & encoding)
{
  if (isColor(encoding) || isMono(encoding) || isBayer(encoding)) {
    return encoding.size() > 2 && encoding.substr(encoding.size() - 2) == "16" ? 16 : 8;
  }
  if (encoding == YUV422 || encoding == YUV422_YUY2 || encoding == NV21 || encoding == NV24) {
    return 8;
  }
  int bits = std::atoi(encoding.c_str());
  if (bits) {
    return bits;
  }
  throw std::runtime_error("Unknown encoding " + encoding);
}
}  // namespace sensor_msgs::image_encodings
