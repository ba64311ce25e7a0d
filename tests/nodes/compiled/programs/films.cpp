// A film, written and read again; the pixels that are lit; and a pair of cameras that see how far they are.
#include <iostream>
#include <opencv2/opencv.hpp>

#include "image_geometry/stereo_camera_model.h"

static void film()
{
  cv::VideoWriter none, writer;
  std::cout << none.isOpened() << (cv::VideoWriter::fourcc('M', 'J', 'P', 'G') == 1196444237) << std::endl;
  writer.open("film.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 15.0, cv::Size(64, 48), true);
  cv::Mat picture(48, 64, CV_8UC3);
  for (int i = 0; i < 3; ++i) {
    picture.setTo(cv::Scalar(40 * i, 100, 200));
    writer << picture;
  }
  std::cout << writer.isOpened();
  writer.release();
  std::cout << writer.isOpened() << std::endl;
  cv::VideoCapture reader("film.avi");
  int count = 0;
  for (cv::Mat one; reader.read(one); ++count) {
    picture = one.clone();
  }
  std::cout << count << " " << reader.get(cv::CAP_PROP_FPS) << " " << picture.size()
            << (std::abs(cv::mean(picture)[0] - 80) < 4) << std::endl;
}
static void lit()
{
  cv::Mat dark = cv::Mat::zeros(6, 8, CV_8UC1);
  std::vector<cv::Point> places;
  cv::findNonZero(dark, places);
  std::cout << places.size();
  dark.at<uchar>(2, 5) = dark.at<uchar>(4, 1) = 9;
  cv::findNonZero(dark, places);
  std::cout << places << cv::boundingRect(places) << std::endl;
}
static void depth()
{
  sensor_msgs::msg::CameraInfo left, right;
  left.width = right.width = 8;
  left.height = right.height = 6;
  left.k = {100, 0, 4, 0, 200, 3, 0, 0, 1};
  left.p = {100, 0, 4, 0, 0, 200, 3, 0, 0, 0, 1, 0};
  right = left;
  right.p[3] = -10;  // 0.1 m to the right
  image_geometry::StereoCameraModel pair;
  pair.fromCameraInfo(left, right);
  cv::Mat disparity(6, 8, CV_32FC1, cv::Scalar(5.0)), points;
  disparity.at<float>(0, 0) = -1;
  pair.projectDisparityImageTo3d(disparity, points, true);
  cv::Point3d one;
  pair.projectDisparityTo3d(cv::Point2d(6, 4), 5.0f, one);
  cv::Vec3f same = points.at<cv::Vec3f>(4, 6);
  std::cout << (cv::norm(cv::Vec3f(float(one.x), float(one.y), float(one.z)) - same) < 1e-5) << " " << same << " "
            << points.at<cv::Vec3f>(0, 0)[2] << " " << pair.reprojectionMatrix()(3, 2) << std::endl;
  left.binning_x = 2;
  left.roi.x_offset = 4;
  left.roi.width = left.roi.height = 4;
  image_geometry::PinholeCameraModel part;
  part.fromCameraInfo(left);
  std::cout << part.toFullResolution(cv::Rect(1, 1, 1, 2)) << part.toReducedResolution(cv::Rect(6, 1, 2, 2)) << std::endl;
}
int main()
{
  film();
  lit();
  depth();
}
