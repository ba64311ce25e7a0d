// Windows, their sliders and mouse.
#pragma once
#include "opencv2/imgcodecs.hpp"
#include "opencv2/videoio.hpp"

namespace cv
{
typedef void (* TrackbarCallback)(int position, void * data);
typedef void (* MouseCallback)(int event, int x, int y, int flags, void * data);
void namedWindow(const std::string & window, int flags = WINDOW_AUTOSIZE);
int waitKey(int delay = 0);
int waitKeyEx(int delay = 0);
int createTrackbar(
  const std::string & name, const std::string & window, int * value, int count, TrackbarCallback moved = nullptr,
  void * data = nullptr);
void setMouseCallback(const std::string & window, MouseCallback moved, void * data = nullptr);
}  // namespace cv

#include "coursekit/opencv/windows.hpp"
