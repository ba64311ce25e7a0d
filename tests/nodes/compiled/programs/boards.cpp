// A board of markers: its corners, its image, and its pose before the camera.
#include <iostream>
#include <opencv2/aruco.hpp>
#include <opencv2/aruco/dictionary.hpp>
#include <opencv2/opencv.hpp>

int main()
{
  auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_6X6_250);
  cv::Ptr<cv::aruco::GridBoard> board = cv::aruco::GridBoard::create(3, 2, 0.04f, 0.01f, dictionary, 5);
  std::cout << board->getGridSize() << board->getMarkerLength() << " " << board->getMarkerSeparation() << " " << board->ids[0]
            << board->ids.back() << board->objPoints[0] << board->objPoints[5][2] << std::endl;
  cv::Mat image, camera = (cv::Mat_<double>(3, 3) << 600, 0, 300, 0, 600, 200, 0, 0, 1), distortion;
  board->draw(cv::Size(600, 400), image, 20);
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> corners;
  cv::aruco::detectMarkers(image, board->dictionary, corners, ids);
  cv::Vec3d turn, place;
  std::cout << image.size() << ids.size() << " "
            << cv::aruco::estimatePoseBoard(corners, ids, board, camera, distortion, turn, place) << std::endl;
  cv::Matx33d matrix;
  cv::Rodrigues(turn, matrix);
  std::vector<cv::Point2d> centre;
  cv::projectPoints(std::vector<cv::Point3d>{{0.07, 0.045, 0}}, turn, place, camera, distortion, centre);
  std::cout << cvRound(100 * matrix(0, 0)) << " " << cvRound(100 * matrix(1, 1)) << " " << cvRound(100 * place[2]) << " "
            << cvRound(centre[0].x + 0.25) << " " << cvRound(centre[0].y + 0.25) << std::endl;
  board->setIds({20, 21, 22, 23, 24, 25});
  std::cout << cv::aruco::estimatePoseBoard(corners, ids, board, camera, distortion, turn, place) << std::endl;
}
