// Contours, lines and circles that are found in images, and what is measured of them.
#pragma once
#include "opencv2/core.hpp"

namespace cv
{
inline void findContours(
  InputArray image, OutputArrayOfArrays contours, OutputArray hierarchy, int mode, int method, Point offset = Point())
{
  remote::Value found = call("findContours", image, mode, method, kw("offset", offset));
  contours.assign(found[0]);
  hierarchy.assign(found[1]);
}
inline void findContours(InputArray image, OutputArrayOfArrays contours, int mode, int method, Point offset = Point())
{
  contours.assign(call("findContours", image, mode, method, kw("offset", offset))[0]);
}
inline double contourArea(InputArray contour, bool oriented = false)
{
  return call("contourArea", contour, oriented).number();
}
inline double arcLength(InputArray curve, bool closed) {return call("arcLength", curve, closed).number();}
inline void approxPolyDP(InputArray curve, OutputArray out, double epsilon, bool closed)
{
  out.assign(call("approxPolyDP", curve, epsilon, closed));
}
inline void convexHull(InputArray points, OutputArray hull, bool clockwise = false, bool as_points = true)
{
  hull.assign(call("convexHull", points, kw("clockwise", clockwise), kw("returnPoints", as_points)));
}
inline bool isContourConvex(InputArray contour) {return call("isContourConvex", contour).integer != 0;}
inline Rect boundingRect(InputArray points) {return detail::rect_of(call("boundingRect", points));}
inline RotatedRect minAreaRect(InputArray points) {return detail::rotated_of(call("minAreaRect", points));}
inline RotatedRect fitEllipse(InputArray points) {return detail::rotated_of(call("fitEllipse", points));}
inline void minEnclosingCircle(InputArray points, Point2f & center, float & radius)
{
  remote::Value found = call("minEnclosingCircle", points);
  center = {static_cast<float>(found[0][0].number()), static_cast<float>(found[0][1].number())};
  radius = static_cast<float>(found[1].number());
}
inline double pointPolygonTest(InputArray contour, Point2f at, bool distance)
{
  return call("pointPolygonTest", contour, at, distance).number();
}

/// Sums over a shape: m00 is its area, (m10 / m00, m01 / m00) its centre.
struct Moments
{
  double m00 = 0, m10 = 0, m01 = 0, m20 = 0, m11 = 0, m02 = 0, m30 = 0, m21 = 0, m12 = 0, m03 = 0;
  double mu20 = 0, mu11 = 0, mu02 = 0, mu30 = 0, mu21 = 0, mu12 = 0, mu03 = 0;
  double nu20 = 0, nu11 = 0, nu02 = 0, nu30 = 0, nu21 = 0, nu12 = 0, nu03 = 0;
};
/// Seven numbers of a shape that stay the same where it is moved, turned or scaled.
inline void HuMoments(const Moments & m, double hu[7])
{
  const double sum = m.nu20 + m.nu02, gap = m.nu20 - m.nu02;
  const double a = m.nu30 + m.nu12, b = m.nu21 + m.nu03, c = m.nu30 - 3 * m.nu12, d = 3 * m.nu21 - m.nu03;
  hu[0] = sum;
  hu[1] = gap * gap + 4 * m.nu11 * m.nu11;
  hu[2] = c * c + d * d;
  hu[3] = a * a + b * b;
  hu[4] = c * a * (a * a - 3 * b * b) + d * b * (3 * a * a - b * b);
  hu[5] = gap * (a * a - b * b) + 4 * m.nu11 * a * b;
  hu[6] = d * a * (a * a - 3 * b * b) - c * b * (3 * a * a - b * b);
}
inline void HuMoments(const Moments & m, OutputArray hu)
{
  Mat made(7, 1, CV_64F);
  HuMoments(m, made.ptr<double>());
  hu.assign(made);
}
inline Moments moments(InputArray shape, bool binary = false)
{
  remote::Value found = call("moments", shape, binary);
  Moments made;
  double * const fields[] = {
    &made.m00, &made.m10, &made.m01, &made.m20, &made.m11, &made.m02, &made.m30, &made.m21, &made.m12, &made.m03,
    &made.mu20, &made.mu11, &made.mu02, &made.mu30, &made.mu21, &made.mu12, &made.mu03,
    &made.nu20, &made.nu11, &made.nu02, &made.nu30, &made.nu21, &made.nu12, &made.nu03};
  for (size_t i = 0; i < std::min<size_t>(24, found.items.size()); ++i) {
    *fields[i] = found[i].number();
  }
  return made;
}

inline void HoughLines(InputArray image, OutputArray lines, double rho, double theta, int threshold)
{
  lines.assign(call("HoughLines", image, rho, theta, threshold));
}
inline void HoughLinesP(
  InputArray image, OutputArray lines, double rho, double theta, int threshold, double shortest = 0, double gap = 0)
{
  lines.assign(
    call("HoughLinesP", image, rho, theta, threshold, kw("minLineLength", shortest), kw("maxLineGap", gap)));
}
inline void HoughCircles(
  InputArray image, OutputArray circles, int method, double dp, double apart, double param1 = 100, double param2 = 100,
  int smallest = 0, int largest = 0)
{
  circles.assign(
    call("HoughCircles", image, method, dp, apart, kw("param1", param1), kw("param2", param2),
      kw("minRadius", smallest), kw("maxRadius", largest)));
}
inline int connectedComponents(InputArray image, OutputArray labels, int connectivity = 8, int type = CV_32S)
{
  remote::Value found = call("connectedComponents", image, kw("connectivity", connectivity), kw("ltype", type));
  labels.assign(found[1]);
  return static_cast<int>(found[0].integer);
}
inline int connectedComponentsWithStats(
  InputArray image, OutputArray labels, OutputArray stats, OutputArray centroids, int connectivity = 8, int type = CV_32S)
{
  remote::Value found = call("connectedComponentsWithStats", image, kw("connectivity", connectivity), kw("ltype", type));
  labels.assign(found[1]);
  stats.assign(found[2]);
  centroids.assign(found[3]);
  return static_cast<int>(found[0].integer);
}
enum ConnectedComponentsTypes
{
  CC_STAT_LEFT, CC_STAT_TOP, CC_STAT_WIDTH, CC_STAT_HEIGHT, CC_STAT_AREA, CC_STAT_MAX
};
}  // namespace cv
