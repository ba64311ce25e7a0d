// Lines, shapes and text in an image.
#pragma once
#include "opencv2/core.hpp"

/// A colour by its red, green and blue.
#define CV_RGB(r, g, b) cv::Scalar((b), (g), (r), 0)

namespace cv
{
/// Paint what hangs together with a pixel and is like it; how many pixels were painted, and the rectangle around them.
inline int floodFill(
  InputOutputArray img, Point seed, const Scalar & colour, Rect * rect = nullptr, const Scalar & lower = Scalar(),
  const Scalar & upper = Scalar(), int flags = 4)
{
  remote::Value done = call("floodFill", img, Mat(), seed, colour, lower, upper, flags);
  img.assign(done[1]);
  if (rect) {
    *rect = detail::rect_of(done[3]);
  }
  return static_cast<int>(done[0].integer);
}
inline void line(
  InputOutputArray img, Point from, Point to, const Scalar & colour, int thickness = 1, int lineType = LINE_8, int shift = 0)
{
  img.assign(call("line", img, from, to, colour, thickness, lineType, shift));
}
inline void arrowedLine(
  InputOutputArray img, Point from, Point to, const Scalar & colour, int thickness = 1, int line_type = LINE_8,
  int shift = 0, double tip = 0.1)
{
  img.assign(call("arrowedLine", img, from, to, colour, thickness, line_type, shift, tip));
}
inline void rectangle(
  InputOutputArray img, Point a, Point b, const Scalar & colour, int thickness = 1, int lineType = LINE_8, int shift = 0)
{
  img.assign(call("rectangle", img, a, b, colour, thickness, lineType, shift));
}
inline void rectangle(
  InputOutputArray img, Rect rect, const Scalar & colour, int thickness = 1, int lineType = LINE_8, int shift = 0)
{
  img.assign(call("rectangle", img, rect, colour, thickness, lineType, shift));
}
inline void circle(
  InputOutputArray img, Point center, int radius, const Scalar & colour, int thickness = 1, int lineType = LINE_8,
  int shift = 0)
{
  img.assign(call("circle", img, center, radius, colour, thickness, lineType, shift));
}
inline void ellipse(
  InputOutputArray img, Point center, Size axes, double angle, double from, double to, const Scalar & colour,
  int thickness = 1, int lineType = LINE_8, int shift = 0)
{
  img.assign(call("ellipse", img, center, axes, angle, from, to, colour, thickness, lineType, shift));
}
inline void ellipse(
  InputOutputArray img, const RotatedRect & box, const Scalar & colour, int thickness = 1, int lineType = LINE_8)
{
  img.assign(call("ellipse", img, box, colour, thickness, lineType));
}
inline void drawMarker(
  InputOutputArray img, Point at, const Scalar & colour, int kind = 0, int size = 20, int thickness = 1, int line_type = 8)
{
  img.assign(call("drawMarker", img, at, colour, kind, size, thickness, line_type));
}
inline void putText(
  InputOutputArray img, const std::string & text, Point at, int font, double scale, Scalar colour, int thickness = 1,
  int lineType = LINE_8, bool bottom_left = false)
{
  img.assign(call("putText", img, text, at, font, scale, colour, thickness, lineType, bottom_left));
}
inline Size getTextSize(const std::string & text, int font, double scale, int thickness, int * base_line)
{
  remote::Value found = call("getTextSize", text, font, scale, thickness);
  if (base_line) {
    *base_line = static_cast<int>(found[1].integer);
  }
  Point size = detail::point_of(found[0]);
  return {size.x, size.y};
}
namespace detail
{
/// One list of points, as a list of such lists.
inline std::vector<Mat> as_lists(InputArray points)
{
  std::vector<Mat> all;
  if (points.isMat()) {
    all.push_back(points.getMat());
    return all;
  }
  for (int i = 0; i < points.count(); ++i) {
    all.push_back(points.getMat(i));
  }
  return all;
}
}  // namespace detail
inline void polylines(
  InputOutputArray img, InputArrayOfArrays points, bool closed, const Scalar & colour, int thickness = 1,
  int lineType = LINE_8, int shift = 0)
{
  img.assign(call("polylines", img, detail::as_lists(points), closed, colour, thickness, lineType, shift));
}
inline void fillPoly(
  InputOutputArray img, InputArrayOfArrays points, const Scalar & colour, int lineType = LINE_8, int shift = 0)
{
  img.assign(call("fillPoly", img, detail::as_lists(points), colour, lineType, shift));
}
inline void fillConvexPoly(
  InputOutputArray img, InputArray points, const Scalar & colour, int lineType = LINE_8, int shift = 0)
{
  img.assign(call("fillConvexPoly", img, points, colour, lineType, shift));
}
inline void drawContours(
  InputOutputArray img, InputArrayOfArrays contours, int which, const Scalar & colour, int thickness = 1,
  int lineType = LINE_8, InputArray hierarchy = noArray(), int deepest = INT32_MAX)
{
  img.assign(
    call("drawContours", img, detail::as_lists(contours), which, colour, thickness, lineType, hierarchy, deepest));
}
}  // namespace cv
