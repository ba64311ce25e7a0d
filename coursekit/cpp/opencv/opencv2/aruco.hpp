// Markers whose pattern is a number: found in images, and where they are before the camera. Names are of OpenCV 4.5.
#pragma once
#include "opencv2/calib3d.hpp"
#include "opencv2/core.hpp"

namespace cv::aruco
{
enum PREDEFINED_DICTIONARY_NAME
{
  DICT_4X4_50, DICT_4X4_100, DICT_4X4_250, DICT_4X4_1000, DICT_5X5_50, DICT_5X5_100, DICT_5X5_250, DICT_5X5_1000,
  DICT_6X6_50, DICT_6X6_100, DICT_6X6_250, DICT_6X6_1000, DICT_7X7_50, DICT_7X7_100, DICT_7X7_250, DICT_7X7_1000,
  DICT_ARUCO_ORIGINAL, DICT_APRILTAG_16h5, DICT_APRILTAG_25h9, DICT_APRILTAG_36h10, DICT_APRILTAG_36h11
};
enum CornerRefineMethod {CORNER_REFINE_NONE, CORNER_REFINE_SUBPIX, CORNER_REFINE_CONTOUR, CORNER_REFINE_APRILTAG};

/// The patterns of all markers of a kind.
struct Dictionary
{
  Mat bytesList;
  int markerSize = 0, maxCorrectionBits = 0;
  static Ptr<Dictionary> of(const remote::Value & value)
  {
    auto made = makePtr<Dictionary>();
    made->bytesList = value[0].mat;
    made->markerSize = static_cast<int>(value[1].integer);
    made->maxCorrectionBits = static_cast<int>(value[2].integer);
    return made;
  }
  static Ptr<Dictionary> get(int name) {return of(remote::call("aruco_dictionary", name));}
  static Ptr<Dictionary> create(int markers, int size, int seed = 0)
  {
    return of(remote::call("aruco_new_dictionary", markers, size, seed));
  }
  /// The image of a marker, black on white.
  void drawMarker(int id, int pixels, OutputArray image, int border = 1) const
  {
    image.assign(remote::call("aruco_marker", bytesList, markerSize, maxCorrectionBits, id, pixels, border));
  }
};
inline Ptr<Dictionary> getPredefinedDictionary(int name) {return Dictionary::get(name);}
inline Ptr<Dictionary> generateCustomDictionary(int markers, int size, int seed = 0)
{
  return Dictionary::create(markers, size, seed);
}
inline void drawMarker(const Ptr<Dictionary> & dictionary, int id, int pixels, OutputArray image, int border = 1)
{
  dictionary->drawMarker(id, pixels, image, border);
}

/// How candidates are found and refused.
struct DetectorParameters
{
  static Ptr<DetectorParameters> create() {return makePtr<DetectorParameters>();}
  int adaptiveThreshWinSizeMin = 3, adaptiveThreshWinSizeMax = 23, adaptiveThreshWinSizeStep = 10;
  double adaptiveThreshConstant = 7, minMarkerPerimeterRate = 0.03, maxMarkerPerimeterRate = 4;
  double polygonalApproxAccuracyRate = 0.03, minCornerDistanceRate = 0.05;
  int minDistanceToBorder = 3;
  double minMarkerDistanceRate = 0.05;
  int cornerRefinementMethod = CORNER_REFINE_NONE, cornerRefinementWinSize = 5, cornerRefinementMaxIterations = 30;
  double cornerRefinementMinAccuracy = 0.1;
  int markerBorderBits = 1, perspectiveRemovePixelPerCell = 4;
  double perspectiveRemoveIgnoredMarginPerCell = 0.13, maxErroneousBitsInBorderRate = 0.35, minOtsuStdDev = 5;
  double errorCorrectionRate = 0.6;
  bool detectInvertedMarker = false;
};

inline void detectMarkers(
  InputArray image, const Ptr<Dictionary> & dictionary, OutputArrayOfArrays corners, OutputArray ids,
  const Ptr<DetectorParameters> & parameters = DetectorParameters::create(), OutputArrayOfArrays rejected = noArray(),
  InputArray = noArray(), InputArray = noArray())
{
  const auto & d = *dictionary;
  const auto & p = *parameters;
  auto found = remote::call(
    "aruco_detect", image, d.bytesList, d.markerSize, d.maxCorrectionBits,
#define COURSEKIT_FIELD(name) remote::kw(#name, p.name)
    COURSEKIT_FIELD(adaptiveThreshWinSizeMin), COURSEKIT_FIELD(adaptiveThreshWinSizeMax),
    COURSEKIT_FIELD(adaptiveThreshWinSizeStep), COURSEKIT_FIELD(adaptiveThreshConstant),
    COURSEKIT_FIELD(minMarkerPerimeterRate), COURSEKIT_FIELD(maxMarkerPerimeterRate),
    COURSEKIT_FIELD(polygonalApproxAccuracyRate), COURSEKIT_FIELD(minCornerDistanceRate),
    COURSEKIT_FIELD(minDistanceToBorder), COURSEKIT_FIELD(minMarkerDistanceRate),
    COURSEKIT_FIELD(cornerRefinementMethod), COURSEKIT_FIELD(cornerRefinementWinSize),
    COURSEKIT_FIELD(cornerRefinementMaxIterations), COURSEKIT_FIELD(cornerRefinementMinAccuracy),
    COURSEKIT_FIELD(markerBorderBits), COURSEKIT_FIELD(perspectiveRemovePixelPerCell),
    COURSEKIT_FIELD(perspectiveRemoveIgnoredMarginPerCell), COURSEKIT_FIELD(maxErroneousBitsInBorderRate),
    COURSEKIT_FIELD(minOtsuStdDev), COURSEKIT_FIELD(errorCorrectionRate), COURSEKIT_FIELD(detectInvertedMarker));
#undef COURSEKIT_FIELD
  corners.assign(found[0]);
  ids.assign(found[1]);
  rejected.assign(found[2]);
}
/// Each marker's turn and place before the camera, for the length of its side [m].
inline void estimatePoseSingleMarkers(
  InputArrayOfArrays corners, float length, InputArray camera, InputArray distortion, OutputArray rvecs, OutputArray tvecs,
  OutputArray points = noArray())
{
  auto poses = remote::call("aruco_poses", corners, length, camera, distortion);
  rvecs.assign(poses[0]);
  tvecs.assign(poses[1]);
  points.assign(poses[2]);
}
inline void drawDetectedMarkers(
  InputOutputArray image, InputArrayOfArrays corners, InputArray ids = noArray(), Scalar colour = Scalar(0, 255, 0))
{
  image.assign(remote::call("aruco_draw", image, corners, ids, colour));
}
inline void drawAxis(
  InputOutputArray image, InputArray camera, InputArray distortion, InputArray rvec, InputArray tvec, float length)
{
  drawFrameAxes(image, camera, distortion, rvec, tvec, length);
}
}  // namespace cv::aruco

#include "opencv2/aruco/board.hpp"
