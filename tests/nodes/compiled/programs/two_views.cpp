// What two views of the same points tell, and what shapes and numbers are told by.
#include <iostream>
#include <opencv2/opencv.hpp>

static void cameras()
{
  const cv::Matx33d camera(400, 0, 320, 0, 400, 240, 0, 0, 1);
  std::vector<cv::Point3d> points;
  cv::RNG rng(5);
  for (int i = 0; i < 60; ++i) {
    points.emplace_back(rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(4.0, 8.0));
  }
  std::vector<cv::Point2d> first, second;
  cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), camera, cv::noArray(), first);
  cv::projectPoints(points, cv::Vec3d(0, 0.1, 0), cv::Vec3d(-1, 0, 0), camera, cv::noArray(), second);
  cv::Mat mask, rotation, shift, places;
  const cv::Mat essential = cv::findEssentialMat(first, second, camera, cv::RANSAC, 0.999, 1.0, mask);
  const int before = cv::recoverPose(essential, first, second, camera, rotation, shift, mask);
  cv::Vec3d turn;
  cv::Rodrigues(rotation, turn);
  std::cout << before << " " << cvRound(100 * turn[1]) << " " << cvRound(100 * shift.at<double>(0)) << std::endl;
  const cv::Mat same = cv::findEssentialMat(first, second, 400, {320, 240});
  std::cout << cv::recoverPose(same, first, second, rotation, shift, 400, {320, 240});
  cv::Mat one = cv::Mat(camera) * cv::Mat::eye(3, 4, CV_64F), two;
  cv::hconcat(rotation, shift, two);
  two = cv::Mat(camera) * two;
  cv::triangulatePoints(one, two, first, second, places);
  std::cout << " " << places.rows << places.cols << " " << cvRound(1e6 * (places.at<double>(2, 3) / places.at<double>(3, 3) - points[3].z))
            << std::endl;
  const cv::Mat fundamental = cv::findFundamentalMat(first, second, cv::FM_8POINT);
  const cv::Matx33d between = fundamental;
  const cv::Vec3d line = between * cv::Vec3d(first[7].x, first[7].y, 1);
  std::cout << fundamental.size() << (std::abs(line.dot(cv::Vec3d(second[7].x, second[7].y, 1))) < 1e-6) << std::endl;
}
static void pairs()
{
  cv::Mat left(120, 160, CV_8UC1), right, disparity;
  cv::randu(left, 0, 255);
  cv::warpAffine(left, right, cv::Mat(cv::Matx23d(1, 0, -8, 0, 1, 0)), left.size());
  auto blocks = cv::StereoBM::create(16, 9);
  blocks->compute(left, right, disparity);
  std::cout << disparity.at<short>(60, 80) << " ";
  auto global = cv::StereoSGBM::create(0, 16, 5);
  global->setUniquenessRatio(10);
  global->compute(left, right, disparity);
  std::cout << disparity.at<short>(60, 80) << " " << global->getUniquenessRatio() << blocks->getBlockSize() << std::endl;
  const cv::Matx33d camera(400, 0, 80, 0, 400, 60, 0, 0, 1);
  cv::Mat r1, r2, p1, p2, q;
  cv::stereoRectify(
    camera, cv::noArray(), camera, cv::noArray(), left.size(), cv::Matx33d::eye(), cv::Vec3d(-0.1, 0, 0), r1, r2, p1, p2, q);
  std::cout << r1.size() << p2.at<double>(0, 3) << " " << q.at<double>(3, 2) << std::endl;
}
static void shapes()
{
  const cv::Point2f square[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, turned[] = {{0, 0}, {0, 4}, {-4, 4}, {-4, 0}};
  std::cout << cv::getPerspectiveTransform(square, turned).at<double>(1, 0) << " "
            << cvRound(cv::estimateAffinePartial2D(square, turned).at<double>(0, 1)) << cv::RotatedRect({10, 10}, {4, 2}, 90).boundingRect()
            << cv::minAreaRect(std::vector<cv::Point>{{0, 0}, {20, 0}, {20, 10}, {0, 10}}).angle << std::endl;
  cv::Mat image(20, 20, CV_8UC1, cv::Scalar(0)), drawn = image.clone();
  cv::line(drawn, {2, 3}, {17, 9}, 255);
  cv::LineIterator pixels(image, {2, 3}, {17, 9});
  for (int i = 0; i < pixels.count; ++i, ++pixels) {
    **pixels = 255;
  }
  cv::LineIterator outside(image, {-5, 4}, {25, 4}, 4);
  std::cout << pixels.count << cv::norm(image, drawn) << " " << outside.count << outside.pos() << std::endl;
  double hu[7];
  cv::HuMoments(cv::moments(std::vector<cv::Point>{{0, 0}, {10, 0}, {10, 5}, {3, 9}}), hu);
  for (double one : hu) {
    std::cout << one << " ";
  }
  std::cout << std::endl;
}
static void numbers()
{
  const cv::Mat a = (cv::Mat_<double>(3, 2) << 3, 1, -2, 5, 0, 4);
  cv::Mat sorted, order;
  cv::sort(a, sorted, cv::SORT_EVERY_COLUMN | cv::SORT_DESCENDING);
  cv::sortIdx(a, order, cv::SORT_EVERY_COLUMN);
  const cv::SVD parts(a);
  const cv::Mat again = parts.u * cv::Mat::diag(parts.w) * parts.vt;
  const cv::Mat diagonal = (cv::Mat_<double>(4, 2) << 0, 0, 1, 1, 2, 2, 3, 3);
  const cv::PCA along(diagonal, cv::Mat(), cv::PCA::DATA_AS_ROW);
  std::cout << sorted.t() << order.t() << (cv::norm(again, a) < 1e-9) << cv::abs(a).row(1)
            << cv::checkRange(a, true, nullptr, 0, 9) << std::endl;
  const double part_of_y = std::abs(along.eigenvectors.at<double>(0, 1));
  std::cout << along.mean << cvRound(100 * part_of_y) << " " << along.eigenvalues.at<double>(0) << std::endl;
  cv::Mat wide(1, 2, CV_8UC3, cv::Scalar(1, 2, 3)), red(1, 2, CV_8UC1);
  const int pair[] = {2, 0};
  cv::mixChannels(&wide, 1, &red, 1, pair, 1);
  wide.resize(2);
  cv::Rect part(0, 0, 5, 5);
  part &= cv::Rect(3, 3, 9, 9);
  int done = 0;
  cv::parallel_for_(cv::Range(0, 4), [&](const cv::Range & range) {done += range.size();});
  std::cout << red << wide.rows << part << done << cv::getVersionString() << std::endl;
}
static void spots()
{
  cv::Mat image(100, 100, CV_8UC1, cv::Scalar(255));
  cv::circle(image, {30, 40}, 10, 0, -1);
  cv::circle(image, {70, 60}, 4, 0, -1);
  cv::SimpleBlobDetector::Params settings;
  settings.minArea = 100;
  std::vector<cv::KeyPoint> found;
  cv::SimpleBlobDetector::create(settings)->detect(image, found);
  std::cout << found.size() << " " << cvRound(found.at(0).pt.x) << " " << cvRound(found[0].pt.y);
  cv::Mat words = (cv::Mat_<float>(2, 2) << 0, 0, 9, 9), asked = (cv::Mat_<float>(1, 2) << 8, 9), mask, behind, before;
  std::vector<std::vector<cv::DMatch>> matches;
  cv::FlannBasedMatcher().knnMatch(asked, words, matches, 2);
  cv::HOGDescriptor people;
  people.setSVMDetector(cv::HOGDescriptor::getDefaultPeopleDetector());
  std::vector<cv::Rect> nobody;
  people.detectMultiScale(cv::Mat(200, 200, CV_8UC1, cv::Scalar(90)), nobody);
  cv::Mat coloured;
  cv::cvtColor(image, coloured, cv::COLOR_GRAY2BGR);
  cv::grabCut(coloured, mask, cv::Rect(15, 25, 30, 30), behind, before, 2, cv::GC_INIT_WITH_RECT);
  std::cout << " " << matches[0][0].trainIdx << matches[0].size() << nobody.size() << int{mask.at<uchar>(40, 30)} << std::endl;
}
int main()
{
  cameras();
  pairs();
  shapes();
  numbers();
  spots();
}
