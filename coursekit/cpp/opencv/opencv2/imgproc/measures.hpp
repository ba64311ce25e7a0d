// What is measured in images: corners, distances, histograms, where a piece is found again.
#pragma once
#include "opencv2/core.hpp"

namespace cv
{
/// How alike an image is to a small one at each place.
inline void matchTemplate(InputArray image, InputArray small, OutputArray result, int method, InputArray mask = noArray())
{
  result.assign(call("matchTemplate", image, small, method, kw("mask", mask)));
}
inline void goodFeaturesToTrack(
  InputArray image, OutputArray corners, int most, double quality, double apart, InputArray mask = noArray(), int block = 3,
  bool harris = false, double k = 0.04)
{
  corners.assign(
    call("goodFeaturesToTrack", image, most, quality, apart, kw("mask", mask), kw("blockSize", block),
      kw("useHarrisDetector", harris), kw("k", k)));
}
inline void cornerHarris(InputArray src, OutputArray dst, int block, int size, double k, int border = BORDER_DEFAULT)
{
  dst.assign(call("cornerHarris", src, block, size, k, kw("borderType", border)));
}
inline void cornerSubPix(InputArray image, InputOutputArray corners, Size window, Size zero, TermCriteria end)
{
  corners.assign(call("cornerSubPix", image, corners, window, zero, end));
}
inline void distanceTransform(InputArray src, OutputArray dst, int kind, int size, int type = CV_32F)
{
  dst.assign(call("distanceTransform", src, kind, size, kw("dstType", type)));
}
inline void distanceTransform(
  InputArray src, OutputArray dst, OutputArray labels, int kind, int size, int labelling = DIST_LABEL_CCOMP)
{
  auto found = call("distanceTransformWithLabels", src, kind, size, kw("labelType", labelling));
  dst.assign(found[0]);
  labels.assign(found[1]);
}
inline void watershed(InputArray image, InputOutputArray markers) {markers.assign(call("watershed", image, markers));}
inline void fitLine(InputArray points, OutputArray line, int kind, double param, double reps, double aeps)
{
  line.assign(call("fitLine", points, kind, param, reps, aeps));
}
inline double matchShapes(InputArray a, InputArray b, int method, double parameter)
{
  return call("matchShapes", a, b, method, parameter).number();
}
inline void convexityDefects(InputArray contour, InputArray hull, OutputArray defects)
{
  defects.assign(call("convexityDefects", contour, hull));
}
inline void pyrDown(InputArray src, OutputArray dst, Size size = Size(), int border = BORDER_DEFAULT)
{
  dst.assign(call("pyrDown", src, kw("dstsize", size), kw("borderType", border)));
}
inline void pyrUp(InputArray src, OutputArray dst, Size size = Size(), int border = BORDER_DEFAULT)
{
  dst.assign(call("pyrUp", src, kw("dstsize", size), kw("borderType", border)));
}
inline void integral(InputArray src, OutputArray sums, int depth = -1)
{
  sums.assign(call("integral", src, kw("sdepth", depth)));
}
inline void accumulateWeighted(InputArray src, InputOutputArray dst, double alpha, InputArray mask = noArray())
{
  dst.assign(call("accumulateWeighted", src, dst, alpha, kw("mask", mask)));
}
inline void Scharr(
  InputArray src, OutputArray dst, int depth, int dx, int dy, double scale = 1, double delta = 0, int border = BORDER_DEFAULT)
{
  dst.assign(call("Scharr", src, depth, dx, dy, kw("scale", scale), kw("delta", delta), kw("borderType", border)));
}
inline void calcHist(
  const std::vector<Mat> & images, const std::vector<int> & channels, InputArray mask, OutputArray histogram,
  const std::vector<int> & sizes, const std::vector<float> & ranges)
{
  histogram.assign(call("calcHist", images, channels, mask, sizes, ranges));
}
inline void calcHist(
  const Mat * images, int count, const int * channels, InputArray mask, OutputArray histogram, int dims, const int * sizes,
  const float ** ranges, bool = true, bool = false)
{
  std::vector<float> limits;
  for (int i = 0; i < dims; ++i) {
    limits.insert(limits.end(), ranges[i], ranges[i] + 2);
  }
  auto chosen = channels ? std::vector<int>(channels, channels + dims) : std::vector<int>{0};
  calcHist(std::vector<Mat>(images, images + count), chosen, mask, histogram, std::vector<int>(sizes, sizes + dims), limits);
}
inline double compareHist(InputArray a, InputArray b, int method) {return call("compareHist", a, b, method).number();}
}  // namespace cv
