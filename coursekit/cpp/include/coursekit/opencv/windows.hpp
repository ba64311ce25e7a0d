// Windows: the session shows them, in a notebook's page where there is one.
#pragma once
#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <utility>

#include "coursekit/opencv/remote.hpp"

namespace cv
{
namespace remote
{
/// What a program is told about a window's sliders and its mouse: while it waits for a key, as in OpenCV.
class WindowEvents
{
public:
  struct Slider
  {
    int * value;
    TrackbarCallback moved;
    void * data;
  };
  struct Mouse
  {
    MouseCallback moved = nullptr;
    void * data = nullptr;
  };
  std::map<std::pair<std::string, std::string>, Slider> sliders;
  std::map<std::string, Mouse> mice;

  /// Call what waits for events; `wait` is one of cv2's ways to wait for a key.
  int key(const char * wait, int delay)
  {
    using Clock = std::chrono::steady_clock;
    auto end = Clock::now() + std::chrono::milliseconds(delay);
    while (listens()) {
      auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      int pressed = number(call(wait, delay > 0 ? std::clamp<int>(static_cast<int>(left), 1, SLICE_MS) : SLICE_MS));
      deliver();
      if (pressed != -1 || (delay > 0 && left <= SLICE_MS)) {
        return pressed;
      }
    }
    return number(call(wait, delay));
  }
  void deliver()
  {
    if (!listens()) {
      return;
    }
    Value heard = asked("cv_heard", Packer{});
    for (auto & event : heard.items) {
      if (event.items.size() == 3) {
        slide(event);
      } else {
        point(event);
      }
    }
  }

private:
  static constexpr int SLICE_MS = 20;
  bool listens() const {return !sliders.empty() || !mice.empty();}
  static int number(const Value & value) {return static_cast<int>(value.integer);}
  void slide(const Value & event)
  {
    auto found = sliders.find({event[0].text, event[1].text});
    if (found == sliders.end()) {
      return;
    }
    Slider slider = found->second;  // a copy: it may be made anew meanwhile
    if (slider.value) {
      *slider.value = number(event[2]);
    }
    if (slider.moved) {
      slider.moved(number(event[2]), slider.data);
    }
  }
  void point(const Value & event)
  {
    Mouse mouse = mice[event[0].text];
    if (mouse.moved) {
      mouse.moved(number(event[1]), number(event[2]), number(event[3]), number(event[4]), mouse.data);
    }
  }
};
inline WindowEvents & window_events()
{
  static WindowEvents events;
  return events;
}
}  // namespace remote

inline void imshow(const std::string & window, InputArray image)
{
  CV_Assert(!image.empty());
  remote::call("imshow", window, image.getMat());
}
inline void namedWindow(const std::string & window, int flags) {remote::call("namedWindow", window, flags);}
/// The session draws windows by itself: there is no thread to start.
inline int startWindowThread() {return 1;}
inline int waitKey(int delay) {return remote::window_events().key("waitKey", delay);}
inline int waitKeyEx(int delay) {return remote::window_events().key("waitKeyEx", delay);}
inline int pollKey()
{
  int pressed = static_cast<int>(remote::call("pollKey").integer);
  remote::window_events().deliver();
  return pressed;
}
inline void destroyWindow(const std::string & window) {remote::call("destroyWindow", window);}
inline void destroyAllWindows() {remote::call("destroyAllWindows");}
inline double getWindowProperty(const std::string & window, int property)
{
  return remote::call("getWindowProperty", window, property).number();
}
inline void setWindowProperty(const std::string & window, int property, double value)
{
  remote::call("setWindowProperty", window, property, value);
}
/// The place and size of a window's image.
inline Rect getWindowImageRect(const std::string & window)
{
  remote::Value rect = remote::call("getWindowImageRect", window);
  auto at = [&rect](size_t i) {return static_cast<int>(rect[i].integer);};
  return Rect(at(0), at(1), at(2), at(3));
}
inline void setWindowTitle(const std::string & window, const std::string & title)
{
  remote::call("setWindowTitle", window, title);
}
inline void resizeWindow(const std::string & window, int width, int height)
{
  remote::call("resizeWindow", window, width, height);
}
inline void resizeWindow(const std::string & window, const Size & size) {resizeWindow(window, size.width, size.height);}
inline void moveWindow(const std::string & window, int x, int y) {remote::call("moveWindow", window, x, y);}

inline int createTrackbar(
  const std::string & name, const std::string & window, int * value, int count, TrackbarCallback moved, void * data)
{
  remote::asked("cv_slider", coursekit::Packer{}.s(name).s(window).i(value ? *value : 0).i(count));
  remote::window_events().sliders[{window, name}] = {value, moved, data};
  return 1;
}
inline int getTrackbarPos(const std::string & name, const std::string & window)
{
  return static_cast<int>(remote::call("getTrackbarPos", name, window).integer);
}
inline void setTrackbarPos(const std::string & name, const std::string & window, int value)
{
  remote::call("setTrackbarPos", name, window, value);
  remote::window_events().deliver();
}
inline void setTrackbarMin(const std::string & name, const std::string & window, int value)
{
  remote::call("setTrackbarMin", name, window, value);
}
inline void setTrackbarMax(const std::string & name, const std::string & window, int value)
{
  remote::call("setTrackbarMax", name, window, value);
}
inline void setMouseCallback(const std::string & window, MouseCallback moved, void * data)
{
  remote::asked("cv_mouse", coursekit::Packer{}.s(window));
  remote::window_events().mice[window] = {moved, data};
}
}  // namespace cv
