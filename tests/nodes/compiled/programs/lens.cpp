// image_geometry and camera_info_manager: a calibration from a file, and what a camera with it sees.
#include <iomanip>
#include <iostream>

#include "camera_info_manager/camera_info_manager.hpp"
#include "image_geometry/pinhole_camera_model.h"
#include "rclcpp/rclcpp.hpp"

static void print(const char * what, const cv::Point2d & uv)
{
  std::cout << what << " " << uv.x << " " << uv.y << std::endl;
}

static void see(const sensor_msgs::msg::CameraInfo & info)
{
  image_geometry::PinholeCameraModel camera;
  std::cout << camera.initialized() << camera.fromCameraInfo(info) << camera.fromCameraInfo(info) << camera.initialized()
            << std::endl;
  print("pixel", camera.project3dToPixel(cv::Point3d(0.1, -0.05, 2.0)));
  cv::Point3d ray = camera.projectPixelTo3dRay(cv::Point2d(100, 50));
  std::cout << "ray " << ray.x << " " << ray.y << " " << ray.z << std::endl;
  cv::Point2d rectified = camera.rectifyPoint(cv::Point2d(80, 60));
  print("rectified", rectified);
  print("back", camera.unrectifyPoint(rectified));
  std::cout << "numbers " << camera.fx() << " " << camera.cy() << " " << camera.Tx() << " " << camera.intrinsicMatrix()(0, 2)
            << " " << camera.distortionCoeffs().cols << " " << camera.fullProjectionMatrix()(0, 0) << " "
            << camera.tfFrame() << std::endl;
  cv::Mat raw(240, 320, CV_8UC1, cv::Scalar(0)), straight;
  raw.at<unsigned char>(60, 80) = 255;
  camera.rectifyImage(raw, straight);
  int lit = 0;
  for (int y = 0; y < straight.rows; ++y) {
    for (int x = 0; x < straight.cols; ++x) {
      lit += straight.at<unsigned char>(y, x) > 0 && std::hypot(x - rectified.x, y - rectified.y) < 2;
    }
  }
  std::cout << "lit " << (lit > 0) << std::endl;

  sensor_msgs::msg::CameraInfo half = info;
  half.binning_x = half.binning_y = 2;
  half.p[3] = -20;  // the right one of a pair
  half.roi.x_offset = 40;
  half.roi.width = half.roi.height = 100;
  camera.fromCameraInfo(half);
  print("binned", camera.project3dToPixel(cv::Point3d(0.1, -0.05, 2.0)));
  print("full", camera.toFullResolution(camera.project3dToPixel(cv::Point3d(0.1, -0.05, 2.0))));
  std::cout << camera.reducedResolution().width << std::endl;
  half.distortion_model = "odd";
  camera.fromCameraInfo(half);
  try {
    camera.rectifyPoint(cv::Point2d(1, 1));
  } catch (const image_geometry::Exception & error) {
    std::cout << error.what() << std::endl;
  }
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("camera");
  std::cout << std::setprecision(6);
  camera_info_manager::CameraInfoManager manager(node.get(), "eye", "file://" + std::string(argv[1]) + "/${NAME}.yaml");
  std::cout << manager.isCalibrated() << manager.validateURL("ftp://x") << manager.validateURL("package://a/b")
            << manager.setCameraName("not good") << std::endl;
  auto info = manager.getCameraInfo();
  info.header.frame_id = "optical";
  see(info);
  rclcpp::spin(node);
  std::cout << manager.getCameraInfo().k[0] << std::endl;
  rclcpp::shutdown();
}
