// A camera as its CameraInfo tells of it: where points are seen, and what may be seen at a pixel.
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "opencv2/calib3d/calib3d.hpp"
#include "opencv2/core/core.hpp"
#include "opencv2/imgproc/imgproc.hpp"
#include "rclcpp/time.hpp"
#include "sensor_msgs/msg/camera_info.hpp"

namespace image_geometry
{
class Exception : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class PinholeCameraModel
{
public:
  using CameraInfo = sensor_msgs::msg::CameraInfo;
  /// Take all from a message, with its region of interest and its binning; whether anything has changed.
  bool fromCameraInfo(const CameraInfo & message)
  {
    CameraInfo info = message;
    if (info.roi == sensor_msgs::msg::RegionOfInterest()) {  // the whole image
      info.roi.width = info.width;
      info.roi.height = info.height;
    }
    bool same = initialized_ && same_camera(info);
    info_ = info;
    initialized_ = true;
    if (!same) {
      take_matrices();
    }
    return !same;
  }
  bool fromCameraInfo(const CameraInfo::ConstSharedPtr & message) {return fromCameraInfo(*message);}
  bool initialized() const {return initialized_;}
  const CameraInfo & cameraInfo() const {return info_;}
  std::string tfFrame() const {return info_.header.frame_id;}
  rclcpp::Time stamp() const {return rclcpp::Time(info_.header.stamp);}

  // -- the sensor's whole image, and what is sent of it

  cv::Size fullResolution() const {return cv::Size(static_cast<int>(info_.width), static_cast<int>(info_.height));}
  cv::Size reducedResolution() const
  {
    cv::Rect roi = rectifiedRoi();
    return cv::Size(roi.width / static_cast<int>(binningX()), roi.height / static_cast<int>(binningY()));
  }
  cv::Point2d toFullResolution(const cv::Point2d & uv) const
  {
    cv::Rect roi = rectifiedRoi();
    return cv::Point2d(uv.x * binningX() + roi.x, uv.y * binningY() + roi.y);
  }
  cv::Point2d toReducedResolution(const cv::Point2d & uv) const
  {
    cv::Rect roi = rectifiedRoi();
    return cv::Point2d((uv.x - roi.x) / binningX(), (uv.y - roi.y) / binningY());
  }
  cv::Rect toFullResolution(const cv::Rect & part) const
  {
    const int x = static_cast<int>(binningX()), y = static_cast<int>(binningY());
    cv::Rect roi = rectifiedRoi();
    return cv::Rect(part.x * x + roi.x, part.y * y + roi.y, part.width * x, part.height * y);
  }
  cv::Rect toReducedResolution(const cv::Rect & part) const
  {
    const int x = static_cast<int>(binningX()), y = static_cast<int>(binningY());
    cv::Rect roi = rectifiedRoi();
    return cv::Rect((part.x - roi.x) / x, (part.y - roi.y) / y, part.width / x, part.height / y);
  }
  cv::Rect rawRoi() const
  {
    auto & roi = info_.roi;
    return cv::Rect(
      static_cast<int>(roi.x_offset), static_cast<int>(roi.y_offset), static_cast<int>(roi.width), static_cast<int>(roi.height));
  }
  cv::Rect rectifiedRoi() const {return info_.roi.do_rectify ? rectifyRoi(rawRoi()) : rawRoi();}
  uint32_t binningX() const {return std::max(1u, info_.binning_x);}
  uint32_t binningY() const {return std::max(1u, info_.binning_y);}

  // -- pixels and rays

  /// The pixel of the rectified image at which a point of the camera's frame [m] is seen.
  cv::Point2d project3dToPixel(const cv::Point3d & xyz) const
  {
    return cv::Point2d((fx() * xyz.x + Tx()) / xyz.z + cx(), (fy() * xyz.y + Ty()) / xyz.z + cy());
  }
  /// The way to what is seen at a pixel of the rectified image, as far as z = 1.
  cv::Point3d projectPixelTo3dRay(const cv::Point2d & uv) const
  {
    return cv::Point3d((uv.x - cx() - Tx()) / fx(), (uv.y - cy() - Ty()) / fy(), 1.0);
  }
  /// Where a pixel of the image as it was taken lies in the rectified one.
  cv::Point2d rectifyPoint(const cv::Point2d & uv_raw) const
  {
    if (!is_distorted("rectifyPoint")) {
      return uv_raw;
    }
    std::vector<cv::Point2f> raw{cv::Point2f(static_cast<float>(uv_raw.x), static_cast<float>(uv_raw.y))}, rectified;
    cv::undistortPoints(raw, rectified, k_, d_, r_, p_);
    return cv::Point2d(rectified[0].x, rectified[0].y);
  }
  cv::Point2d unrectifyPoint(const cv::Point2d & uv_rect) const
  {
    if (!is_distorted("unrectifyPoint")) {
      return uv_rect;
    }
    cv::Mat turn, none = cv::Mat::zeros(3, 1, CV_64F);
    cv::Rodrigues(cv::Mat(r_.t()), turn);
    std::vector<cv::Point3d> rays{projectPixelTo3dRay(uv_rect)};
    std::vector<cv::Point2d> raw;
    cv::projectPoints(rays, turn, none, k_, d_, raw);
    return raw[0];
  }
  cv::Rect rectifyRoi(const cv::Rect & roi) const {return around(roi, &PinholeCameraModel::rectifyPoint);}
  cv::Rect unrectifyRoi(const cv::Rect & roi) const {return around(roi, &PinholeCameraModel::unrectifyPoint);}
  /// The image without the lens's distortion.
  void rectifyImage(const cv::Mat & raw, cv::Mat & rectified, int interpolation = cv::INTER_LINEAR) const
  {
    if (!is_distorted("rectifyImage")) {
      raw.copyTo(rectified);
      return;
    }
    cv::Mat x, y;
    cv::initUndistortRectifyMap(k_, d_, r_, p_, raw.size(), CV_32FC1, x, y);
    cv::Mat made;
    cv::remap(raw, made, x, y, interpolation);
    rectified = made;
  }
  void unrectifyImage(const cv::Mat & rectified, cv::Mat & raw, int = cv::INTER_LINEAR) const
  {
    if (is_distorted("unrectifyImage")) {
      throw Exception("PinholeCameraModel::unrectifyImage is unimplemented.");
    }
    rectified.copyTo(raw);
  }
  /// Between a size in space at the distance Z [m] and one in pixels.
  double getDeltaU(double deltaX, double Z) const {return fx() * deltaX / Z;}
  double getDeltaV(double deltaY, double Z) const {return fy() * deltaY / Z;}
  double getDeltaX(double deltaU, double Z) const {return Z * deltaU / fx();}
  double getDeltaY(double deltaV, double Z) const {return Z * deltaV / fy();}

