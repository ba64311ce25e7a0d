// Windows: the session shows them, in a notebook's page where there is one.
#pragma once
#include "opencv2/imgcodecs.hpp"
#include "opencv2/videoio.hpp"

namespace cv
{
inline void imshow(const std::string & window, InputArray image)
{
  CV_Assert(!image.empty());
  call("imshow", window, image);
}
inline void namedWindow(const std::string & window, int flags = WINDOW_AUTOSIZE) {call("namedWindow", window, flags);}
/// The session draws windows by itself: there is no thread to start.
inline int startWindowThread() {return 1;}
inline int waitKey(int delay = 0) {return static_cast<int>(call("waitKey", delay).integer);}
inline int waitKeyEx(int delay = 0) {return static_cast<int>(call("waitKeyEx", delay).integer);}
inline int pollKey() {return static_cast<int>(call("pollKey").integer);}
inline void destroyWindow(const std::string & window) {call("destroyWindow", window);}
inline void destroyAllWindows() {call("destroyAllWindows");}
inline double getWindowProperty(const std::string & window, int property)
{
  return call("getWindowProperty", window, property).number();
}
inline void setWindowTitle(const std::string & window, const std::string & title) {call("setWindowTitle", window, title);}
inline void resizeWindow(const std::string & window, int width, int height) {call("resizeWindow", window, width, height);}
inline void resizeWindow(const std::string & window, const Size & size) {resizeWindow(window, size.width, size.height);}
inline void moveWindow(const std::string & window, int x, int y) {call("moveWindow", window, x, y);}
}  // namespace cv
