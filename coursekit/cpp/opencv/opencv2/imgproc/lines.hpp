// The pixels of a line, one after the other, and the part of it that an image has.
#pragma once
#include "opencv2/core.hpp"

namespace cv
{
/// Shorten a line to what is inside; false where nothing is.
inline bool clipLine(Rect inside, Point & from, Point & to)
{
  const auto answer = call("clipLine", inside, from, to);
  from = {static_cast<int>(answer[1][0].number()), static_cast<int>(answer[1][1].number())};
  to = {static_cast<int>(answer[2][0].number()), static_cast<int>(answer[2][1].number())};
  return answer[0].integer != 0;
}
inline bool clipLine(Size size, Point & from, Point & to) {return clipLine(Rect(Point(), size), from, to);}

/// Goes over the pixels that `line` draws with a thickness of 1: `count` of them, each at pos().
class LineIterator
{
public:
  int count = 0;
  LineIterator(const Mat & image, Point from, Point to, int connectivity = 8, bool from_left = false)
  : image_(image)
  {
    const Rect whole(Point(), image.size());
    if ((whole.contains(from) && whole.contains(to)) || clipLine(whole, from, to)) {
      begin(from, to, connectivity, from_left);
    }
  }
  Point pos() const {return at_;}
  uchar * operator*() const {return image_.ptr(at_.y) + static_cast<size_t>(at_.x) * image_.elemSize();}
  LineIterator & operator++()
  {
    const bool aside = error_ < 0;
    error_ += aside ? with_side_ : without_;
    at_ = at_ + (aside ? diagonal_ : straight_);
    return *this;
  }
  LineIterator operator++(int)
  {
    LineIterator before = *this;
    ++*this;
    return before;
  }

private:
  void begin(Point from, Point to, int connectivity, bool from_left)
  {
    if (from_left && to.x < from.x) {
      std::swap(from, to);
    }
    at_ = from;
    int length = std::abs(to.x - from.x), side = std::abs(to.y - from.y);
    Point along(to.x < from.x ? -1 : 1, 0), across(0, to.y < from.y ? -1 : 1);
    if (side > length) {
      std::swap(length, side);
      std::swap(along, across);
    }
    const bool eight = connectivity == 8;
    straight_ = along;
    diagonal_ = eight ? along + across : across;
    error_ = eight ? length - 2 * side : 0;
    without_ = -2 * side;
    with_side_ = eight ? 2 * (length - side) : 2 * length;
    count = 1 + length + (eight ? 0 : side);
  }
  mutable Mat image_;
  Point at_, straight_, diagonal_;
  int error_ = 0, without_ = 0, with_side_ = 0;
};
}  // namespace cv
