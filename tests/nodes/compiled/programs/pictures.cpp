// What a program does with cv::Mat, and what it asks of cv2; it prints what the test compares with Python's.
#include <iomanip>
#include <iostream>
#include <opencv2/opencv.hpp>

static void memory()
{
  cv::Mat a(4, 5, CV_8UC1, cv::Scalar(7)), shared = a, copy = a.clone();
  a.at<uchar>(1, 2) = 9;
  cv::Mat part = a(cv::Rect(1, 1, 3, 2));
  part.setTo(cv::Scalar(1));
  std::cout << int(shared.at<uchar>(1, 2)) << int(copy.at<uchar>(1, 2)) << int(a.at<uchar>(3, 0)) << part.isContinuous()
            << part.isSubmatrix() << a.isContinuous() << " " << part.size() << part.step << a.row(1) << " "
            << (part.datastart == a.data) << (part.dataend - copy.datastart == a.dataend - copy.datastart)
            << a.dataend - a.datastart << std::endl;
  cv::Mat colour(2, 2, CV_8UC3, cv::Scalar(1, 2, 3)), real;
  colour.at<cv::Vec3b>(1, 0)[2] = 200;
  colour.convertTo(real, CV_32F, 2.0, 0.5);
  std::cout << real.at<cv::Vec3f>(1, 0) << colour.type() << real.type() << CV_64FC2 << " " << colour.elemSize()
            << colour.channels()
            << colour.total() << colour.reshape(1).cols << std::endl;
  cv::Mat matrix = (cv::Mat_<double>(2, 3) << 1, 2, 3, 4, 5, 6);
  std::cout << matrix << cv::Mat(matrix.t()).at<double>(2, 1) << cv::Mat::eye(2, 2, CV_32F) << cv::Mat(matrix * 0.5).at<double>(1, 2)
            << std::endl;
  std::cout << cv::Mat(matrix.row(0) / 3) << cv::Mat(1, 2, CV_32F, cv::Scalar(0.4))
            << cv::Matx<double, 1, 2>(0.1, 2) << 1.0 / 3 << std::endl;
  int sum = 0;
  for (auto it = a.begin<uchar>(); it != a.end<uchar>(); ++it) {sum += *it;}
  std::cout << sum << " " << cv::Mat().empty() << int(cv::saturate_cast<uchar>(300.2))
            << int(cv::saturate_cast<uchar>(2.5)) << std::endl;
  try {
    a(cv::Rect(3, 3, 9, 9));
  } catch (const cv::Exception & error) {
    std::cout << "refused " << error.code << std::endl;
  }
}
static void asked()
{
  cv::Mat image(60, 80, CV_8UC3, cv::Scalar(10, 20, 30)), grey, edges, small, mask;
  cv::rectangle(image, cv::Rect(10, 10, 30, 20), cv::Scalar(0, 0, 255), cv::FILLED);
  cv::circle(image(cv::Rect(40, 20, 40, 40)), {20, 20}, 8, {255, 0, 0}, -1);
  cv::line(image, {0, 59}, {79, 59}, {0, 255, 0});
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::Canny(grey, edges, 50, 150);
  cv::resize(image, small, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
  std::cout << cv::sum(image)[2] << " " << cv::countNonZero(edges) << " " << small.size() << cv::mean(grey)[0] << std::endl;
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> hierarchy;
  double limit = cv::threshold(grey, mask, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  cv::inRange(image, cv::Scalar(0, 0, 200), cv::Scalar(50, 50, 255), mask);
  cv::findContours(mask, contours, hierarchy, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  auto moments = cv::moments(contours.at(0));
  std::cout << limit << " " << contours.size() << hierarchy.size() << cv::boundingRect(contours[0])
            << cv::contourArea(contours[0])
            << " " << moments.m10 / moments.m00 << std::endl;
  cv::drawContours(image, contours, -1, cv::Scalar(255, 255, 255), 2);
  std::vector<cv::Mat> parts;
  cv::split(image, parts);
  cv::Mat joined, flipped;
  cv::merge(parts, joined);
  cv::flip(joined, flipped, 1);
  double low, high;
  cv::Point at;
  cv::minMaxLoc(parts[0], &low, &high, nullptr, &at);
  std::cout << cv::norm(joined, image) << low << high << at << " " << int(flipped.at<cv::Vec3b>(59, 0)[1]) << std::endl;
  cv::GaussianBlur(image, image, cv::Size(5, 5), 1.5);
  std::vector<uchar> bytes;
  bool encoded = cv::imencode(".png", image, bytes);
  std::cout << encoded << (cv::norm(cv::imdecode(bytes, cv::IMREAD_COLOR), image) == 0) << cv::imwrite("small.png", small)
            << (cv::imread("small.png").size() == small.size()) << cv::imread("none.png").empty()
            << cv::sum(image)[0] << std::endl;
  int base = 0;
  std::cout << cv::getTextSize("Vera", cv::FONT_HERSHEY_SIMPLEX, 1.0, 2, &base) << base << std::endl;
  try {
    cv::cvtColor(grey, grey, cv::COLOR_BGR2HSV);
  } catch (const cv::Exception & error) {
    std::cout << "refused " << (error.msg.rfind("OpenCV(", 0) == 0) << std::endl;
  }
}
static void stencilled()
{
  cv::Mat stamp(4, 6, CV_8UC3, cv::Scalar(200, 200, 200)), mask, page(8, 8, CV_8UC3);
  cv::rectangle(stamp, cv::Rect(2, 1, 2, 2), cv::Scalar(9, 0, 7), cv::FILLED);
  cv::Rect around;
  int painted = cv::floodFill(stamp, cv::Point(0, 0), CV_RGB(1, 1, 1), &around);
  cv::compare(stamp, 1, mask, cv::CMP_NE);
  page = cv::Scalar_<int>(50, 60, 70);
  stamp.copyTo(page(cv::Rect(1, 2, stamp.size().width, stamp.size().height)), mask);
  std::vector<uchar> png;
  cv::imencode(".png", page, png);
  cv::Mat back = cv::imdecode(png, cv::ImreadModes::IMREAD_COLOR);
  std::cout << painted << around << mask.channels() << cv::sum(mask)[1] << " " << back.at<cv::Vec3b>(3, 3)
            << back.at<cv::Vec3b>(2, 1) << std::endl;
}
int main()
{
  std::cout << std::setprecision(10);
  memory();
  asked();
  stencilled();
}
