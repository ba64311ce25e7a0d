// A window with sliders and a mouse: the program prints what it is told, and when.
#include <chrono>
#include <iostream>
#include <opencv2/highgui.hpp>

static void moved(int value, void * name) {std::cout << static_cast<const char *>(name) << " " << value << std::endl;}
static void pointed(int event, int x, int y, int flags, void *)
{
  std::cout << "mouse " << event << " " << x << " " << y << " " << flags << std::endl;
}
int main()
{
  int low = 20, width = 5;
  char name[] = "low";
  cv::namedWindow("tuner");
  cv::createTrackbar("low", "tuner", &low, 179, moved, name);
  cv::createTrackbar("width", "tuner", &width, 50);
  cv::setMouseCallback("tuner", pointed);
  auto begin = std::chrono::steady_clock::now();
  int first = cv::waitKey(500);
  auto waited = std::chrono::steady_clock::now() - begin;
  std::cout << first << " " << std::chrono::duration_cast<std::chrono::milliseconds>(waited).count() << " " << low << " "
            << width << " " << cv::getTrackbarPos("width", "tuner") << std::endl;
  cv::setTrackbarPos("low", "tuner", 33);
  std::cout << static_cast<char>(cv::waitKey()) << " " << width << std::endl;
  std::cout << cv::getTrackbarPos("high", "tuner") << std::endl;
  try {
    cv::createTrackbar("low", "none", nullptr, 9);
  } catch (const cv::Exception & error) {
    std::cout << error.what() << std::endl;
  }
  cv::destroyAllWindows();
}
