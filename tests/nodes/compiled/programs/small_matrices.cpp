// Vectors and matrices whose sizes the compiler knows: computed with, given to OpenCV's functions, and written by them.
#include <Eigen/Dense>
#include <iostream>
#include <opencv2/core/eigen.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/core/version.hpp>
#include <opencv2/opencv.hpp>

static void vectors()
{
  const cv::Vec3d x(1, 2, 3), y(-2, 0, 1);
  const cv::Vec3f narrow = x;
  cv::Vec3d scaled = 2.0 * x;
  scaled *= 2;
  scaled /= 4;
  std::cout << x.dot(y) << x.cross(y) << x.mul(y) << -x << narrow << scaled << cv::normalize(cv::Vec2d(3, 4)) << std::endl;
  std::cout << cv::Vec3b(250, 0, 7) * 2 << cv::Vec6d(1, 2, 3, 4, 5, 6).ddot(cv::Vec6d::all(1)) << std::endl;
}
static void matrices()
{
  const cv::Matx33d camera(200, 0, 160, 0, 250, 120, 0, 0, 1);
  const cv::Matx33d back = camera.inv();
  std::cout << back(0, 0) << " " << back(0, 2) << " " << cv::norm(camera * back - cv::Matx33d::eye()) << " "
            << cv::determinant(camera) << " " << cv::trace(camera) << std::endl;
  bool invertible = true;
  std::cout << cv::norm(cv::Matx22d(1, 2, 2, 4).inv(cv::DECOMP_LU, &invertible)) << invertible
            << cv::Matx22d(0, 2, 4, 0).solve(cv::Vec2d(6, 8)) << std::endl;
  std::cout << camera.diag() << camera.row(1) << camera.col(2).t() << camera.get_minor<2, 2>(0, 1) << std::endl;
  std::cout << cv::Matx22f(1, 2, 3, 4).mul(cv::Matx22f::all(2)) << (-2 * cv::Matx12d(1, 3)) / 4 << cv::Matx44f::eye().diag()
            << cv::Matx22d(cv::Matx22f(1, 2, 3, 4)).dot(cv::Matx22d::ones()) << std::endl;
}
static void outputs()
{
  const cv::Matx33d camera(200, 0, 160, 0, 200, 120, 0, 0, 1);
  const std::vector<cv::Point3d> corners{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(corners, cv::Vec3d(0, 0, 0.5), cv::Vec3d(0.25, 0, 4), camera, cv::noArray(), pixels);
  cv::Vec3d turn, place;
  std::cout << cv::solvePnP(corners, pixels, camera, cv::noArray(), turn, place);
  cv::solvePnP(corners, pixels, camera, cv::noArray(), turn, place, true);
  cv::Matx33d matrix;
  cv::Rodrigues(turn, matrix);
  std::cout << " " << cvRound(1000 * turn[2]) << " " << cvRound(1000 * place[0]) << " " << cvRound(1000 * place[2]) << " "
            << cvRound(1000 * matrix(1, 0)) << std::endl;
}
static void whole()
{
  const cv::Mat a = (cv::Mat_<double>(2, 2) << 1, 2, 3, 4);
  const cv::Matx22d small = a;
  const cv::Vec2f column = a.col(1);
  std::cout << a.mul(a, 0.5) << a.dot(a) << a.diag().t() << a.diag(1) << cv::Mat::diag(a.col(0)) << std::endl;
  std::cout << small << column << cv::Mat(cv::Vec3f(1, 0, 0)).cross(cv::Mat(cv::Vec3f(0, 1, 0))).t() << std::endl;
  try {
    const cv::Vec3d wrong = a;
    std::cout << wrong << std::endl;
  } catch (const cv::Exception & refused) {
    std::cout << "refused " << refused.code << std::endl;
  }
}
static void eigen()
{
  Eigen::Matrix2d fixed;
  Eigen::MatrixXf grown;
  cv::Mat back, row = (cv::Mat_<float>(1, 3) << 1, 2, 3);
  cv::cv2eigen(cv::Matx22d(1, 2, 3, 4), fixed);
  cv::cv2eigen(row, grown);
  cv::eigen2cv(fixed, back);
  cv::Matx22d small;
  cv::eigen2cv(fixed, small);
  std::cout << fixed(0, 1) << grown.cols() << grown(0, 2) << back << small << (back.type() == CV_64FC1) << std::endl;
}
int main()
{
  vectors();
  matrices();
  outputs();
  whole();
  eigen();
  const auto before = cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_ERROR);
  std::cout << before << cv::utils::logging::getLogLevel() << CV_VERSION_MAJOR << (int64{1} << 40) << std::endl;
}
