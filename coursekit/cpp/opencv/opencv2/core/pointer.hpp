// OpenCV's own names for shared pointers and for text from a format.
#pragma once
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <string>

namespace cv
{
template<class T>
struct Ptr : std::shared_ptr<T>
{
  using std::shared_ptr<T>::shared_ptr;
  Ptr() = default;
  Ptr(const std::shared_ptr<T> & other)  // NOLINT: as OpenCV's
  : std::shared_ptr<T>(other) {}
  bool empty() const {return !*this;}
  void release() {this->reset();}
  operator T *() const {return this->get();}
};
template<class T, class ... A>
Ptr<T> makePtr(A && ... arguments) {return std::make_shared<T>(std::forward<A>(arguments) ...);}

inline std::string format(const char * text, ...)
{
  va_list args, again;
  va_start(args, text);
  va_copy(again, args);
  std::string made(static_cast<size_t>(std::max(vsnprintf(nullptr, 0, text, args), 0)) + 1, '\0');
  vsnprintf(&made[0], made.size(), text, again);
  made.pop_back();
  va_end(again);
  va_end(args);
  return made;
}
}  // namespace cv
