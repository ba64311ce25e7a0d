// Images: colours, sizes, filters, edges, contours.
#pragma once
#include "opencv2/core.hpp"
#include "opencv2/imgproc/drawing.hpp"
#include "opencv2/imgproc/lines.hpp"
#include "opencv2/imgproc/measures.hpp"
#include "opencv2/imgproc/shapes.hpp"

namespace cv
{
inline void cvtColor(InputArray src, OutputArray dst, int code, int dstCn = 0)
{
  dst.assign(call("cvtColor", src, code, kw("dstCn", dstCn)));
}
inline void resize(
  InputArray src, OutputArray dst, Size size, double fx = 0, double fy = 0, int interpolation = INTER_LINEAR)
{
  dst.assign(call("resize", src, size, kw("fx", fx), kw("fy", fy), kw("interpolation", interpolation)));
}
inline void GaussianBlur(
  InputArray src, OutputArray dst, Size size, double sigmaX, double sigmaY = 0, int border = BORDER_DEFAULT)
{
  dst.assign(call("GaussianBlur", src, size, sigmaX, kw("sigmaY", sigmaY), kw("borderType", border)));
}
inline void blur(InputArray src, OutputArray dst, Size size, Point anchor = Point(-1, -1), int border = BORDER_DEFAULT)
{
  dst.assign(call("blur", src, size, kw("anchor", anchor), kw("borderType", border)));
}
inline void boxFilter(
  InputArray src, OutputArray dst, int depth, Size size, Point anchor = Point(-1, -1), bool normalized = true,
  int border = BORDER_DEFAULT)
{
  dst.assign(
    call("boxFilter", src, depth, size, kw("anchor", anchor), kw("normalize", normalized), kw("borderType", border)));
}
inline void medianBlur(InputArray src, OutputArray dst, int size) {dst.assign(call("medianBlur", src, size));}
inline void bilateralFilter(
  InputArray src, OutputArray dst, int d, double sigma_colour, double sigma_space, int border = BORDER_DEFAULT)
{
  dst.assign(call("bilateralFilter", src, d, sigma_colour, sigma_space, kw("borderType", border)));
}
inline void filter2D(
  InputArray src, OutputArray dst, int depth, InputArray kernel, Point anchor = Point(-1, -1), double delta = 0,
  int border = BORDER_DEFAULT)
{
  dst.assign(call("filter2D", src, depth, kernel, kw("anchor", anchor), kw("delta", delta), kw("borderType", border)));
}
inline void sepFilter2D(
  InputArray src, OutputArray dst, int depth, InputArray row, InputArray column, Point anchor = Point(-1, -1),
  double delta = 0, int border = BORDER_DEFAULT)
{
  dst.assign(
    call("sepFilter2D", src, depth, row, column, kw("anchor", anchor), kw("delta", delta), kw("borderType", border)));
}
/// What belongs to a thing in an image: its mask is 1 or 3 there.
inline void grabCut(
  InputArray image, InputOutputArray mask, Rect rect, InputOutputArray background, InputOutputArray foreground,
  int iterations, int mode = GC_EVAL)
{
  const Mat known = mask.getMat().empty() ? Mat::zeros(image.size(), CV_8UC1) : mask.getMat();
  auto model = [](const Mat & mat) {return mat.empty() ? Mat::zeros(1, 65, CV_64F) : mat;};
  auto answer = call(
    "grabCut", image, known, rect, model(background.getMat()), model(foreground.getMat()), iterations, mode);
  mask.assign(answer[0]);
  background.assign(answer[1]);
  foreground.assign(answer[2]);
}
inline void Sobel(
  InputArray src, OutputArray dst, int depth, int dx, int dy, int size = 3, double scale = 1, double delta = 0,
  int border = BORDER_DEFAULT)
{
  dst.assign(
    call("Sobel", src, depth, dx, dy, kw("ksize", size), kw("scale", scale), kw("delta", delta), kw("borderType", border)));
}
inline void Laplacian(
  InputArray src, OutputArray dst, int depth, int size = 1, double scale = 1, double delta = 0, int border = BORDER_DEFAULT)
{
  dst.assign(
    call("Laplacian", src, depth, kw("ksize", size), kw("scale", scale), kw("delta", delta), kw("borderType", border)));
}
inline void Canny(
  InputArray src, OutputArray dst, double threshold1, double threshold2, int aperture = 3, bool l2_gradient = false)
{
  dst.assign(call("Canny", src, threshold1, threshold2, kw("apertureSize", aperture), kw("L2gradient", l2_gradient)));
}
inline double threshold(InputArray src, OutputArray dst, double limit, double highest, int type)
{
  remote::Value both = call("threshold", src, limit, highest, type);
  dst.assign(both[1]);
  return both[0].number();
}
inline void adaptiveThreshold(InputArray src, OutputArray dst, double highest, int method, int type, int block, double c)
{
  dst.assign(call("adaptiveThreshold", src, highest, method, type, block, c));
}
inline void equalizeHist(InputArray src, OutputArray dst) {dst.assign(call("equalizeHist", src));}
inline void applyColorMap(InputArray src, OutputArray dst, int map) {dst.assign(call("applyColorMap", src, map));}

inline Scalar morphologyDefaultBorderValue() {return Scalar::all(std::numeric_limits<double>::max());}
inline Mat getStructuringElement(int shape, Size size, Point anchor = Point(-1, -1))
{
  return call("getStructuringElement", shape, size, kw("anchor", anchor)).mat;
}
inline void erode(InputArray src, OutputArray dst, InputArray kernel, Point anchor = Point(-1, -1), int times = 1)
{
  dst.assign(call("erode", src, kernel, kw("anchor", anchor), kw("iterations", times)));
}
inline void dilate(InputArray src, OutputArray dst, InputArray kernel, Point anchor = Point(-1, -1), int times = 1)
{
  dst.assign(call("dilate", src, kernel, kw("anchor", anchor), kw("iterations", times)));
}
inline void morphologyEx(
  InputArray src, OutputArray dst, int operation, InputArray kernel, Point anchor = Point(-1, -1), int times = 1)
{
  dst.assign(call("morphologyEx", src, operation, kernel, kw("anchor", anchor), kw("iterations", times)));
}

inline void warpAffine(
  InputArray src, OutputArray dst, InputArray m, Size size, int flags = INTER_LINEAR, int border = BORDER_CONSTANT,
  const Scalar & value = Scalar())
{
  dst.assign(call("warpAffine", src, m, size, kw("flags", flags), kw("borderMode", border), kw("borderValue", value)));
}
inline void warpPerspective(
  InputArray src, OutputArray dst, InputArray m, Size size, int flags = INTER_LINEAR, int border = BORDER_CONSTANT,
  const Scalar & value = Scalar())
{
  dst.assign(call("warpPerspective", src, m, size, kw("flags", flags), kw("borderMode", border), kw("borderValue", value)));
}
inline void remap(
  InputArray src, OutputArray dst, InputArray map1, InputArray map2, int interpolation, int border = BORDER_CONSTANT,
  const Scalar & value = Scalar())
{
  dst.assign(call("remap", src, map1, map2, interpolation, kw("borderMode", border), kw("borderValue", value)));
}
inline Mat getRotationMatrix2D(Point2f center, double angle, double scale)
{
  return call("getRotationMatrix2D", center, angle, scale).mat;
}
inline Mat getPerspectiveTransform(InputArray from, InputArray to) {return call("getPerspectiveTransform", from, to).mat;}
inline Mat getAffineTransform(InputArray from, InputArray to) {return call("getAffineTransform", from, to).mat;}

/// Evens out the light of an image, tile by tile.
class CLAHE
{
public:
  CLAHE(double clip_limit, Size tiles)
  : clip_limit_(clip_limit), tiles_(tiles), object_("createCLAHE", kw("clipLimit", clip_limit), kw("tileGridSize", tiles)) {}
  void apply(InputArray src, OutputArray dst) {dst.assign(object_.call("apply", src));}
  void setClipLimit(double limit)
  {
    clip_limit_ = limit;
    object_.call("setClipLimit", limit);
  }
  double getClipLimit() const {return clip_limit_;}
  void setTilesGridSize(Size tiles)
  {
    tiles_ = tiles;
    object_.call("setTilesGridSize", tiles);
  }
  Size getTilesGridSize() const {return tiles_;}

private:
  double clip_limit_;
  Size tiles_;
  remote::Object object_;
};
inline Ptr<CLAHE> createCLAHE(double clipLimit = 40.0, Size tileGridSize = Size(8, 8))
{
  return makePtr<CLAHE>(clipLimit, tileGridSize);
}
}  // namespace cv
