// What moves between images: flow, the background, and a filter for what is followed.
#pragma once
#include "opencv2/core.hpp"
#include "opencv2/imgproc.hpp"

namespace cv
{
/// Where points of one image are in the next one.
inline void calcOpticalFlowPyrLK(
  InputArray before, InputArray now, InputArray points, InputOutputArray moved, OutputArray status, OutputArray error,
  Size window = Size(21, 21), int levels = 3,
  TermCriteria end = TermCriteria(TermCriteria::COUNT + TermCriteria::EPS, 30, 0.01), int flags = 0, double weakest = 1e-4)
{
  auto flow = call(
    "calcOpticalFlowPyrLK", before, now, points, moved, kw("winSize", window), kw("maxLevel", levels), kw("criteria", end),
    kw("flags", flags), kw("minEigThreshold", weakest));
  moved.assign(flow[0]);
  status.assign(flow[1]);
  error.assign(flow[2]);
}
inline void calcOpticalFlowFarneback(
  InputArray before, InputArray now, InputOutputArray flow, double scale, int levels, int window, int iterations, int poly_n,
  double poly_sigma, int flags)
{
  flow.assign(
    call("calcOpticalFlowFarneback", before, now, flow, scale, levels, window, iterations, poly_n, poly_sigma, flags));
}

/// Learns what stands still; its mask is 255 where something moves, 127 in a shadow.
class BackgroundSubtractor
{
public:
  template<class ... A>
  explicit BackgroundSubtractor(const char * kind, const A & ... arguments)
  : object_(kind, arguments ...) {}
  void apply(InputArray image, OutputArray mask, double rate = -1)
  {
    mask.assign(object_.call("apply", image, kw("learningRate", rate)));
  }
  void getBackgroundImage(OutputArray image) const {image.assign(object_.call("getBackgroundImage"));}

private:
  remote::Object object_;
};
using BackgroundSubtractorMOG2 = BackgroundSubtractor;
using BackgroundSubtractorKNN = BackgroundSubtractor;
inline Ptr<BackgroundSubtractorMOG2> createBackgroundSubtractorMOG2(
  int history = 500, double limit = 16, bool shadows = true)
{
  return makePtr<BackgroundSubtractorMOG2>("createBackgroundSubtractorMOG2", history, limit, shadows);
}
inline Ptr<BackgroundSubtractorKNN> createBackgroundSubtractorKNN(
  int history = 500, double limit = 400, bool shadows = true)
{
  return makePtr<BackgroundSubtractorKNN>("createBackgroundSubtractorKNN", history, limit, shadows);
}

/// Kalman's filter: a state that is predicted, and corrected by what is measured.
class KalmanFilter
{
public:
  Mat statePre, statePost, transitionMatrix, controlMatrix, measurementMatrix, processNoiseCov, measurementNoiseCov;
  Mat errorCovPre, gain, errorCovPost;
  KalmanFilter() = default;
  KalmanFilter(int states, int measured, int controls = 0, int type = CV_32F) {init(states, measured, controls, type);}
  void init(int states, int measured, int controls = 0, int type = CV_32F)
  {
    statePre = Mat::zeros(states, 1, type);
    statePost = Mat::zeros(states, 1, type);
    transitionMatrix = Mat::eye(states, states, type);
    processNoiseCov = Mat::eye(states, states, type);
    measurementMatrix = Mat::zeros(measured, states, type);
    measurementNoiseCov = Mat::eye(measured, measured, type);
    errorCovPre = Mat::zeros(states, states, type);
    errorCovPost = Mat::zeros(states, states, type);
    gain = Mat::zeros(states, measured, type);
    controlMatrix = controls > 0 ? Mat::zeros(states, controls, type) : Mat();
  }
  const Mat & predict(const Mat & control = Mat())
  {
    statePre = transitionMatrix * statePost;
    if (!control.empty()) {
      statePre += controlMatrix * control;
    }
    errorCovPre = transitionMatrix * errorCovPost * transitionMatrix.t() + processNoiseCov;
    statePre.copyTo(statePost);
    errorCovPre.copyTo(errorCovPost);
    return statePre;
  }
  const Mat & correct(const Mat & measurement)
  {
    Mat seen = measurementMatrix * errorCovPre, wrong;
    gain = seen.t() * Mat(seen * measurementMatrix.t() + measurementNoiseCov).inv(DECOMP_SVD);
    statePost = statePre + gain * (measurement - measurementMatrix * statePre);
    errorCovPost = errorCovPre - gain * seen;
    return statePost;
  }
};
}  // namespace cv
