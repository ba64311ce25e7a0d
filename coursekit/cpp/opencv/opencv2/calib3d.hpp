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
