// Two views of one scene: how the camera moved between them, where points are in space, and pairs of cameras.
#pragma once
#include "opencv2/calib3d.hpp"

namespace cv
{
/// Turn, scale and shift of points in the plane, 2 x 3.
inline Mat estimateAffinePartial2D(
  InputArray from, InputArray to, OutputArray inliers = noArray(), int method = RANSAC, double threshold = 3,
  size_t max_iterations = 2000, double confidence = 0.99, size_t refinements = 10)
{
  auto answer = call(
    "estimateAffinePartial2D", from, to, kw("method", method), kw("ransacReprojThreshold", threshold),
    kw("maxIters", max_iterations), kw("confidence", confidence), kw("refineIters", refinements));
  inliers.assign(answer[1]);
  return answer[0].mat;
}
inline Mat findFundamentalMat(
  InputArray points1, InputArray points2, int method = FM_RANSAC, double threshold = 3, double confidence = 0.99,
  OutputArray mask = noArray())
{
  auto answer = call("findFundamentalMat", points1, points2, method, threshold, confidence);
  mask.assign(answer[1]);
  return answer[0].mat;
}
inline Mat findFundamentalMat(
  InputArray points1, InputArray points2, OutputArray mask, int method = FM_RANSAC, double threshold = 3,
  double confidence = 0.99)
{
  return findFundamentalMat(points1, points2, method, threshold, confidence, mask);
}
inline Mat findEssentialMat(
  InputArray points1, InputArray points2, InputArray camera, int method = RANSAC, double confidence = 0.999,
  double threshold = 1, OutputArray mask = noArray())
{
  auto answer = call(
    "findEssentialMat", points1, points2, camera, kw("method", method), kw("prob", confidence), kw("threshold", threshold));
  mask.assign(answer[1]);
  return answer[0].mat;
}
namespace detail
{
inline Matx33d camera_of(double focal, Point2d centre) {return {focal, 0, centre.x, 0, focal, centre.y, 0, 0, 1};}
}  // namespace detail
inline Mat findEssentialMat(
  InputArray points1, InputArray points2, double focal = 1, Point2d centre = Point2d(0, 0), int method = RANSAC,
  double confidence = 0.999, double threshold = 1, OutputArray mask = noArray())
{
  return findEssentialMat(points1, points2, detail::camera_of(focal, centre), method, confidence, threshold, mask);
}
/// The camera's turn and the direction of its shift; how many points are before both cameras.
inline int recoverPose(
  InputArray essential, InputArray points1, InputArray points2, InputArray camera, OutputArray turn, OutputArray shift,
  InputOutputArray mask = noArray())
{
  auto answer = mask.getMat().empty() ?
    call("recoverPose", essential, points1, points2, camera) :
    call("recoverPose", essential, points1, points2, camera, kw("mask", mask));
  turn.assign(answer[1]);
  shift.assign(answer[2]);
  mask.assign(answer[3]);
  return static_cast<int>(answer[0].integer);
}
inline int recoverPose(
  InputArray essential, InputArray points1, InputArray points2, OutputArray turn, OutputArray shift, double focal = 1,
  Point2d centre = Point2d(0, 0), InputOutputArray mask = noArray())
{
  return recoverPose(essential, points1, points2, detail::camera_of(focal, centre), turn, shift, mask);
}
/// Points in space, a column of four numbers each, of the 3 x 4 matrices of two cameras.
inline void triangulatePoints(
  InputArray camera1, InputArray camera2, InputArray points1, InputArray points2, OutputArray points)
{
  points.assign(call("triangulatePoints", camera1, camera2, points1, points2));
}
inline void computeCorrespondEpilines(InputArray points, int image, InputArray fundamental, OutputArray lines)
{
  lines.assign(call("computeCorrespondEpilines", points, image, fundamental));
}
inline void stereoRectify(
  InputArray camera1, InputArray distortion1, InputArray camera2, InputArray distortion2, Size size, InputArray turn,
  InputArray shift, OutputArray r1, OutputArray r2, OutputArray p1, OutputArray p2, OutputArray q,
  int flags = CALIB_ZERO_DISPARITY, double alpha = -1, Size new_size = Size(), Rect * roi1 = nullptr, Rect * roi2 = nullptr)
{
  auto answer = call(
    "stereoRectify", camera1, distortion1, camera2, distortion2, size, turn, shift, kw("flags", flags), kw("alpha", alpha),
    kw("newImageSize", new_size));
  const _OutputArray * outputs[] = {&r1, &r2, &p1, &p2, &q};
  for (size_t i = 0; i < 5; ++i) {
    outputs[i]->assign(answer[i]);
  }
  Rect * rois[] = {roi1, roi2};
  for (size_t i = 0; i < 2; ++i) {
    if (rois[i]) {
      *rois[i] = detail::rect_of(answer[5 + i]);
    }
  }
}

/// Finds how far each pixel is shifted between the images of a pair, in sixteenths of a pixel.
class StereoMatcher
{
public:
  template<class ... A>
  explicit StereoMatcher(const char * kind, const A & ... arguments)
  : object_(kind, arguments ...) {}
  void compute(InputArray left, InputArray right, OutputArray disparity)
  {
    disparity.assign(object_.call("compute", left, right));
  }
#define COURSEKIT_SETTING(name) \
  void set ## name(int value) {object_.call("set" #name, value);} \
  int get ## name() const {return static_cast<int>(object_.call("get" #name).integer);}
  COURSEKIT_SETTING(MinDisparity)
  COURSEKIT_SETTING(NumDisparities)
  COURSEKIT_SETTING(BlockSize)
  COURSEKIT_SETTING(SpeckleWindowSize)
  COURSEKIT_SETTING(SpeckleRange)
  COURSEKIT_SETTING(Disp12MaxDiff)
  COURSEKIT_SETTING(PreFilterCap)
  COURSEKIT_SETTING(UniquenessRatio)

protected:
  mutable remote::Object object_;
};
class StereoBM : public StereoMatcher
{
public:
  using StereoMatcher::StereoMatcher;
  static Ptr<StereoBM> create(int disparities = 0, int block = 21)
  {
    return makePtr<StereoBM>("StereoBM_create", disparities, block);
  }
  COURSEKIT_SETTING(PreFilterType)
  COURSEKIT_SETTING(PreFilterSize)
  COURSEKIT_SETTING(TextureThreshold)
};
class StereoSGBM : public StereoMatcher
{
public:
  enum {MODE_SGBM, MODE_HH, MODE_SGBM_3WAY, MODE_HH4};
  using StereoMatcher::StereoMatcher;
  static Ptr<StereoSGBM> create(
    int least = 0, int disparities = 16, int block = 3, int p1 = 0, int p2 = 0, int disp12 = 0, int cap = 0, int unique = 0,
    int speckle_size = 0, int speckle_range = 0, int mode = MODE_SGBM)
  {
    return makePtr<StereoSGBM>(
      "StereoSGBM_create", least, disparities, block, p1, p2, disp12, cap, unique, speckle_size, speckle_range, mode);
  }
  COURSEKIT_SETTING(P1)
  COURSEKIT_SETTING(P2)
  COURSEKIT_SETTING(Mode)
};
#undef COURSEKIT_SETTING
}  // namespace cv