  // -- numbers

  const cv::Matx33d & intrinsicMatrix() const {return k_;}
  const cv::Mat_<double> & distortionCoeffs() const {return d_;}
  const cv::Matx33d & rotationMatrix() const {return r_;}
  const cv::Matx34d & projectionMatrix() const {return p_;}
  const cv::Matx33d & fullIntrinsicMatrix() const {return k_full_;}
  const cv::Matx34d & fullProjectionMatrix() const {return p_full_;}
  double fx() const {return p_(0, 0);}
  double fy() const {return p_(1, 1);}
  double cx() const {return p_(0, 2);}
  double cy() const {return p_(1, 2);}
  double Tx() const {return p_(0, 3);}
  double Ty() const {return p_(1, 3);}

private:
  bool same_camera(const CameraInfo & o) const
  {
    return info_.k == o.k && info_.d == o.d && info_.r == o.r && info_.p == o.p && info_.roi == o.roi &&
           info_.width == o.width && info_.height == o.height && info_.binning_x == o.binning_x &&
           info_.binning_y == o.binning_y && info_.distortion_model == o.distortion_model;
  }
  void take_matrices()
  {
    k_ = k_full_ = cv::Matx33d(info_.k.data());
    r_ = cv::Matx33d(info_.r.data());
    p_ = p_full_ = cv::Matx34d(info_.p.data());
    d_ = cv::Mat_<double>(info_.d.empty() ? 0 : 1, static_cast<int>(info_.d.size()));
    for (size_t i = 0; i < info_.d.size(); ++i) {
      d_(0, static_cast<int>(i)) = info_.d[i];
    }
    shift_and_shrink(k_, 3, rawRoi());
    shift_and_shrink(p_, 4, rectifiedRoi());
  }
  /// To the pixels of the image that is sent: a part of the sensor's, and fewer.
  template<class M>
  void shift_and_shrink(M & matrix, int columns, const cv::Rect & roi) const
  {
    matrix(0, 2) -= roi.x;
    matrix(1, 2) -= roi.y;
    for (int x = 0; x < columns; ++x) {
      matrix(0, x) /= binningX();
      matrix(1, x) /= binningY();
    }
  }
  /// Whether the lens distorts. Throws Exception where that is not known.
  bool is_distorted(const char * asked) const
  {
    if (std::all_of(info_.d.begin(), info_.d.end(), [](double one) {return one == 0;})) {
      return false;
    }
    auto & model = info_.distortion_model;
    if (model != "plumb_bob" && model != "rational_polynomial") {
      throw Exception(std::string("Cannot call ") + asked + " when distortion is unknown.");
    }
    return true;
  }
  cv::Rect around(const cv::Rect & roi, cv::Point2d (PinholeCameraModel::* moved)(const cv::Point2d &) const) const
  {
    const double left = roi.x, top = roi.y, right = roi.x + roi.width, bottom = roi.y + roi.height;
    auto a = (this->*moved)({left, top}), b = (this->*moved)({right, top});
    auto c = (this->*moved)({right, bottom}), d = (this->*moved)({left, bottom});
    cv::Point low(
      static_cast<int>(std::ceil(std::min(a.x, d.x))), static_cast<int>(std::ceil(std::min(a.y, b.y))));
    cv::Point high(
      static_cast<int>(std::floor(std::max(b.x, c.x))), static_cast<int>(std::floor(std::max(c.y, d.y))));
    return cv::Rect(low.x, low.y, high.x - low.x, high.y - low.y);
  }

  bool initialized_ = false;
  CameraInfo info_;
  cv::Mat_<double> d_;
  cv::Matx33d r_, k_, k_full_;
  cv::Matx34d p_, p_full_;
};
}  // namespace image_geometry
