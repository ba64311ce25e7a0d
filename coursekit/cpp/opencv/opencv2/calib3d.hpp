// Cameras: their lenses' distortion, and where points in space are seen.
#pragma once
#include "opencv2/core.hpp"
#include "opencv2/imgproc.hpp"

namespace cv
{
enum
{
  SOLVEPNP_ITERATIVE = 0, SOLVEPNP_EPNP = 1, SOLVEPNP_P3P = 2, SOLVEPNP_AP3P = 5, SOLVEPNP_IPPE = 6,
  SOLVEPNP_IPPE_SQUARE = 7,
};
/// Between a rotation's matrix and its axis times its angle.
inline void Rodrigues(InputArray src, OutputArray dst) {dst.assign(call("Rodrigues", src)[0].mat);}
inline void projectPoints(
  InputArray points, InputArray rvec, InputArray tvec, InputArray camera, InputArray distortion, OutputArray pixels)
{
  pixels.assign(call("projectPoints", points, rvec, tvec, camera, distortion)[0]);
}
inline bool solvePnP(
  InputArray points, InputArray pixels, InputArray camera, InputArray distortion, OutputArray rvec, OutputArray tvec,
  bool use_guess = false, int flags = SOLVEPNP_ITERATIVE)
{
  auto answer = use_guess ?
    call("solvePnP", points, pixels, camera, distortion, rvec, tvec, true, flags) :
    call("solvePnP", points, pixels, camera, distortion, kw("flags", flags));
  rvec.assign(answer[1].mat);
  tvec.assign(answer[2].mat);
  return answer[0].integer;
}
inline bool solvePnPRansac(
  InputArray points, InputArray pixels, InputArray camera, InputArray distortion, OutputArray rvec, OutputArray tvec)
{
  auto answer = call("solvePnPRansac", points, pixels, camera, distortion);
  rvec.assign(answer[1].mat);
  tvec.assign(answer[2].mat);
  return answer[0].integer;
}
/// The axes of what has a pose: x red, y green, z blue.
inline void drawFrameAxes(
  InputOutputArray image, InputArray camera, InputArray distortion, InputArray rvec, InputArray tvec, float length,
  int thickness = 3)
{
  image.assign(call("drawFrameAxes", image, camera, distortion, rvec, tvec, length, thickness));
}
inline bool findChessboardCorners(
  InputArray image, Size pattern, OutputArray corners, int flags = CALIB_CB_ADAPTIVE_THRESH + CALIB_CB_NORMALIZE_IMAGE)
{
  auto answer = call("findChessboardCorners", image, pattern, kw("flags", flags));
  corners.assign(answer[1]);
  return answer[0].integer;
}
inline void drawChessboardCorners(InputOutputArray image, Size pattern, InputArray corners, bool found)
{
  image.assign(call("drawChessboardCorners", image, pattern, corners, found));
}
/// A camera's matrix and distortion, of points on a board in several images; the mean error [pixels].
inline double calibrateCamera(
  InputArrayOfArrays points, InputArrayOfArrays pixels, Size size, InputOutputArray camera, InputOutputArray distortion,
  OutputArrayOfArrays rvecs, OutputArrayOfArrays tvecs, int flags = 0,
  TermCriteria end = TermCriteria(TermCriteria::COUNT + TermCriteria::EPS, 30, 2.220446049250313e-16))
{
  auto answer = call(
    "calibrateCamera", points, pixels, size, camera, distortion, kw("flags", flags), kw("criteria", end));
  camera.assign(answer[1]);
  distortion.assign(answer[2]);
  rvecs.assign(answer[3]);
  tvecs.assign(answer[4]);
  return answer[0].number();
}
inline Mat getOptimalNewCameraMatrix(
  InputArray camera, InputArray distortion, Size size, double alpha, Size new_size = Size(), Rect * roi = nullptr)
{
  auto answer = call("getOptimalNewCameraMatrix", camera, distortion, size, alpha, new_size);
  if (roi) {
    *roi = detail::rect_of(answer[1]);
  }
  return answer[0].mat;
}
inline Mat findHomography(
  InputArray from, InputArray to, int method = 0, double threshold = 3, OutputArray mask = noArray())
{
  auto answer = call("findHomography", from, to, method, threshold);
  mask.assign(answer[1]);
  return answer[0].mat;
}
inline Mat findHomography(InputArray from, InputArray to, OutputArray mask, int method = 0, double threshold = 3)
{
  return findHomography(from, to, method, threshold, mask);
}
inline Mat estimateAffine2D(
  InputArray from, InputArray to, OutputArray inliers = noArray(), int method = RANSAC, double threshold = 3)
{
  auto answer = call("estimateAffine2D", from, to, kw("method", method), kw("ransacReprojThreshold", threshold));
  inliers.assign(answer[1]);
  return answer[0].mat;
}
inline void undistort(
  InputArray src, OutputArray dst, InputArray camera, InputArray distortion, InputArray new_camera = noArray())
{
  dst.assign(call("undistort", src, camera, distortion, kw("newCameraMatrix", new_camera)));
}
inline void undistortPoints(
  InputArray src, OutputArray dst, InputArray camera, InputArray distortion, InputArray r = noArray(),
  InputArray p = noArray())
{
  dst.assign(call("undistortPoints", src, camera, distortion, kw("R", r), kw("P", p)));
}
inline void initUndistortRectifyMap(
  InputArray camera, InputArray distortion, InputArray r, InputArray new_camera, Size size, int type, OutputArray map1,
  OutputArray map2)
{
  auto maps = call("initUndistortRectifyMap", camera, distortion, r, new_camera, size, type);
  map1.assign(maps[0].mat);
  map2.assign(maps[1].mat);
}
/// Each pixel's point in space, of its disparity and a pair's 4x4 matrix.
inline void reprojectImageTo3D(
  InputArray disparity, OutputArray points, InputArray q, bool handle_missing = false, int ddepth = -1)
{
  points.assign(
    call("reprojectImageTo3D", disparity, q, kw("handleMissingValues", handle_missing), kw("ddepth", ddepth)));
}
}  // namespace cv

#include "opencv2/calib3d/two_views.hpp"
