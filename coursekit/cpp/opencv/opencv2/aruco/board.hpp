// Markers that are fixed to each other, so that one pose is told by all that are seen. The frame is that of OpenCV 4.5: its
// origin is the lower left corner, and y points up.
#pragma once
#include "opencv2/aruco.hpp"

namespace cv::aruco
{
class Board
{
public:
  /// The corners of each marker, clockwise from the upper left one [m].
  std::vector<std::vector<Point3f>> objPoints;
  Ptr<Dictionary> dictionary;
  std::vector<int> ids;

  static Ptr<Board> create(
    const std::vector<std::vector<Point3f>> & corners, const Ptr<Dictionary> & dictionary, const std::vector<int> & ids)
  {
    CV_Assert(corners.size() == ids.size());
    auto made = makePtr<Board>();
    made->objPoints = corners;
    made->dictionary = dictionary;
    made->ids = ids;
    return made;
  }
  void setIds(const std::vector<int> & numbers)
  {
    CV_Assert(numbers.size() == objPoints.size());
    ids = numbers;
  }
};

/// Markers in rows, numbered from the upper left one on.
class GridBoard : public Board
{
public:
  static Ptr<GridBoard> create(
    int columns, int rows, float length, float gap, const Ptr<Dictionary> & dictionary, int first = 0)
  {
    CV_Assert(columns > 0 && rows > 0 && length > 0 && gap > 0);
    auto made = makePtr<GridBoard>();
    made->dictionary = dictionary;
    made->size_ = {columns, rows};
    made->length_ = length;
    made->gap_ = gap;
    const float top = static_cast<float>(rows) * (length + gap) - gap;
    for (int i = 0; i < columns * rows; ++i) {
      const float column = static_cast<float>(i % columns), row = static_cast<float>(i / columns);
      const Point3f corner(column * (length + gap), top - row * (length + gap), 0);
      made->ids.push_back(first + i);
      made->objPoints.push_back(
        {corner, corner + Point3f(length, 0, 0), corner + Point3f(length, -length, 0), corner + Point3f(0, -length, 0)});
    }
    return made;
  }
  Size getGridSize() const {return size_;}
  float getMarkerLength() const {return length_;}
  float getMarkerSeparation() const {return gap_;}
  /// The board's image of so many pixels, to be printed.
  void draw(Size pixels, OutputArray image, int margin = 0, int border = 1) const
  {
    const auto & d = *dictionary;
    image.assign(
      remote::call(
        "aruco_grid", d.bytesList, d.markerSize, d.maxCorrectionBits, size_, length_, gap_, Mat(ids), pixels, margin, border));
  }

private:
  Size size_;
  float length_ = 0, gap_ = 0;
};

/// Which corners of a board are seen, and where.
inline void getBoardObjectAndImagePoints(
  const Ptr<Board> & board, InputArrayOfArrays corners, InputArray ids, OutputArray points, OutputArray pixels)
{
  const Mat numbers = ids.getMat();
  std::vector<Point3f> there;
  std::vector<Point2f> seen;
  for (int i = 0; i < static_cast<int>(numbers.total()); ++i) {
    const auto at = std::find(board->ids.begin(), board->ids.end(), numbers.at<int>(i)) - board->ids.begin();
    if (at < static_cast<std::ptrdiff_t>(board->ids.size())) {
      const auto & marker = board->objPoints[static_cast<size_t>(at)];
      const Mat found = corners.getMat(i);
      there.insert(there.end(), marker.begin(), marker.end());
      seen.insert(seen.end(), found.begin<Point2f>(), found.end<Point2f>());
    }
  }
  points.assign(Mat(there));
  pixels.assign(Mat(seen));
}
/// The board's turn and place before the camera. Returns the number of its markers that are seen.
inline int estimatePoseBoard(
  InputArrayOfArrays corners, InputArray ids, const Ptr<Board> & board, InputArray camera, InputArray distortion,
  InputOutputArray rvec, InputOutputArray tvec, bool use_guess = false)
{
  std::vector<Point3f> points;
  std::vector<Point2f> pixels;
  getBoardObjectAndImagePoints(board, corners, ids, points, pixels);
  if (!points.empty()) {
    solvePnP(points, pixels, camera, distortion, rvec, tvec, use_guess);
  }
  return static_cast<int>(points.size()) / 4;
}
}  // namespace cv::aruco
