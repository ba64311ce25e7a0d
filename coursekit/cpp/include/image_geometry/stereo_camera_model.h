// Two cameras side by side: how far something is, by how much it is shifted between their rectified images [pixels].
#pragma once
#include "image_geometry/pinhole_camera_model.h"

namespace image_geometry
{
class StereoCameraModel
{
public:
  /// The depth of pixels that have none.
  static constexpr double MISSING_Z = 10000.;
  bool fromCameraInfo(const sensor_msgs::msg::CameraInfo & left, const sensor_msgs::msg::CameraInfo & right)
  {
    const bool left_is_new = left_.fromCameraInfo(left);
    return right_.fromCameraInfo(right) || left_is_new;
  }
  bool fromCameraInfo(
    const sensor_msgs::msg::CameraInfo::ConstSharedPtr & left, const sensor_msgs::msg::CameraInfo::ConstSharedPtr & right)
  {
    return fromCameraInfo(*left, *right);
  }
  const PinholeCameraModel & left() const {return left_;}
  const PinholeCameraModel & right() const {return right_;}
  std::string tfFrame() const {return left_.tfFrame();}
  bool initialized() const {return left_.initialized() && right_.initialized();}
  /// Between the cameras [m].
  double baseline() const {return -right_.Tx() / right_.fx();}

  /// A point in the left camera's frame [m], of a pixel of its rectified image.
  void projectDisparityTo3d(const cv::Point2d & left_uv_rect, float disparity, cv::Point3d & xyz) const
  {
    const double z = getZ(disparity);
    xyz.x = (left_uv_rect.x - left_.cx()) * z / left_.fx();
    xyz.y = (left_uv_rect.y - left_.cy()) * z / left_.fy();
    xyz.z = z;
  }
  /// What makes a pixel and its disparity a point in space, up to its scale.
  cv::Matx44d reprojectionMatrix() const
  {
    const double fx = left_.fx(), fy = left_.fy(), tx = -baseline();
    return {
      fy * tx, 0, 0, -fy * left_.cx() * tx,
      0, fx * tx, 0, -fx * left_.cy() * tx,
      0, 0, 0, fx * fy * tx,
      0, 0, -fy, fy * (left_.cx() - right_.cx())};
  }
  /// The same for each pixel of an image of disparities; with `handle_missing` those without one get the depth MISSING_Z.
  void projectDisparityImageTo3d(const cv::Mat & disparity, cv::Mat & points, bool handle_missing = false) const
  {
    cv::reprojectImageTo3D(disparity, points, cv::Mat(reprojectionMatrix()), handle_missing);
  }
  double getZ(double disparity) const {return -right_.Tx() / (disparity - (left_.cx() - right_.cx()));}
  double getDisparity(double Z) const {return -right_.Tx() / Z + (left_.cx() - right_.cx());}
  /// How much a depth is off where a disparity is.
  double getDeltaZ(double Z, double deltad) const {return std::abs(Z * Z / (right_.fx() * baseline()) * deltad);}

private:
  PinholeCameraModel left_, right_;
};
}  // namespace image_geometry
