// Files of settings: a calibration is written, read again, and so are parts of one's own type.
#include <iostream>
#include <opencv2/opencv.hpp>

struct Robot
{
  int wheels = 0;
  std::string name;
  void write(cv::FileStorage & to) const {to << "{" << "wheels" << wheels << "name" << name << "}";}
  void read(const cv::FileNode & from)
  {
    wheels = static_cast<int>(from["wheels"]);
    name = static_cast<std::string>(from["name"]);
  }
};
static void write(cv::FileStorage & to, const std::string &, const Robot & robot) {robot.write(to);}
static void read(const cv::FileNode & from, Robot & robot, const Robot & other = Robot())
{
  if (from.empty()) {
    robot = other;
  } else {
    robot.read(from);
  }
}

static void wrote()
{
  cv::FileStorage file("camera.yaml", cv::FileStorage::WRITE);
  cv::Mat camera = (cv::Mat_<double>(3, 3) << 300, 0, 160, 0, 300.5, 120, 0, 0, 1);
  file << "width" << 640 << "error" << 0.25 << "name" << "front camera";
  file << "camera_matrix" << camera << "lens" << cv::Mat(1, 5, CV_32F, cv::Scalar(0.5));
  file << "images" << "[" << "a.png" << "b.png" << "]";
  file << "limits" << "{:" << "low" << 1 << "high" << 2.5f << "}";
  file << "corners" << std::vector<cv::Point2f>{{1, 2}, {3, 4.5f}} << "ids" << std::vector<int>{7, 8} << "size" << cv::Size(4, 3);
  file << "robot" << Robot{4, "Vera"};
  file.release();
  std::cout << file.isOpened() << std::endl;
}
static void read_again()
{
  cv::FileStorage file("camera.yaml", cv::FileStorage::READ);
  cv::Mat camera, lens;
  int width = 0;
  float error = 0;
  file["width"] >> width;
  file["error"] >> error;
  file["camera_matrix"] >> camera;
  file["lens"] >> lens;
  std::cout << file.isOpened() << width << " " << error << " " << static_cast<std::string>(file["name"]) << " "
            << camera.at<double>(1, 1) << " " << lens.at<float>(0, 4) << lens.type() << std::endl;
  const cv::FileNode images = file["images"];
  std::cout << (images.type() == cv::FileNode::SEQ) << images.size();
  for (cv::FileNodeIterator it = images.begin(); it != images.end(); ++it) {
    std::cout << " " << static_cast<std::string>(*it);
  }
  std::cout << " " << static_cast<int>(file["limits"]["low"]) << static_cast<double>(file["limits"]["high"]) << std::endl;
  std::vector<cv::Point2f> corners;
  std::vector<int> ids;
  cv::Size size;
  Robot robot, none{3, "none"};
  file["corners"] >> corners;
  file["ids"] >> ids;
  file["size"] >> size;
  file["robot"] >> robot;
  file["moon"] >> none;
  std::cout << corners.at(1) << ids.at(1) << size << robot.wheels << robot.name << none.wheels << " " << file["moon"].empty()
            << file["moon"].isNone() << file.root().keys().size() << std::endl;
}
static void refused()
{
  cv::FileStorage file;
  std::cout << file.open("nowhere.yaml", cv::FileStorage::READ) << file.isOpened() << file["x"].empty();
  try {
    file.open("plain.yaml", cv::FileStorage::READ);
  } catch (const cv::Exception & error) {
    std::cout << " " << file.isOpened();
  }
  cv::FileStorage text(".json", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  text << "a" << 1;
  std::cout << " " << text.releaseAndGetString().find("\"a\": 1") << std::endl;
}
static void pixels()
{
  const cv::Mat image = (cv::Mat_<uchar>(2, 3) << 5, 1, 4, 2, 3, 0);
  int sum = 0;
  for (auto pixel = image.begin<uchar>(); pixel != image.end<uchar>(); ++pixel) {
    sum += *pixel;
  }
  cv::Mat_<uchar> sorted = image.clone();
  std::sort(sorted.begin(), sorted.end());
  const cv::Mat_<uchar> kept = sorted;
  cv::MatConstIterator_<uchar> third = kept.begin() + 2;
  std::cout << sum << " " << sorted << static_cast<int>(*third) << static_cast<int>(third[1]) << (kept.end() - kept.begin()) << std::endl;
}

int main()
{
  wrote();
  read_again();
  refused();
  pixels();
}
