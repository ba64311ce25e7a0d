// Markers, codes, faces, corners and what moves: each printed number is compared with Python's.
#include <iostream>
#include <opencv2/aruco.hpp>
#include <opencv2/opencv.hpp>

static void markers()
{
  auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  cv::Mat marker, image(240, 320, CV_8UC1, cv::Scalar(255));
  cv::aruco::drawMarker(dictionary, 7, 100, marker);
  marker.copyTo(image(cv::Rect(60, 50, 100, 100)));
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> corners, rejected;
  cv::Ptr<cv::aruco::DetectorParameters> parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  cv::aruco::detectMarkers(image, dictionary, corners, ids, parameters, rejected);
  std::cout << ids.size() << " " << ids.at(0) << " " << corners[0].size() << " " << dictionary->markerSize << std::endl;
  cv::Mat camera = (cv::Mat_<double>(3, 3) << 300, 0, 160, 0, 300, 120, 0, 0, 1), distortion, turn, shown;
  std::vector<cv::Vec3d> rvecs, tvecs;
  cv::aruco::estimatePoseSingleMarkers(corners, 0.1f, camera, distortion, rvecs, tvecs);
  cv::Rodrigues(rvecs[0], turn);
  std::cout << turn.rows << turn.cols << " " << cvRound(tvecs[0][2] * 1000) << " " << cvRound(turn.at<double>(0, 0) * 100)
            << std::endl;
  cv::cvtColor(image, shown, cv::COLOR_GRAY2BGR);
  cv::aruco::drawDetectedMarkers(shown, corners, ids);
  cv::aruco::drawAxis(shown, camera, distortion, rvecs[0], tvecs[0], 0.05f);
  std::cout << (cv::norm(shown, cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(255))) > 0) << std::endl;
  cv::aruco::detectMarkers(cv::Mat(240, 320, CV_8UC1, cv::Scalar(255)), dictionary, corners, ids);
  std::cout << ids.size() << corners.size() << std::endl;
}
static void algebra()
{
  cv::Mat a = (cv::Mat_<double>(2, 2) << 4, 1, 2, 3), x, values, identity(2, 2, CV_64F);
  cv::solve(a, cv::Mat(cv::Vec2d(1, 2)), x);
  cv::Mat inverse = a.inv();
  std::cout << inverse.at<double>(0, 0) << inverse.at<double>(1, 0) << " " << x.at<double>(0) << " " << x.at<double>(1) << " "
            << cv::determinant(a) << cv::trace(a)[0] << std::endl;
  cv::setIdentity(identity, cv::Scalar(3));
  cv::RNG rng(12345);
  std::cout << identity << rng.uniform(0, 256) << " " << rng.uniform(0, 256) << " " << rng.next() << std::endl;
  cv::KalmanFilter filter(2, 1);
  filter.transitionMatrix = (cv::Mat_<float>(2, 2) << 1, 1, 0, 1);
  cv::setIdentity(filter.measurementMatrix);
  cv::setIdentity(filter.processNoiseCov, cv::Scalar::all(1e-4));
  cv::setIdentity(filter.measurementNoiseCov, cv::Scalar::all(0.1));
  cv::setIdentity(filter.errorCovPost, cv::Scalar::all(1));
  for (int i = 1; i < 6; ++i) {
    filter.predict();
    filter.correct(cv::Mat(1, 1, CV_32F, cv::Scalar(i)));
  }
  std::cout << filter.statePost.at<float>(0) << " " << filter.statePost.at<float>(1) << std::endl;
}
static void moving()
{
  cv::Mat before(100, 100, CV_8UC1, cv::Scalar(0)), now = before.clone(), mask, found;
  cv::rectangle(before, cv::Rect(30, 40, 20, 20), cv::Scalar(255), cv::FILLED);
  cv::rectangle(now, cv::Rect(33, 42, 20, 20), cv::Scalar(255), cv::FILLED);
  std::vector<cv::Point2f> points, moved;
  std::vector<uchar> status;
  std::vector<float> error;
  cv::goodFeaturesToTrack(before, points, 4, 0.1, 5);
  cv::calcOpticalFlowPyrLK(before, now, points, moved, status, error);
  std::cout << points.size() << " " << cvRound(moved[0].x - points[0].x) << " " << cvRound(moved[0].y - points[0].y)
            << " " << int(status[0]) << std::endl;
  cv::Ptr<cv::BackgroundSubtractorMOG2> still = cv::createBackgroundSubtractorMOG2(20, 16, false);
  for (int i = 0; i < 10; ++i) {still->apply(cv::Mat(100, 100, CV_8UC1, cv::Scalar(0)), mask);}
  still->apply(now, mask);
  cv::matchTemplate(now, before(cv::Rect(25, 35, 30, 30)), found, cv::TM_CCOEFF_NORMED);
  double best;
  cv::Point where;
  cv::minMaxLoc(found, nullptr, &best, nullptr, &where);
  std::cout << cv::countNonZero(mask) << where << cvRound(best) << std::endl;
  cv::Mat counts;
  int channels[] = {0}, sizes[] = {2};
  float range[] = {0, 256};
  const float * ranges[] = {range};
  cv::calcHist(&now, 1, channels, cv::Mat(), counts, 1, sizes, ranges);
  std::cout << counts.at<float>(0) << " " << counts.at<float>(1) << std::endl;
}
static void looks()
{
  cv::CascadeClassifier faces("/usr/share/opencv4/haarcascades/haarcascade_frontalface_default.xml"), none;
  std::vector<cv::Rect> found(3);
  faces.detectMultiScale(cv::Mat(100, 100, CV_8UC1, cv::Scalar(90)), found, 1.1, 3, 0, cv::Size(30, 30));
  std::cout << faces.empty() << none.empty() << none.load("/no/such/file.xml") << found.size() << std::endl;
  std::vector<cv::Point2f> corners;
  std::cout << "[" << cv::QRCodeDetector().detectAndDecode(cv::imread("code.png"), corners) << "] " << corners.size() << std::endl;
  cv::Mat board = cv::imread("board.png", cv::IMREAD_GRAYSCALE);
  bool seen = cv::findChessboardCorners(board, cv::Size(6, 4), corners);
  cv::cornerSubPix(board, corners, cv::Size(5, 5), cv::Size(-1, -1), cv::TermCriteria(3, 30, 0.01));
  std::cout << seen << " " << corners.size() << " " << cvRound(corners[1].x - corners[0].x) << std::endl;
}
static void features()
{
  cv::Mat board = cv::imread("board.png", cv::IMREAD_GRAYSCALE), moved, shown;
  cv::Mat by = (cv::Mat_<double>(2, 3) << 1, 0, 5, 0, 1, 3);
  cv::warpAffine(board, moved, by, board.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::Ptr<cv::ORB> orb = cv::ORB::create(200);
  std::vector<cv::KeyPoint> first, second;
  cv::Mat descriptions, others;
  orb->detectAndCompute(board, cv::noArray(), first, descriptions);
  orb->detectAndCompute(moved, cv::noArray(), second, others);
  std::vector<cv::DMatch> matches;
  cv::BFMatcher(cv::NORM_HAMMING, true).match(descriptions, others, matches);
  std::vector<std::vector<cv::DMatch>> pairs;
  cv::BFMatcher(cv::NORM_HAMMING).knnMatch(descriptions, others, pairs, 2);
  std::vector<std::vector<cv::DMatch>> single;
  cv::BFMatcher(cv::NORM_HAMMING).knnMatch(descriptions, others, single, 1);
  auto best = *std::min_element(matches.begin(), matches.end());
  cv::drawMatches(board, first, moved, second, matches, shown);
  std::cout << (first.size() == static_cast<size_t>(descriptions.rows)) << descriptions.cols << " " << pairs[0].size() << " "
            << best.distance << " " << shown.cols / board.cols << shown.channels() << std::endl;
  cv::drawKeypoints(board, first, shown);
  std::cout << shown.channels() << (first[0].size > 0) << (single.size() == first.size()) << single.at(0).size() << std::endl;
}
int main()
{
  markers();
  algebra();
  moving();
  looks();
  features();
}
