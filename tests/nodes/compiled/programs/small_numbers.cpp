// Small numbers are numbers too, a diagonal is a view, and what is asked of a function by its last arguments is done.
#include <cmath>
#include <iostream>
#include <opencv2/opencv.hpp>

static void inverses()
{
  const cv::Matx22f covariance(2e-8f, 0, 0, 1e-8f);
  bool there = false;
  const cv::Matx22f back = covariance.inv(cv::DECOMP_LU, &there);
  std::cout << there << " " << back(0, 0) << " " << back(1, 1) << " " << cv::determinant(covariance) << " "
            << cv::Matx33f(cv::Matx33f::eye() * 1e-8).inv(cv::DECOMP_CHOLESKY)(2, 2) << " "
            << cv::determinant(cv::Matx33d::eye() * 1e-12) << std::endl;
  const cv::Matx33d counted(1, 2, 3, 4, 5, 6, 7, 8, 9), turned(0, 2, 0, 0, 0, 4, 5, 0, 0);
  std::cout << cv::norm(counted.inv(cv::DECOMP_LU, &there)) << there << cv::determinant(counted) << " "
            << cv::determinant(turned) << cv::norm(turned.inv() * turned - cv::Matx33d::eye()) << " "
            << cv::norm(cv::Matx22d(1, 2, 3, 4).inv() * cv::Matx22d(1, 2, 3, 4) - cv::Matx22d::eye()) << " "
            << cv::determinant(cv::Matx44d::eye() * 2) << std::endl;
  const cv::Matx<double, 2, 1> tall(3, 4);
  std::cout << cvRound(1000 * tall.inv(cv::DECOMP_SVD)(0, 0)) << " " << cvRound(1000 * tall.inv(cv::DECOMP_SVD)(0, 1))
            << std::endl;
}
static void views()
{
  cv::Mat m = cv::Mat::zeros(3, 4, CV_8UC1);
  m.diag().setTo(1);
  m.diag(1).setTo(2);
  cv::Mat below = m.diag(-2);
  below.at<uchar>(0) = 3;
  std::cout << m << below.rows << below.cols << m.diag().isContinuous() << m.diag(1).t() << cv::sum(m.diag(1))[0] << std::endl;
  cv::Mat part = m(cv::Rect(1, 1, 2, 2));
  cv::Mat diagonal = part.diag();
  diagonal += cv::Scalar(4);
  cv::Mat::zeros(3, 1, CV_8UC1).copyTo(m.diag(1));
  std::cout << m << m.diag().clone().t() << std::endl;
}
static void components()
{
  cv::Mat data(40, 3, CV_64F);
  cv::RNG rng(3);
  for (int y = 0; y < data.rows; ++y) {
    data.at<double>(y, 0) = rng.uniform(-10.0, 10.0);
    data.at<double>(y, 1) = rng.uniform(-3.0, 3.0);
    data.at<double>(y, 2) = rng.uniform(-0.1, 0.1);
  }
  cv::PCA some(data, cv::Mat(), cv::PCA::DATA_AS_ROW, 0.95);
  std::cout << some.eigenvectors.rows << some(data, cv::Mat(), cv::PCA::DATA_AS_ROW, 0.5).eigenvectors.rows
            << some(data, cv::Mat(), cv::PCA::DATA_AS_ROW, 1).eigenvectors.rows
            << some(data, cv::Mat(), cv::PCA::DATA_AS_ROW).eigenvectors.rows << std::endl;
}
static void ranges()
{
  cv::Mat numbers = cv::Mat::zeros(2, 3, CV_32F);
  cv::Point place(-1, -1);
  std::cout << cv::checkRange(numbers, true, &place) << place << cv::checkRange(numbers, false) << " ";
  numbers.at<float>(1, 2) = std::nanf("");
  std::cout << cv::checkRange(numbers, true, &place) << place << " ";
  numbers.at<float>(0, 1) = 7;
  try {
    cv::checkRange(numbers, false, &place, -1, 5);
  } catch (const cv::Exception &) {
    std::cout << "refused " << place << std::endl;
  }
}
int main()
{
  inverses();
  views();
  components();
  ranges();
}
